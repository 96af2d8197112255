#include "cleave/topology/carry_over.hpp"

#include <algorithm>
#include <cstddef>

namespace cleave::topology {

void carry_over_set(std::vector<VertexId>& vertices, const Relabelling& change) {
  const std::size_t members = vertices.size();
  for (const Split& split : change.splits)
    if (std::binary_search(vertices.begin(),
                           vertices.begin() + static_cast<std::ptrdiff_t>(members), split.parent))
      vertices.push_back(split.vertex);
  std::sort(vertices.begin(), vertices.end());
}

}  // namespace cleave::topology
