#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "cleave/topology/assemble.hpp"
#include "cleave/topology/facet_set.hpp"
#include "mesh.hpp"
#include "progress.hpp"

/// From what a file holds to a complex, and back to the file's own numbers.
namespace cleave::app {

/// The cells of `mesh`: vertices are places in mesh.points, no signs. Requires mesh.dimension == D.
template <int D>
topology::CellSoup<D> soup_of(const Mesh& mesh);

/// The same without a copy: valid as long as `mesh`.
template <int D>
topology::CellView<D> cells_of(const Mesh& mesh);

/// The cells of a file as a complex. Vertices below mesh->points.size() are places in mesh->points;
/// those from there on are the copies that regularisation made. Cells keep the file's order and
/// tuples; where the tuples are oriented differently, signs make up for it. The signs agree with
/// geometry: in each piece that has a volume (D = 3, or D = 2 in a plane z = constant), a cell's
/// orientation is the positive one unless the file has more inverted volume than upright.
template <int D>
struct Body {
  const Mesh* mesh = nullptr;  // must outlive the body
  topology::Complex<D> complex;
  std::vector<topology::Split> regularized;  // ascending; empty: the file was cut-regular

  /// The place in mesh->points of a vertex of `complex` as it was made.
  Index place(topology::VertexId vertex) const {
    const std::size_t original = mesh->points.size();
    return vertex.value < original ? vertex.value
                                   : regularized[vertex.value - original].parent.value;
  }

  /// The file's number of a vertex of `complex` as it was made; of a copy, its parent's.
  std::uint64_t number(topology::VertexId vertex) const {
    return mesh->vertex_numbers[place(vertex)];
  }
};

/// The body of `mesh` (mesh.dimension == D), coherently oriented and regularised. Throws
/// InputError, which names the cells by the file's numbers, if the mesh is no orientable
/// pseudo-manifold of distinct sound cells, has coordinates that are not finite, nodes of second
/// order that check_edge_nodes objects to, or cohesive elements, which belong to a cut made before.
/// Time: linear; `how_far` is told of it.
template <int D>
Body<D> make_body(const Mesh& mesh, const HowFar& how_far = {});

/// Whether the points of `mesh` lie in one plane z = constant, so that D = 2 has an orientation.
bool is_planar(const Mesh& mesh);

/// D coordinates per vertex of the body's complex, copies at their parent's place. Throws
/// InputError if D = 2 and the mesh is not planar (D = 1: the x coordinate).
template <int D>
std::vector<std::array<double, static_cast<std::size_t>(D)>> points_of(const Body<D>& body);

/// For each facet, given by D places in mesh.points in any order: its least half-facet. Works after
/// regularisation, since cells are compared by the file's tuples. Throws InputError for one that is
/// a facet of no cell, naming it by the file's numbers; `asked_by` says who asked for it in that
/// message ("group \"fault\"", "facets.json"). Time: linear in the cells and facets.
template <int D>
std::vector<topology::HalfFacetId> locate(const Mesh& mesh, std::span<const Index> facets,
                                          const std::string& asked_by);

template <int D>
std::vector<topology::HalfFacetId> locate(const Body<D>& body, std::span<const Index> facets,
                                          const std::string& asked_by) {
  return locate<D>(*body.mesh, facets, asked_by);
}

/// Of facets given by any of their half-facets, those that can be cut and the others.
struct SortedOut {
  topology::FacetSet interior;
  std::vector<topology::HalfFacetId> boundary;  // distinct, ascending
};
template <int D>
SortedOut sort_out(const topology::Complex<D>& k, std::span<const topology::HalfFacetId> facets);

/// The facet group of `mesh` with this name. Throws InputError that lists the facet groups there
/// are.
const Group& facet_group(const Mesh& mesh, const std::string& name);

/// The vertices of a group's elements: dimension+1 places in mesh.points per element.
std::vector<Index> vertices_of(const Mesh& mesh, const Group& group);

}  // namespace cleave::app
