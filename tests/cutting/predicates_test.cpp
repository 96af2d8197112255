#include "cleave/cutting/predicates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "properties.hpp"
#include "rational.hpp"

namespace cleave::cutting {
namespace {

using support::Rng;

constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kLeast = std::numeric_limits<double>::denorm_min();

enum class Points { anywhere, grid, integers, nearly_flat, extreme, scaled_grid };
constexpr int kKinds = 6;

double extreme(Rng& rng) {
  switch (rng.below(8)) {
    case 0:
      return 0;
    case 1:
      return rng.chance(0.5) ? kLargest : -kLargest;
    case 2:
      return kLeast * rng.between(-3, 3);
    default:
      return (2 * rng.unit() - 1) * std::pow(10.0, rng.between(-300, 300));
  }
}

double coordinate(Points kind, double scale, Rng& rng) {
  switch (kind) {
    case Points::grid:
      return 0.1 * rng.between(-2, 2);
    case Points::scaled_grid:
      return scale * (0.1 * rng.between(-2, 2));
    case Points::integers:
      return rng.between(-2, 2);
    case Points::extreme:
      return extreme(rng);
    default:
      return 2 * rng.unit() - 1;
  }
}

/// p, moved by a few units in the last place.
template <int D>
Point<D> nudged(Point<D> p, Rng& rng) {
  for (double& x : p)
    for (int n = rng.between(-2, 2); n != 0; n += n < 0 ? 1 : -1)
      x = std::nextafter(x, n < 0 ? -kLargest : kLargest);
  return p;
}

/// N points of one kind; of the nearly flat ones, all but the first D are within a few roundings of
/// the line or plane of those.
template <int D, std::size_t N>
std::array<Point<D>, N> any_points(Points kind, Rng& rng) {
  const double scale = std::pow(10.0, rng.between(-307, 307));
  std::array<Point<D>, N> points;
  for (Point<D>& p : points)
    for (double& x : p) x = coordinate(kind, scale, rng);
  if (kind != Points::nearly_flat) return points;
  for (std::size_t i = D; i < N; ++i) {
    const double s = 2 * rng.unit() - 1, t = D == 2 ? 0 : 2 * rng.unit() - 1;
    for (std::size_t j = 0; j < static_cast<std::size_t>(D); ++j)
      points[i][j] =
          points[0][j] + s * (points[1][j] - points[0][j]) + t * (points[D - 1][j] - points[0][j]);
    points[i] = nudged<D>(points[i], rng);
  }
  return points;
}

template <int D, std::size_t N>
std::array<Point<D>, N> any_points(Rng& rng) {
  return any_points<D, N>(static_cast<Points>(rng.below(kKinds)), rng);
}

int orient(const std::array<Point<2>, 3>& p) { return orient2d(p[0], p[1], p[2]); }
int orient(const std::array<Point<3>, 4>& p) { return orient3d(p[0], p[1], p[2], p[3]); }

template <int D>
void orientations_agree() {
  Rng rng = any_rng();
  for (int i = 0; i < 30; ++i) {
    const auto points = any_points<D, D + 1>(rng);
    RC_ASSERT(orient(points) == rational::orient<D>(points));
  }
}

RC_GTEST_PROP(PredicatesProperty, Orient2dAgreesWithRationals, ()) { orientations_agree<2>(); }
RC_GTEST_PROP(PredicatesProperty, Orient3dAgreesWithRationals, ()) { orientations_agree<3>(); }

/// Everything a swept simplex answers about a segment.
template <int D>
void segment_agrees(const std::array<Point<D>, static_cast<std::size_t>(D) + 2>& points) {
  rational::Simplex<D> corners;
  std::copy_n(points.begin(), D, corners.begin());
  const Point<D>&p = points[D], &q = points[D + 1];
  const SweptSimplex<D> simplex(corners);
  RC_ASSERT(simplex.is_flat() == rational::is_flat<D>(corners));
  RC_ASSERT(simplex.side(p) == rational::side<D>(corners, p));
  RC_ASSERT(simplex.side(q) == rational::side<D>(corners, q));
  if (simplex.is_flat()) return;
  RC_ASSERT(simplex.side(p) != 0);
  const bool crossed = rational::crosses<D>(corners, p, q);
  RC_ASSERT(simplex.crossed_by(p, q) == crossed);
  RC_ASSERT(simplex.crossed_by(q, p) == crossed);
  if (simplex.side(p) != simplex.side(q)) {
    RC_ASSERT(simplex.compare_heights(p, q) == rational::compare_heights<D>(corners, p, q));
    RC_ASSERT(simplex.compare_heights(q, p) == -simplex.compare_heights(p, q));
  }
  Box<D> box{p, p};
  for (std::size_t i = 0; i < q.size(); ++i) {
    box.low[i] = std::min(p[i], q[i]);
    box.high[i] = std::max(p[i], q[i]);
  }
  if (crossed) RC_ASSERT(simplex.may_meet(box));
}

RC_GTEST_PROP(PredicatesProperty, SegmentsAgreeWithSeriesInThePlane, ()) {
  Rng rng = any_rng();
  for (int i = 0; i < 20; ++i) segment_agrees<2>(any_points<2, 4>(rng));
}

RC_GTEST_PROP(PredicatesProperty, SegmentsAgreeWithSeriesInSpace, ()) {
  Rng rng = any_rng();
  for (int i = 0; i < 10; ++i) segment_agrees<3>(any_points<3, 5>(rng));
}

// The properties above mean something only if their inputs hit the cases that matter.
TEST(Predicates, InputsOfThePropertiesHitZerosAndCrossings) {
  for (const Points kind : {Points::grid, Points::integers, Points::scaled_grid}) {
    Rng rng(7);
    int zero = 0, crossed = 0, flat = 0, ties = 0;
    for (int i = 0; i < 400; ++i) {
      zero += orient(any_points<3, 4>(kind, rng)) == 0;
      const auto p = any_points<3, 5>(kind, rng);
      const SweptSimplex<3> simplex({p[0], p[1], p[2]});
      flat += simplex.is_flat();
      if (simplex.is_flat() || simplex.side(p[3]) == simplex.side(p[4])) continue;
      crossed += simplex.crossed_by(p[3], p[4]);
      ties += simplex.compare_heights(p[3], p[4]) == 0;
    }
    EXPECT_GT(zero, 20);
    EXPECT_GT(crossed, 10);
    EXPECT_GT(flat, 2);
    EXPECT_GT(ties, 3);
  }
}

TEST(Predicates, SignsOfPlainTriangleAndTetrahedron) {
  EXPECT_EQ(orient2d({0, 0}, {1, 0}, {0, 1}), 1);
  EXPECT_EQ(orient2d({0, 0}, {0, 1}, {1, 0}), -1);
  EXPECT_EQ(orient2d({0, 0}, {1, 1}, {2, 2}), 0);
  EXPECT_EQ(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1);
  EXPECT_EQ(orient3d({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}), -1);
}

TEST(Predicates, ProductsThatUnderflowOrOverflowKeepTheirSign) {
  for (const double s : {kLeast, 1e-300, 1e-200, 1e-110, 1e110, 1e160, 1e300, kLargest}) {
    EXPECT_EQ(orient2d({0, 0}, {s, 0}, {0, s}), 1) << s;
    EXPECT_EQ(orient2d({0, 0}, {0, s}, {s, 0}), -1) << s;
    EXPECT_EQ(orient3d({0, 0, 0}, {s, 0, 0}, {0, s, 0}, {0, 0, s}), 1) << s;
    EXPECT_EQ(orient3d({0, 0, 0}, {0, s, 0}, {s, 0, 0}, {0, 0, s}), -1) << s;
    EXPECT_EQ(orient3d({0, 0, 0}, {s, 0, 0}, {0, s, 0}, {s, s, 0}), 0) << s;
  }
  EXPECT_EQ(orient3d({0, 0, 0}, {1e300, 0, 0}, {0, 1e300, 0}, {0, 0, 1e-300}), 1);
  EXPECT_EQ(orient2d({-kLargest, -kLargest}, {kLargest, kLargest}, {kLeast, 0}), -1);
}

// 0.1 + 0.2 is not 0.3 in doubles: the point is off the diagonal by one unit in the last place.
TEST(Predicates, OneUnitInTheLastPlaceIsSeen) {
  const double x = 0.1 + 0.2;
  EXPECT_EQ(orient2d({0, 0}, {1, 1}, {0.3, 0.3}), 0);
  EXPECT_EQ(orient2d({0, 0}, {1, 1}, {0.3, x}), 1);
  EXPECT_EQ(orient2d({0, 0}, {1, 1}, {x, 0.3}), -1);
}

// The sweep at x = 0 counts as moved by e towards +x, so a point with x = 0 is on its lower side.
TEST(Predicates, AZeroIsDecidedAsIfTheSweepHadMoved) {
  const SweptSimplex<3> facing_x({{{0, 0, 0}, {0, 1, 0}, {0, 0, 1}}});  // normal (1, 0, 0)
  EXPECT_EQ(facing_x.side({0, 5, 5}), -1);
  const SweptSimplex<3> facing_back({{{0, 0, 0}, {0, 0, 1}, {0, 1, 0}}});
  EXPECT_EQ(facing_back.side({0, 5, 5}), 1);
  const SweptSimplex<2> upward({{{0, 0}, {1, 0}}});  // normal (0, 1)
  EXPECT_EQ(upward.side({7, 0}), -1);
  EXPECT_TRUE(facing_x.crossed_by({0, 0.25, 0.25}, {1, 0.25, 0.25}));
  EXPECT_FALSE(facing_x.crossed_by({0, 0.25, 0.25}, {-1, 0.25, 0.25}));
}

// Four triangles around a common corner: a segment through that corner crosses exactly one.
TEST(Predicates, TrianglesWithACommonCornerLeaveNoGapAndNoOverlap) {
  const std::array<Point<3>, 4> ring{{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}};
  for (const Point<3>& from : {Point<3>{0, 0, -1}, Point<3>{0.5, 0, -1}, Point<3>{0.5, 0.5, -1}}) {
    int crossings = 0;
    for (std::size_t i = 0; i < 4; ++i)
      crossings += SweptSimplex<3>({{{0, 0, 0}, ring[i], ring[(i + 1) % 4]}})
                       .crossed_by(from, {-from[0], -from[1], -from[2]});
    EXPECT_EQ(crossings, 1);
  }
}

}  // namespace
}  // namespace cleave::cutting
