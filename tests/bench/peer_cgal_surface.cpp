#include "peer_cgal_surface.hpp"

#include "peers.hpp"

/// CGAL's Surface_mesh: half-edges in arrays.
namespace cleave::bench {
namespace {

class Surface : public PeerMesh {
 public:
  explicit Surface(const topology::CellSoup<2>& soup) : mesh_(surface_mesh(soup)) {}

  std::uint64_t visit_neighbours() override {
    std::uint64_t steps = 0;
    for (const auto face : mesh_.faces())
      for (const auto h : CGAL::halfedges_around_face(mesh_.halfedge(face), mesh_))
        steps += mesh_.face(mesh_.opposite(h)) != SurfaceMesh::null_face() ? 1 : 0;
    return steps;
  }

  std::uint64_t visit_stars() override {
    std::uint64_t visits = 0;
    for (const auto v : mesh_.vertices())
      for (const auto face : CGAL::faces_around_target(mesh_.halfedge(v), mesh_))
        visits += face != SurfaceMesh::null_face() ? 1 : 0;
    return visits;
  }

 private:
  SurfaceMesh mesh_;
};

const Registration kSurface(Assembler<2>{
    "CGAL_Surface_mesh",
    [](const topology::CellSoup<2>& soup) -> std::unique_ptr<PeerMesh> {
      return std::make_unique<Surface>(soup);
    },
    10'000'000, 10'000'000});

}  // namespace
}  // namespace cleave::bench
