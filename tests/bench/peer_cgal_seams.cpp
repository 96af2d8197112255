#include "peer_cgal_surface.hpp"  // first: Seam_mesh has to know it

#include <CGAL/Polygon_mesh_processing/clip.h>
#include <CGAL/boost/graph/Seam_mesh.h>

#include <stdexcept>

#include "median.hpp"
#include "peers.hpp"

/// CGAL's two ways to open a surface along edges. CGAL_split is what Polygon_mesh_processing::split
/// does once it has marked edges: it duplicates them and their vertices, after a pass over all
/// edges. CGAL_Seam_mesh is a view: it only marks edges, and whoever walks through it asks for the
/// marks.
namespace cleave::bench {
namespace {

namespace processing = CGAL::Polygon_mesh_processing;
using Marks = SurfaceMesh::Property_map<SurfaceMesh::Edge_index, bool>;

SurfaceMesh::Vertex_index vertex(topology::VertexId v) {
  return SurfaceMesh::Vertex_index(static_cast<SurfaceMesh::size_type>(v.value));
}

Split split_edges(const CutMesh<2>& mesh) {
  SurfaceMesh surface = surface_mesh(mesh.soup);
  const Marks marks = surface.add_property_map<SurfaceMesh::Edge_index, bool>("cut", false).first;
  for (const auto& edge : mesh.cut)
    put(marks, CGAL::edge(vertex(edge[0]), vertex(edge[1]), surface).first, true);
  processing::Corefinement::Default_visitor<SurfaceMesh> nobody;
  Split split;
  split.seconds = seconds(
      [&] { processing::internal::split_along_edges(surface, marks, surface.points(), nobody); });
  if (!CGAL::is_valid_polygon_mesh(surface)) throw std::logic_error("CGAL spoils its mesh");
  split.new_vertices = surface.number_of_vertices() - mesh.soup.vertex_count;
  return split;
}

Split mark_seams(const CutMesh<2>& mesh) {
  SurfaceMesh surface = surface_mesh(mesh.soup);
  using VertexMarks = SurfaceMesh::Property_map<SurfaceMesh::Vertex_index, bool>;
  const Marks edges = surface.add_property_map<SurfaceMesh::Edge_index, bool>("seam", false).first;
  const VertexMarks vertices =
      surface.add_property_map<SurfaceMesh::Vertex_index, bool>("on seam", false).first;
  CGAL::Seam_mesh<SurfaceMesh, Marks, VertexMarks> view(surface, edges, vertices);
  Split split;
  split.seconds = seconds([&] {
    for (const auto& edge : mesh.cut) view.add_seam(vertex(edge[0]), vertex(edge[1]));
  });
  split.new_vertices = num_vertices(view) - mesh.soup.vertex_count;
  return split;
}

const Registration kSplit(Splitter<2>{"CGAL_split", split_edges, 10'000'000, 10'000'000});
const Registration kSeams(Splitter<2>{"CGAL_Seam_mesh", mark_seams, 10'000'000, 10'000'000});

}  // namespace
}  // namespace cleave::bench
