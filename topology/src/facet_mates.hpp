#pragma once
#include <optional>
#include <vector>

#include "complex_access.hpp"

namespace cleave::topology::detail {

/// The two half-facets of a facet that is, was or will be interior.
struct FacetMates {
  HalfFacetId lesser, greater;
};

inline void join(std::vector<HalfFacetId>& mates, const FacetMates& facet) {
  mates[facet.lesser.value] = facet.greater;
  mates[facet.greater.value] = facet.lesser;
}

/// Each keeps the other as its former mate.
inline void sever(std::vector<HalfFacetId>& mates, const FacetMates& facet) {
  mates[facet.lesser.value].value = facet.greater.value | kSevered;
  mates[facet.greater.value].value = facet.lesser.value | kSevered;
}

/// The mate that a half-facet had until a cut opened its facet; none for others.
inline std::optional<HalfFacetId> former_mate(const std::vector<HalfFacetId>& mates,
                                              HalfFacetId h) {
  const HalfFacetId entry = mates[h.value];
  if (is_mate(entry) || entry.value == kNone) return std::nullopt;
  return HalfFacetId{entry.value & ~kSevered};
}

}  // namespace cleave::topology::detail
