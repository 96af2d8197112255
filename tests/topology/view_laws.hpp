#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "cleave/support/meshes.hpp"
#include "cleave/support/reference.hpp"
#include "cleave/topology/assemble.hpp"
#include "cleave/topology/complex.hpp"
#include "cleave/topology/facet_set.hpp"
#include "cleave/topology/relabelling.hpp"

/// What the tests of the read-only parts of topology share: complexes to look at, and what their
/// simplices and stars are by definition.
namespace cleave::views {

using namespace topology;  // NOLINT(google-build-using-namespace): these tests are about it

template <int D>
using Dimension = std::integral_constant<int, D>;

/// For typed tests: TypeParam::value is the dimension.
using Dimensions = ::testing::Types<Dimension<1>, Dimension<2>, Dimension<3>, Dimension<4>>;

/// A change that merges vertices 3 and 4 into 1, and 5 into 0.
inline Relabelling some_merges() {
  Relabelling change;
  change.vertices_before = 6;
  change.vertices_after = 3;
  change.merges = {{{3}, {1}}, {{4}, {1}}, {{5}, {0}}};
  return change;
}

/// The mesh, oriented, with pinched vertices split.
template <int D>
Complex<D> complex_of(const support::Mesh<D>& mesh) {
  const auto signs = support::coherent_signs<D>(mesh.cells);
  return assemble_regularized<D>({mesh.cells, mesh.vertex_count, signs.value()}).complex;
}

template <int D>
support::KuhnGrid<D> kuhn_cube(int nodes_per_axis) {
  typename support::KuhnGrid<D>::Point nodes{};
  nodes.fill(nodes_per_axis);
  return support::KuhnGrid<D>(nodes);
}

/// A dense cut of a grid: facets that open and facets that stay shut.
template <int D>
FacetSet dense_cut(const Complex<D>& k) {
  const FacetSet every = FacetSet::all(k);
  std::vector<HalfFacetId> facets;
  for (const HalfFacetId h : every.half_facets())
    if (static_cast<std::uint32_t>(h.value) * 2654435761u % 5 < 2) facets.push_back(h);
  return FacetSet::of_lesser(facets);
}

/// A ball, a sphere, a torus, two pieces side by side, and nothing.
template <int D>
std::vector<Complex<D>> sample_complexes() {
  const int nodes = D <= 2 ? 4 : D == 3 ? 3 : 2;
  return {
      complex_of<D>(kuhn_cube<D>(nodes)), complex_of(support::simplex_boundary<D>()),
      complex_of(support::torus<D>(3)),
      complex_of(support::disjoint_union(support::simplex<D>(), support::simplex_boundary<D>())),
      Complex<D>()};
}

using Vertices = std::vector<VertexId>;  // ascending

inline Vertices ascending(std::span<const VertexId> tuple) {
  Vertices sorted(tuple.begin(), tuple.end());
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

/// Every set of `size` vertices of some cell, with the cells that have it.
template <int D>
std::map<Vertices, std::vector<CellId>> simplices_by_definition(const Complex<D>& k,
                                                                std::size_t size) {
  std::map<Vertices, std::vector<CellId>> found;
  for (Index c = 0; c < k.cell_count(); ++c) {
    const Vertices cell = ascending(k.vertices({c}));
    std::vector<bool> chosen(cell.size());
    std::fill(chosen.end() - static_cast<std::ptrdiff_t>(size), chosen.end(), true);
    do {
      Vertices simplex;
      for (std::size_t i = 0; i < cell.size(); ++i)
        if (chosen[i]) simplex.push_back(cell[i]);
      found[simplex].push_back({c});
    } while (std::next_permutation(chosen.begin(), chosen.end()));
  }
  return found;
}

/// The vertices that two cells have in common.
template <int D>
Vertices common_vertices(const Complex<D>& k, CellId a, CellId b) {
  const Vertices one = ascending(k.vertices(a)), other = ascending(k.vertices(b));
  Vertices common;
  std::set_intersection(one.begin(), one.end(), other.begin(), other.end(),
                        std::back_inserter(common));
  return common;
}

}  // namespace cleave::views
