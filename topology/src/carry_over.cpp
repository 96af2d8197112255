#include "cleave/topology/carry_over.hpp"

#include <algorithm>
#include <cstddef>
#include <string>

namespace cleave::topology {

UnequalValues::UnequalValues(VertexId stays, VertexId goes)
    : std::invalid_argument("vertices " + std::to_string(stays.value) + " and " +
                            std::to_string(goes.value) +
                            " are to be merged, but their values differ"),
      kept(stays),
      gone(goes) {}

void detail::MergeGroups::fill(std::span<const Merge> merges) {
  by_kept_.assign(merges.begin(), merges.end());
  std::sort(by_kept_.begin(), by_kept_.end(), [](const Merge& a, const Merge& b) {
    return a.into != b.into ? a.into < b.into : a.vertex < b.vertex;
  });
  vertices_.clear();
  ends_.clear();
  for (auto merge = by_kept_.begin(); merge != by_kept_.end();) {
    const VertexId kept = merge->into;
    vertices_.push_back(kept);
    for (; merge != by_kept_.end() && merge->into == kept; ++merge)
      vertices_.push_back(merge->vertex);
    ends_.push_back(vertices_.size());
  }
}

void detail::require_value_each(std::size_t values, const Relabelling& change) {
  if (values != change.vertices_before)
    throw std::invalid_argument(std::to_string(values) + " values are given for " +
                                std::to_string(change.vertices_before) + " vertices");
}

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
