#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_3/tet_soup_to_c3t3.h>
#include <CGAL/Tetrahedral_remeshing/Remeshing_triangulation_3.h>

#include <map>

#include "peers.hpp"

/// How CGAL itself makes a triangulation of the tetrahedra of a file: with points, and with what
/// remeshing needs in vertices and cells. It refuses bodies with an edge where two parts of the
/// boundary touch.
namespace cleave::bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangulation = CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3<Kernel>;

class Loaded : public PeerMesh {
 public:
  /// Whether CGAL takes the cells.
  bool load(const topology::CellSoup<3>& soup) {
    const std::vector<Triangulation::Point> points(soup.vertex_count,
                                                   Triangulation::Point(0, 0, 0));
    std::vector<std::array<int, 5>> cells(soup.cells.size());
    for (std::size_t c = 0; c < cells.size(); ++c) {
      auto v = soup.cells[c];
      if (soup.signs[c] < 0) std::swap(v[2], v[3]);
      for (std::size_t i = 0; i < v.size(); ++i) cells[c][i] = static_cast<int>(v[i].value);
      cells[c][4] = 1;
    }
    const std::map<std::array<int, 3>, Triangulation::Cell::Surface_patch_index> no_borders;
    std::vector<Triangulation::Vertex_handle> vertices;
    // `true` leaves out a check of the whole that takes longer than the rest.
    return CGAL::build_triangulation<Triangulation, true>(triangulation_, points, cells, no_borders,
                                                          vertices);
  }

  std::uint64_t visit_neighbours() override { return 0; }
  std::uint64_t visit_stars() override { return 0; }

 private:
  Triangulation triangulation_;
};

const Registration kLoader(Assembler<3>{
    "CGAL_loader",
    [](const topology::CellSoup<3>& soup) -> std::unique_ptr<PeerMesh> {
      auto mesh = std::make_unique<Loaded>();
      if (!mesh->load(soup)) mesh.reset();
      return mesh;
    },
    1'000'000, 0});

}  // namespace
}  // namespace cleave::bench
