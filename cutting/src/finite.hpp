#pragma once
#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string>

#include "cleave/cutting/sweep.hpp"

namespace cleave::cutting::detail {

template <int D>
bool is_finite(const Point<D>& p) {
  return std::all_of(p.begin(), p.end(), [](double x) { return std::isfinite(x); });
}

/// Throws std::invalid_argument for a simplex with a coordinate that is not finite.
template <int D>
void require_finite(std::span<const std::array<Point<D>, static_cast<std::size_t>(D)>> simplices) {
  for (std::size_t i = 0; i < simplices.size(); ++i)
    if (!std::all_of(simplices[i].begin(), simplices[i].end(), is_finite<D>))
      throw std::invalid_argument("sweep: simplex " + std::to_string(i) +
                                  " has a coordinate that is not finite");
}

}  // namespace cleave::cutting::detail
