#pragma once
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "cleave/topology/complex.hpp"

namespace cleave::topology::detail {

inline constexpr Index kNone = kNoIndex;  // "no mate", "no corner"

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
  static CornerId& a_corner(Complex<D>& k, VertexId vertex) {
    const std::size_t made_with = k.a_corner_.size();
    return vertex.value < made_with ? k.a_corner_[vertex.value]
                                    : k.a_corner_of_copy_[vertex.value - made_with];
  }
  static void set_a_corner(Complex<D>& k, VertexId vertex, CornerId corner) {
    a_corner(k, vertex) = corner;
  }
  /// Adds copies, without corners yet, or takes the last ones away. Time: linear in the copies.
  static void resize_vertices(Complex<D>& k, std::size_t count) {
    k.a_corner_of_copy_.resize(count - k.a_corner_.size(), CornerId{kNone});
  }
  /// From now on facets that a cut has opened count as boundary from the start. Time: linear, if
  /// there are copies; else no facet is open.
  static void forget_former_mates(Complex<D>& k) {
    if (k.a_corner_of_copy_.empty()) return;
    for (HalfFacetId& entry : k.mates_)
      if (!is_mate(entry)) entry.value = kNone;
  }
  static const std::vector<Cell<D>>& cells(const Complex<D>& k) { return k.cells_; }
  static const std::vector<HalfFacetId>& mates(const Complex<D>& k) { return k.mates_; }
};

}  // namespace cleave::topology::detail
