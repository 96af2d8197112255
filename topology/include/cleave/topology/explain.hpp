#pragma once
#include <vector>

#include "cleave/topology/complex.hpp"
#include "cleave/topology/facet_set.hpp"

namespace cleave::topology {

/// Why `vertex` does not separate the two cells of a scored facet: a chain of cells around it, each
/// joined to the next through a facet that contains the vertex and is not scored.
struct Because {
  VertexId vertex;
  std::vector<CellId> through;  // first: the cell of the half-facet asked about, last: its mate's
};

/// Why a scored facet of `k` is shut: for each of its D vertices, in the order of k.facet(facet), a
/// shortest such chain. `k` is a complex after a cut (opened facets have lost their mates),
/// `scored` the scored facets that are shut, or more. Before the cut, the same call foretells it:
/// the facet will open exactly if some chain is empty, which says that its vertex separates the
/// cells (T3). Throws NotInterior if `facet` has no mate. Time: linear in the stars of the D
/// vertices, times the logarithm of the size of `scored`.
template <int D>
std::vector<Because> explain(const Complex<D>& k, const FacetSet& scored, HalfFacetId facet);

}  // namespace cleave::topology
