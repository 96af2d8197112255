#pragma once
#include <optional>
#include <span>
#include <vector>

#include "cleave/topology/ids.hpp"

namespace cleave::topology {

/// For each of `facets`, given by its vertices in any order: the least half-facet of `cells` with
/// these vertices, or none. Works on plain tuples, so that facets can be found by the numbers a
/// file gave them, before or after its vertices were split. Throws std::length_error if ids do not
/// suffice. Time: one pass over `cells` with a hash of `facets`.
template <int D>
std::vector<std::optional<HalfFacetId>> locate_facets(std::span<const Cell<D>> cells,
                                                      std::span<const Facet<D>> facets);

}  // namespace cleave::topology
