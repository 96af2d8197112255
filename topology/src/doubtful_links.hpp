#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "pinched_simplices.hpp"

namespace cleave::topology::detail {

/// Vertices of a 3-complex whose link a count does not show to be a sphere or a disk, ascending.
/// `a_corner`: of each vertex, kNone if no cell uses it; `irregular`: vertices whose star is not
/// one part, ascending; they are among the result.
///
/// Let a vertex whose star is one part have T cells around it, R boundary facets and N neighbours.
/// Its link is made of T triangles that are glued along edges, at most two at each: R edges with
/// one triangle, E = (3T + R) / 2 in all. Pull it apart where it hangs together in a vertex only:
/// what comes out is a connected surface with V vertices, so that V - E + T is at most 2 if R = 0
/// and at most 1 otherwise, with equality for the sphere and the disk and nothing else
/// (classification of surfaces). As V >= N, equality of N - E + T shows both that nothing had to be
/// pulled apart, so that no edge at the vertex is pinched, and that the link is a sphere or a disk.
///
/// N is counted from the edges and the cells in which they are met first, of which each edge has at
/// least one: a counting sort by the lesser vertex, and a stamp for each other vertex.
/// Time: linear; memory: 12 bytes per vertex, in mesh order 5 per cell.
inline std::vector<VertexId> doubtful_links(std::span<const Cell<3>> cells,
                                            const std::vector<HalfFacetId>& mates,
                                            const std::vector<CornerId>& a_corner,
                                            const std::vector<VertexId>& irregular) {
  const std::size_t vertex_count = a_corner.size();
  std::vector<Index> twice_euler(vertex_count, 0);  // 2 (N - E + T) = 2 N - T - R, modulo 2^bits
  std::vector<bool> has_rim(vertex_count, false);
  std::vector<Index> end(vertex_count + 1, 0);  // begin until filled
  for (Index c = 0; c < cells.size(); ++c) {
    for (const VertexId v : cells[c]) --twice_euler[v.value];
    for (std::size_t i = 0; i < 4; ++i) {
      if (is_mate(mates[std::size_t{4} * c + i])) continue;
      for (std::size_t j = 0; j < 4; ++j) {
        if (j == i) continue;
        --twice_euler[cells[c][j].value];
        has_rim[cells[c][j].value] = true;
      }
    }
  }
  for_each_first_met<2, 3>(cells, mates,
                           [&](const Simplex<2>& edge, CellId) { ++end[edge[0].value + 1]; });
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<VertexId> others(end.back());
  for_each_first_met<2, 3>(cells, mates, [&](const Simplex<2>& edge, CellId) {
    others[end[edge[0].value]++] = edge[1];
  });
  std::vector<Index> met_with(vertex_count, kNoIndex);
  for (Index v = 0, place = 0; v < vertex_count; ++v)
    for (; place < end[v]; ++place) {
      const VertexId other = others[place];
      const Index more = met_with[other.value] == v ? 0 : 2;
      met_with[other.value] = v;
      twice_euler[other.value] += more;
      twice_euler[v] += more;
    }
  std::vector<VertexId> doubtful;
  auto next_irregular = irregular.begin();
  for (Index v = 0; v < vertex_count; ++v) {
    const bool is_irregular = next_irregular != irregular.end() && next_irregular->value == v;
    if (is_irregular) ++next_irregular;
    const Index wanted = has_rim[v] ? 2 : 4;
    if (a_corner[v].value != kNone && (is_irregular || twice_euler[v] != wanted))
      doubtful.push_back(VertexId{v});
  }
  return doubtful;
}

}  // namespace cleave::topology::detail
