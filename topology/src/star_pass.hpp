#pragma once
#include <span>
#include <vector>

#include "parts.hpp"
#include "star_labels.hpp"

namespace cleave::topology::detail {

/// What the pass over all stars finds.
struct Stars {
  std::vector<CornerId> a_corner;   // the least corner at each vertex; kNone: no cell uses it
  std::vector<VertexPart> surplus;  // parts but the first of each star, by vertex, least corner
};

/// The parts of all stars. Time: linear; memory for D = 3 beyond the result: 2 bytes per cell and
/// 16 per vertex, and 1 bit per corner if there are several parts anywhere.
template <int D>
Stars star_pass(std::span<const Cell<D>> cells, const std::vector<HalfFacetId>& mates,
                std::size_t vertex_count) {
  Stars stars;
  std::vector<VertexId> suspects;
  {
    StarLabels<D> labels(cells, mates, vertex_count);
    labels.label_all();
    suspects = labels.suspects();
    stars.a_corner = labels.take_a_corner();
  }
  if (!suspects.empty()) stars.surplus = surplus_parts<D>(cells, mates, vertex_count, suspects);
  return stars;
}

}  // namespace cleave::topology::detail
