#pragma once
#include <optional>
#include <span>
#include <vector>

#include "cleave/topology/ids.hpp"
#include "complex_access.hpp"

namespace cleave::topology::detail {

/// The corner of `cell` at `vertex`, if it has one.
template <int D>
std::optional<CornerId> corner_at(std::span<const Cell<D>> cells, CellId cell, VertexId vertex) {
  for (int i = 0; i <= D; ++i)
    if (cells[cell.value][static_cast<std::size_t>(i)] == vertex) return half_facet<D>(cell, i);
  return std::nullopt;
}

/// Algorithm 5 driving step 2 of Algorithm 3: from corner `start` at `vertex` through the mates of
/// the facets that contain the vertex, as far as `enter(corner)` says that a corner is new (and
/// marks it). The corners reached are added to `part`, `start` first.
template <int D, class Enter>
void flood(std::span<const Cell<D>> cells, const std::vector<HalfFacetId>& mates, CornerId start,
           VertexId vertex, std::vector<CornerId>& part, Enter enter) {
  std::size_t next = part.size();
  part.push_back(start);
  enter(start);
  for (; next < part.size(); ++next) {
    const CellId cell = cell_of<D>(part[next]);
    for (int j = 0; j <= D; ++j) {
      if (j == local_index<D>(part[next])) continue;  // the facet opposite the vertex
      const HalfFacetId mate = mates[half_facet<D>(cell, j).value];
      if (!is_mate(mate)) continue;
      const auto across = corner_at<D>(cells, cell_of<D>(mate), vertex);
      if (!across) continue;
      part.push_back(*across);  // before it is marked, lest memory ends in between
      if (!enter(*across)) part.pop_back();
    }
  }
}

}  // namespace cleave::topology::detail
