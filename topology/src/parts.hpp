#pragma once
#include <algorithm>
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

/// The parts but the first of the stars of `vertices`, ascending by vertex, then by least corner.
/// Time: linear in the complex; memory: 1 bit per corner and per vertex.
template <int D>
std::vector<VertexPart> surplus_parts(std::span<const Cell<D>> cells,
                                      const std::vector<HalfFacetId>& mates,
                                      std::size_t vertex_count,
                                      const std::vector<VertexId>& vertices) {
  std::vector<bool> asked(vertex_count, false), met(vertex_count, false);
  for (const VertexId v : vertices) asked[v.value] = true;
  std::vector<VertexPart> surplus;
  std::vector<bool> seen(mates.size(), false);
  std::vector<CornerId> part;
  for (Index c = 0; c < cells.size(); ++c)
    for (int i = 0; i <= D; ++i) {
      const VertexId vertex = cells[c][static_cast<std::size_t>(i)];
      const CornerId least = half_facet<D>(CellId{c}, i);
      if (!asked[vertex.value] || seen[least.value]) continue;
      if (met[vertex.value]) surplus.push_back({vertex, least});
      met[vertex.value] = true;
      part.clear();
      flood<D>(cells, mates, least, vertex, part, [&](CornerId corner) {
        if (seen[corner.value]) return false;
        seen[corner.value] = true;
        return true;
      });
    }
  std::sort(surplus.begin(), surplus.end(), [](const VertexPart& a, const VertexPart& b) {
    return a.vertex != b.vertex ? a.vertex < b.vertex : a.least < b.least;
  });
  return surplus;
}

}  // namespace cleave::topology::detail
