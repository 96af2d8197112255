#include "cleave/topology/relabelling.hpp"

#include <algorithm>

namespace cleave::topology {

void Relabelling::clear(std::size_t vertices) {
  vertices_before = vertices_after = vertices;
  corners.clear();
  splits.clear();
  merges.clear();
  opened.clear();
  closed.clear();
  shut.clear();
}

VertexId Relabelling::parent(VertexId vertex) const {
  if (splits.empty() || vertex < splits.front().vertex) return vertex;
  const auto at = std::lower_bound(splits.begin(), splits.end(), vertex,
                                   [](const Split& s, VertexId v) { return s.vertex < v; });
  return at != splits.end() && at->vertex == vertex ? at->parent : vertex;
}

VertexId Relabelling::merged(VertexId vertex) const {
  if (merges.empty() || vertex < merges.front().vertex) return vertex;
  const auto at = std::lower_bound(merges.begin(), merges.end(), vertex,
                                   [](const Merge& m, VertexId v) { return m.vertex < v; });
  return at != merges.end() && at->vertex == vertex ? at->into : vertex;
}

Relabelling inverse(const Relabelling& change) {
  Relabelling back;
  back.vertices_before = change.vertices_after;
  back.vertices_after = change.vertices_before;
  back.corners.reserve(change.corners.size());
  for (const RenamedCorner& renamed : change.corners)
    back.corners.push_back({renamed.corner, renamed.to, renamed.from});
  back.splits.reserve(change.merges.size());
  for (const Merge& merge : change.merges) back.splits.push_back({merge.vertex, merge.into});
  back.merges.reserve(change.splits.size());
  for (const Split& split : change.splits) back.merges.push_back({split.vertex, split.parent});
  back.opened = change.closed;
  back.closed = change.opened;
  return back;
}

}  // namespace cleave::topology
