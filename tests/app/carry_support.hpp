#pragma once
#include <string>
#include <vector>

#include "cleave/support/cuts.hpp"
#include "cleave/support/random_meshes.hpp"
#include "cut_output.hpp"

/// Meshes with everything that a cut has to carry, and what came of them.
namespace cleave::app::test {

/// The cells as a file may hold them, vertices numbered 10, 13, 16, .. , at random points.
template <int D>
Mesh mesh_of(const support::Mesh<D>& cells, support::Rng& rng);

/// A Kuhn grid with its points at the integers, every cell's tuple in random order.
template <int D>
Mesh grid_mesh(const support::KuhnGrid<D>& grid, support::Rng& rng);

/// Adds an element for each of these facets, its tuple in random order, and a group of them.
template <int D>
void add_facets(Mesh& mesh, const std::string& name,
                const std::vector<topology::HalfFacetId>& facets, support::Rng& rng);

/// Gives every element one node per edge, and all points, vertices and nodes, new random places.
void add_nodes(Mesh& mesh, support::Rng& rng);

/// A field that says of each point which place it has.
void add_places(Mesh& mesh);

/// The request to cut along a group of the file.
template <int D>
NamedFacets along(const Body<D>& body, const std::string& name);

/// A mesh and its cut.
template <int D>
struct CutMesh {
  Body<D> body;
  topology::Incision<D> incision;
  CutOutput output;
};
template <int D>
CutMesh<D> cut(const Mesh& mesh, const std::vector<std::string>& groups,
               const std::vector<topology::HalfFacetId>& others = {},
               Numbering numbering = Numbering::kept);

/// The group of this name; none: an empty one.
Group group(const Mesh& mesh, const std::string& name);

}  // namespace cleave::app::test
