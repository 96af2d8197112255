#pragma once
#include <array>

#include "cleave/cutting/sweep.hpp"

namespace cleave::cutting {

/// The sign (+1, 0, -1) of det(b-a, c-a): +1 if a, b, c turn counter-clockwise. Exact on the finite
/// doubles given, from the least denormal to the largest number: a filter in doubles decides what
/// its error bound allows, integer arithmetic the rest. Time: some nanoseconds; microseconds if the
/// points are in line or nearly so.
int orient2d(const Point<2>& a, const Point<2>& b, const Point<2>& c);

/// The sign of det(b-a, c-a, d-a): +1 if (a, b, c) turn counter-clockwise seen from d. Exact as
/// above.
int orient3d(const Point<3>& a, const Point<3>& b, const Point<3>& c, const Point<3>& d);

/// An axis-parallel box, closed.
template <int D>
struct Box {
  Point<D> low, high;
};

/// One simplex of a sweep and all signs that a selection rule asks for. For side and crossing it
/// counts as translated by (e, e^2) or (e, e^2, e^3), e -> 0+, so that there is no zero left and
/// simplices with a common ridge leave no gap and no overlap; only flat ones, which have no
/// direction, must be skipped. Every sign is exact on finite doubles.
template <int D>
class SweptSimplex {
  static_assert(D == 2 || D == 3);

 public:
  explicit SweptSimplex(const std::array<Point<D>, static_cast<std::size_t>(D)>& corners);

  /// Two ends at one place (D = 2), a triangle without area (D = 3). It covers nothing.
  bool is_flat() const { return normal_sign_ == 0; }

  /// The side of the translated line or plane that `p` is on: +1 if orient(corners.., p) would be
  /// positive, else -1. 0 only for a flat simplex.
  int side(const Point<D>& p) const;

  /// Whether the segment pq crosses the translated simplex, for p and q on different sides of it.
  bool crossed_between_sides(const Point<D>& p, const Point<D>& q) const;

  /// Whether the segment pq crosses the translated simplex, which is not flat.
  bool crossed_by(const Point<D>& p, const Point<D>& q) const {
    return side(p) != side(q) && crossed_between_sides(p, q);
  }

  /// For p and q on different sides: the sign of |height of p| - |height of q| over the line or
  /// plane where it really is, not translated: -1 if p is closer to where pq meets it, 0 if the
  /// middle of pq is there.
  int compare_heights(const Point<D>& p, const Point<D>& q) const;

  /// False only if no segment in `box` can cross the simplex. Quick, and false for nearly every box
  /// beyond the bounding box or on one side of the simplex.
  bool may_meet(const Box<D>& box) const;

 private:
  std::array<Point<D>, static_cast<std::size_t>(D)> corners_;
  int normal_sign_;  // of the first component of the normal that is not 0
  Box<D> box_;
  Point<D> normal_{}, normal_size_{};  // in doubles; the latter bounds the terms of the former
};

}  // namespace cleave::cutting
