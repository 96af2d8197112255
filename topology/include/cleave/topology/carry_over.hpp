#pragma once
#include <stdexcept>
#include <string>
#include <vector>

#include "cleave/topology/relabelling.hpp"

namespace cleave::topology {

/// Extends data held per vertex after a cut: each new vertex gets the value of its parent.
/// `per_vertex` has change.vertices_before entries and gets change.vertices_after; throws
/// std::invalid_argument if it has another number of them. Data on cells and half-facets needs
/// nothing, since their numbers never change. Time: linear in the copies (amortised, as the vector
/// grows).
template <class T>
void carry_over(std::vector<T>& per_vertex, const Relabelling& change) {
  if (per_vertex.size() != change.vertices_before)
    throw std::invalid_argument(std::to_string(per_vertex.size()) + " values are given for " +
                                std::to_string(change.vertices_before) + " vertices");
  per_vertex.resize(change.vertices_after);
  for (const Split& split : change.splits)
    per_vertex[split.vertex.value] = per_vertex[split.parent.value];
}

/// Extends a set of vertices, sorted ascending, by all copies of its members.
void carry_over_set(std::vector<VertexId>& vertices, const Relabelling& change);

}  // namespace cleave::topology
