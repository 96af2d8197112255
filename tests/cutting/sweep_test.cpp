#include "cleave/cutting/sweep.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>

namespace cleave::cutting {
namespace {

using Blade = std::vector<std::array<Point<3>, 2>>;
using Range = std::pair<std::size_t, std::size_t>;

TEST(Sweep, ABladeSpansTwoTrianglesPerPairOfPositions) {
  const Point<3> p0{0, 0, 0}, q0{0, 1, 0}, p1{1, 0, 0}, q1{1, 1, 0}, p2{2, 0, 1}, q2{2, 1, 1};
  const Sweep<3> sweep = sweep_of_blade(Blade{{{p0, q0}}, {{p1, q1}}, {{p2, q2}}});
  const std::vector<std::array<Point<3>, 3>> expected{
      {p0, q0, p1}, {q0, q1, p1}, {p1, q1, p2}, {q1, q2, p2}};
  EXPECT_EQ(sweep.simplices, expected);
  EXPECT_EQ(sweep.step_count(), 2u);
  EXPECT_EQ(sweep.step(0), Range(0, 2));
  EXPECT_EQ(sweep.step(1), Range(2, 4));
  EXPECT_EQ(sweep.step(2), Range(4, 4));
}

TEST(Sweep, APolylineHasOneStepPerSegment) {
  const std::vector<Point<2>> points{{0, 0}, {1, 0}, {1, 1}};
  const Sweep<2> sweep = sweep_of_polyline(points);
  EXPECT_EQ(sweep.simplices,
            (std::vector<std::array<Point<2>, 2>>{{points[0], points[1]}, {points[1], points[2]}}));
  EXPECT_EQ(sweep.step(1), Range(1, 2));
}

TEST(Sweep, FewerThanTwoPositionsSweepNothing) {
  EXPECT_EQ(sweep_of_blade({}).step_count(), 0u);
  EXPECT_EQ(sweep_of_blade(Blade{{{{0, 0, 0}, {1, 0, 0}}}}).step_count(), 0u);
  EXPECT_EQ(sweep_of_polyline(std::vector<Point<2>>{{1, 2}}).step_count(), 0u);
  EXPECT_EQ(Sweep<3>{}.step(0), Range(0, 0));
}

TEST(Sweep, AStepNumberMayBeLeftOut) {
  Sweep<2> sweep = sweep_of_polyline(std::vector<Point<2>>{{0, 0}, {1, 0}, {1, 1}});
  sweep.step_of = {1, 4};
  EXPECT_NO_THROW(require_valid(sweep));
  EXPECT_EQ(sweep.step_count(), 5u);
  EXPECT_EQ(sweep.step(0), Range(0, 0));
  EXPECT_EQ(sweep.step(2), Range(1, 1));
  EXPECT_EQ(sweep.step(4), Range(1, 2));
}

std::string complaint(const Sweep<2>& sweep) {
  try {
    require_valid(sweep);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "none";
}

TEST(Sweep, WhatIsWrongIsSaidWithTheSimplex) {
  const Sweep<2> good = sweep_of_polyline(std::vector<Point<2>>{{0, 0}, {1, 0}, {1, 1}});
  EXPECT_EQ(complaint(good), "none");
  Sweep<2> bad = good;
  bad.step_of = {0};
  EXPECT_EQ(complaint(bad), "sweep: 2 simplices, but steps for 1");
  bad.step_of = {1, 0};
  EXPECT_NE(complaint(bad).find("simplex 1 belongs to an earlier step"), std::string::npos);
  bad = good;
  bad.simplices[1][0][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(complaint(bad).find("simplex 1 has a coordinate that is not finite"),
            std::string::npos);
}

}  // namespace
}  // namespace cleave::cutting
