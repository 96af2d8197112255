#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "flood.hpp"

namespace cleave::topology::detail {

/// A facet-connected part of the star of a vertex, named by its least corner.
struct VertexPart {
  VertexId vertex;
  CornerId least;
};

/// All parts of all vertex stars, ascending by least corner. Time: linear; memory: 1 bit per
/// corner.
template <int D>
std::vector<VertexPart> vertex_parts(std::span<const Cell<D>> cells,
                                     const std::vector<HalfFacetId>& mates) {
  std::vector<VertexPart> parts;
  std::vector<bool> seen(mates.size(), false);
  std::vector<CornerId> part;
  for (Index c = 0; c < mates.size(); ++c) {
    if (seen[c]) continue;
    const VertexId vertex = cells[c / (D + 1)][c % (D + 1)];
    parts.push_back({vertex, CornerId{c}});
    part.clear();
    flood<D>(cells, mates, CornerId{c}, vertex, part, [&](CornerId corner) {
      if (seen[corner.value]) return false;
      seen[corner.value] = true;
      return true;
    });
  }
  return parts;
}

}  // namespace cleave::topology::detail
