#pragma once
#include <span>

#include "cleave/topology/complex.hpp"
#include "cleave/topology/facet_set.hpp"
#include "cleave/topology/violation.hpp"

/// Fix-its: which further facets to cut so that a wish comes true. They are offered; nothing here
/// changes a complex. As in explain, `k` is a complex after a cut and `scored` the scored facets
/// that are shut, or a complex before a cut and all facets to be scored; the answer is to be cut
/// together with them, as Incision::cut does.
namespace cleave::topology {

/// A smallest set of interior facets of `k`, none of `scored`, that opens `facet` when it is scored
/// as well: empty if `facet` opens without. Exact: a facet opens iff some vertex of it separates
/// its cells (T3), so the set is a minimum cut between the two cells in the dual graph of the star
/// of one of the D vertices. Of the vertices with equally small cuts the one that gives the
/// lexicographically least set counts; at a vertex the cut nearest to the cell of the lesser
/// half-facet. So the answer does not depend on which half-facet is named. Throws NotInterior if
/// `facet` has no mate. Time: for each vertex, its star times the size of its cut.
template <int D>
FacetSet separating_facets(const Complex<D>& k, const FacetSet& scored, HalfFacetId facet);

/// The same for several facets together: a set that opens all of `facets`. A heuristic: the facets
/// are opened one after the other, ascending, each by a smallest set given those before; then every
/// facet that is needed by none of them is left out again, so that no proper subset of the answer
/// will do that lacks one facet. For one facet it is the smallest set. Time: as for each facet, and
/// twice that for each facet of the answer and the facets near it.
template <int D>
FacetSet separating_facets(const Complex<D>& k, const FacetSet& scored,
                           std::span<const HalfFacetId> facets);

/// Further facets to cut so that the complex reaches `level`; empty if it does so after cutting
/// `scored` alone. up to cut_regular: always empty (T4). edge_regular: the parts around each
/// pinched simplex are separated at the vertex of it where that takes fewest facets, by a minimum
/// cut of its star. manifold: besides, the link of each bad vertex is divided into disks, triangle
/// by triangle. Both are repeated until the level is reached, which ends, since every round splits
/// a vertex; the answer is not the smallest in general. Throws std::invalid_argument for manifold
/// if D = 4, where it is not decided. Time: rounds, each linear in `k`; memory: a copy of `k`.
template <int D>
FacetSet facets_to_reach(const Complex<D>& k, const FacetSet& scored, Level level);

}  // namespace cleave::topology
