#include "cleave/topology/carry_over.hpp"

#include <algorithm>
#include <cstddef>

namespace cleave::topology {

UnequalValues::UnequalValues(VertexId stays, VertexId goes)
    : std::invalid_argument("vertices " + std::to_string(stays.value) + " and " +
                            std::to_string(goes.value) +
                            " are to be merged, but their values differ"),
      kept(stays),
      gone(goes) {}

void carry_over_set(std::vector<VertexId>& vertices, const Relabelling& change) {
  if (!change.merges.empty()) {
    for (VertexId& v : vertices) v = change.merged(v);
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  }
  const std::size_t members = vertices.size();
  for (const Split& split : change.splits)
    if (std::binary_search(vertices.begin(),
                           vertices.begin() + static_cast<std::ptrdiff_t>(members), split.parent))
      vertices.push_back(split.vertex);
  std::sort(vertices.begin(), vertices.end());
}

}  // namespace cleave::topology
