#include "cleave/topology/relabelling.hpp"

#include <algorithm>

namespace cleave::topology {

VertexId Relabelling::parent(VertexId vertex) const {
  const auto at = std::lower_bound(splits.begin(), splits.end(), vertex,
                                   [](const Split& s, VertexId v) { return s.vertex < v; });
  return at != splits.end() && at->vertex == vertex ? at->parent : vertex;
}

}  // namespace cleave::topology
