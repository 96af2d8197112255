#pragma once
#include <utility>
#include <vector>

#include "cleave/topology/incision.hpp"
#include "facet_mates.hpp"
#include "vertex_unions.hpp"

namespace cleave::topology::detail {

/// What the calls of an incision work with and use again.
template <int D>
struct IncisionMemory {
  std::vector<HalfFacetId> asked;  // by which a step changes the scored set
  FacetSet cut, shut;
  VertexUnions unions;
  std::vector<FacetMates> taken_back, others;  // facets that a stitch closes, or may close
  std::vector<CornerId> corners;
};

/// Fills `set` again, in the memory it has: fill(half_facets) adds lesser half-facets to an empty
/// vector. If it throws, the set is empty.
template <class Fill>
void refill(FacetSet& set, Fill fill) {
  std::vector<HalfFacetId> half_facets = std::move(set).half_facets();
  half_facets.clear();
  fill(half_facets);
  set = FacetSet::of_lesser(std::move(half_facets));
}

}  // namespace cleave::topology::detail
