#pragma once
#include <array>
#include <cstddef>

#include "facet_bucket.hpp"

namespace cleave::topology::detail {

/// The two least vertices of a cell, the least first.
template <int D>
std::array<PlacedVertex, 2> two_least(const Cell<D>& cell) {
  PlacedVertex least = placed(cell[0], 0), second = placed(cell[1], 1);
  put_in_order(least, second);
  for (std::size_t i = 2; i <= D; ++i) {
    PlacedVertex other = placed(cell[i], i);
    put_in_order(second, other);
    put_in_order(least, second);
  }
  return {least, second};
}

}  // namespace cleave::topology::detail
