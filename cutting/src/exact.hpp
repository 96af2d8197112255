#pragma once
#include <array>

#include "cleave/cutting/sweep.hpp"

namespace cleave::cutting::detail {

/// A row of a determinant: (to - from) + (also_to - also_from).
template <int D>
struct Row {
  Point<D> to, from;
  Point<D> also_to{}, also_from{};
};

/// The sign of the determinant of these rows, in integers: doubles are integers times a power of
/// two. Right for all finite doubles. Time: about a microsecond for coordinates of like size.
template <int D>
int exact_determinant_sign(const std::array<Row<D>, static_cast<std::size_t>(D)>& rows);

}  // namespace cleave::cutting::detail
