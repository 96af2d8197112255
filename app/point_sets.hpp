#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "mesh.hpp"

namespace cleave::app {

/// Of the points at `places` (ascending, finite) those that lie together: sets of two or more that
/// are equal, or joined by steps of at most `distance`; each ascending, the sets by their first.
/// Time: O(n log n) for distance 0 and for one that is not much larger than the spacing.
std::vector<std::vector<Index>> close_points(const std::vector<std::array<double, 3>>& points,
                                             const std::vector<Index>& places, double distance);

}  // namespace cleave::app
