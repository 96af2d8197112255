#pragma once
#include <vector>

#include "cleave/topology/relabelling.hpp"

namespace cleave::topology {

/// Extends data held per vertex after a cut: each new vertex gets the value of its parent.
/// `per_vertex` has change.vertices_before entries and gets change.vertices_after. Data on cells
/// and half-facets needs nothing, since their numbers never change. Time: linear in the copies.
template <class T>
void carry_over(std::vector<T>& per_vertex, const Relabelling& change) {
  per_vertex.resize(change.vertices_after);
  for (const Split& split : change.splits)
    per_vertex[split.vertex.value] = per_vertex[split.parent.value];
}

/// Extends a set of vertices, sorted ascending, by all copies of its members.
void carry_over_set(std::vector<VertexId>& vertices, const Relabelling& change);

}  // namespace cleave::topology
