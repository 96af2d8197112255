#pragma once
#include <cstddef>

namespace cleave::app {

/// Where CohesiveElements::vertices has the k-th of `count` nodes of an element in VTK's order, and
/// the other way round: a wedge starts with the triangle whose normal points out of it, which the
/// minus side's points into; a quadrangle goes around.
constexpr std::size_t vtk_cohesive_node(std::size_t count, std::size_t k) {
  constexpr std::size_t kWedge[] = {0, 2, 1, 3, 5, 4}, kQuadrangle[] = {0, 1, 3, 2};
  return count == 6 ? kWedge[k] : kQuadrangle[k];
}

}  // namespace cleave::app
