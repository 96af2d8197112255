#pragma once
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "cleave/topology/incision.hpp"
#include "facet_mates.hpp"
#include "prefetch.hpp"
#include "unglue_scratch.hpp"
#include "vertex_unions.hpp"

namespace cleave::topology::detail {

/// What the calls of an incision work with and use again.
template <int D>
struct IncisionMemory {
  /// A corner that a flood has reached, and the half-facet of its cell through which it came; the
  /// corner itself, where the flood began.
  struct Reached {
    CornerId corner;
    HalfFacetId through;
  };

  std::vector<HalfFacetId> asked;  // by which a step changes the scored set
  FacetSet cut, shut;
  UnglueScratch unglue;
  VertexUnions unions;
  std::vector<FacetMates> taken_back;  // facets that a stitch closes
  std::vector<HalfFacetId> others;     // facets that it may close
  std::vector<Reached> reached;
  std::vector<CornerId> corners, spare;
};

/// Fills `selected` with the half-facets that `wanted` says; asks for their mates ahead.
template <class Wanted>
void select(std::span<const HalfFacetId> half_facets, const std::vector<HalfFacetId>& mates,
            std::vector<HalfFacetId>& selected, Wanted wanted) {
  constexpr std::size_t kAhead = 16;
  selected.resize(half_facets.size());
  std::size_t count = 0;
  for (std::size_t n = 0; n < half_facets.size(); ++n) {
    if (n + kAhead < half_facets.size()) prefetch(mates.data() + half_facets[n + kAhead].value);
    if (wanted(half_facets[n])) selected[count++] = half_facets[n];
  }
  selected.resize(count);
}

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
