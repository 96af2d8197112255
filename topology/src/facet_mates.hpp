#pragma once
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

inline void sever(std::vector<HalfFacetId>& mates, const FacetMates& facet) {
  mates[facet.lesser.value] = mates[facet.greater.value] = HalfFacetId{kNone};
}

}  // namespace cleave::topology::detail
