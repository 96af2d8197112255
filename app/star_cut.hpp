#pragma once
#include <vector>

#include "cleave/topology/complex.hpp"
#include "cleave/topology/facet_set.hpp"

namespace cleave::app {

/// A smallest set of interior facets of `k`, none of `scored`, that together with these separates
/// the cells `from` from the cells `to`, all of them around `vertex`, in its star (T3): lesser
/// half-facets, ascending; of several such sets the one nearest to `from`. Empty if they are
/// separated already, or cannot be, a cell being in both. Time: the star times the size of the set.
template <int D>
std::vector<topology::HalfFacetId> star_cut(const topology::Complex<D>& k,
                                            const topology::FacetSet& scored,
                                            topology::VertexId vertex,
                                            const std::vector<topology::CellId>& from,
                                            const std::vector<topology::CellId>& to);

}  // namespace cleave::app
