#pragma once
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "cleave/topology/complex.hpp"

namespace cleave::topology::detail {

inline constexpr std::uint32_t kNone = UINT32_MAX;  // "no mate", "no corner"

/// The one door to the inside of a Complex, for what builds or changes it.
template <int D>
struct ComplexAccess {
  static Complex<D> make(std::vector<Cell<D>> cells, std::vector<HalfFacetId> mates,
                         std::vector<bool> reversed, std::vector<CornerId> a_corner) {
    Complex<D> k;
    k.cells_ = std::move(cells);
    k.mates_ = std::move(mates);
    k.reversed_ = std::move(reversed);
    k.a_corner_ = std::move(a_corner);
    return k;
  }
  static std::vector<Cell<D>>& cells(Complex<D>& k) { return k.cells_; }
  static std::vector<HalfFacetId>& mates(Complex<D>& k) { return k.mates_; }
  static std::vector<CornerId>& a_corner(Complex<D>& k) { return k.a_corner_; }
  static const std::vector<Cell<D>>& cells(const Complex<D>& k) { return k.cells_; }
  static const std::vector<HalfFacetId>& mates(const Complex<D>& k) { return k.mates_; }
};

}  // namespace cleave::topology::detail
