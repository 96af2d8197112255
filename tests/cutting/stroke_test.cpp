#include "cleave/cutting/stroke.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "bodies.hpp"
#include "cleave/support/heap.hpp"
#include "cleave/topology/check.hpp"
#include "cleave/topology/pieces.hpp"

namespace cleave::cutting {
namespace {

using bodies::Body;
using topology::FacetSet;
using topology::Incision;

constexpr SelectOptions kDualEdge{Rule::dual_edge, Ties::by_id};
constexpr SelectOptions kNearest{Rule::nearest_vertex, Ties::by_id};

/// The plane x = `x` (of a body of spacing 1), cut by a blade along y in `steps` steps from y = -1
/// to y = `until`.
Sweep<3> saw(double x, double until, int steps) {
  std::vector<std::array<Point<3>, 2>> positions;
  for (int i = 0; i <= steps; ++i) {
    const double y = -1 + (until + 1) * i / steps;
    positions.push_back({{{x, y, -1}, {x, y, 9}}});
  }
  return sweep_of_blade(positions);
}

TEST(Stroke, ASawThatGoesThroughSeparatesInTwo) {
  for (const SelectOptions options : {kDualEdge, kNearest}) {
    Body<3> body = bodies::kuhn<3>({7, 7, 7}, 1);
    Incision<3> incision(body.k);
    const StrokeResult result = cut_along(incision, body.points, saw(3, 9, 7), options);
    EXPECT_EQ(result.scored.size(), 72u);
    EXPECT_EQ(incision.opened().size(), 72u);
    EXPECT_TRUE(incision.shut().empty());
    EXPECT_EQ(incision.complex().vertex_count(), 343u + 49u);  // the vertices of the plane
    EXPECT_EQ(topology::pieces(incision.complex()).count, 2u);
    // The last two of the 7 steps are behind the body; nearest_vertex waits for whole cells.
    EXPECT_EQ(result.changes.size(), options.rule == Rule::dual_edge ? 5u : 4u);
    for (topology::Index v = 343; v < 392; ++v)
      EXPECT_EQ(body.points[v], body.points[incision.original({v}).value]);
  }
}

TEST(Stroke, APathInThePlaneSeparatesASheet) {
  for (const SelectOptions options : {kDualEdge, kNearest}) {
    Body<2> body = bodies::kuhn<2>({7, 5}, 1);
    Incision<2> incision(body.k);
    const std::vector<Point<2>> path{{3.1, -1}, {3.1, 1.5}, {3.1, 2.5}, {3.1, 6}};
    const StrokeResult result = cut_along(incision, body.points, sweep_of_polyline(path), options);
    EXPECT_EQ(result.scored.size(), 4u);
    EXPECT_TRUE(incision.shut().empty());
    EXPECT_EQ(topology::pieces(incision.complex()).count, 2u);
  }
}

// Drawn back along its path in the same stroke, the blade leaves the cut it made and adds nothing.
TEST(Stroke, ABladeDrawnBackLeavesTheCutAndAddsNothing) {
  for (const double until : {2.6, 3.0, 3.4}) {
    Body<3> body = bodies::kuhn<3>({7, 7, 7}, 1);
    Incision<3> there(body.k), both(body.k);
    std::vector<Point<3>> points = body.points;
    const Sweep<3> sweep = saw(3, until, 4);
    cut_along(there, points, sweep);
    EXPECT_FALSE(there.opened().empty());
    cut_along(both, body.points, bodies::there_and_back(sweep));
    EXPECT_TRUE(std::ranges::equal(both.opened(), there.opened()));
    EXPECT_EQ(both.complex().vertex_count(), there.complex().vertex_count());
  }
}

// Facets that no vertex separates are shut. The blade that goes back over them takes them back.
TEST(Stroke, ShutFacetsToggleAndOpenedOnesAreFrozen) {
  Body<3> body = bodies::kuhn<3>({7, 7, 7}, 1);
  Incision<3> incision(body.k);
  // A patch of the plane x = 3 that covers four squares, so that its middle vertex alone could
  // separate anything, and does: its 6 facets open, the two in the corners stay shut.
  const std::vector<std::array<Point<3>, 2>> window{{{{3, 1.9, 1.9}, {3, 1.9, 4.1}}},
                                                    {{{3, 4.1, 1.9}, {3, 4.1, 4.1}}}};
  const Sweep<3> sweep = sweep_of_blade(window);
  const StrokeResult once = cut_along(incision, body.points, sweep);
  EXPECT_EQ(once.scored.size(), 8u);
  EXPECT_EQ(incision.opened().size(), 6u);
  EXPECT_EQ(incision.shut().size(), 2u);

  Incision<3> again(body.k);
  body.points.resize(343);
  const StrokeResult twice = cut_along(again, body.points, bodies::there_and_back(sweep));
  EXPECT_EQ(twice.changes.size(), 2u);
  EXPECT_EQ(again.opened().size(), 6u);
  EXPECT_TRUE(again.shut().empty());
  EXPECT_EQ(twice.scored.size(), 6u);
}

// What another stroke left shut stays scored, even if this stroke passes over it twice.
TEST(Stroke, WhatOtherStrokesLeftShutStaysScored) {
  Body<3> body = bodies::kuhn<3>({7, 7, 7}, 1);
  Incision<3> incision(body.k);
  const Sweep<3> window = sweep_of_blade(std::vector<std::array<Point<3>, 2>>{
      {{{3, 1.9, 1.9}, {3, 1.9, 3.1}}}, {{{3, 3.1, 1.9}, {3, 3.1, 3.1}}}});  // one square
  cut_along(incision, body.points, window);
  const FacetSet shut = incision.shut();
  ASSERT_EQ(shut.size(), 2u);
  const StrokeResult passing = cut_along(incision, body.points, bodies::there_and_back(window));
  EXPECT_EQ(incision.shut(), shut);
  EXPECT_TRUE(passing.scored.empty());
  const StrokeResult once = cut_along(incision, body.points, window);
  EXPECT_EQ(incision.shut(), shut);
  EXPECT_EQ(once.scored, shut);

  // The rest of the plane releases them; they open, though this stroke did not choose them alone.
  cut_along(incision, body.points, saw(3, 9, 3));
  EXPECT_TRUE(incision.shut().empty());
  EXPECT_EQ(incision.opened().size(), 72u);
}

TEST(Stroke, ASweepThatMissesChangesNothing) {
  Body<3> body = bodies::kuhn<3>({4, 4, 4}, 1);
  Incision<3> incision(body.k);
  for (const Sweep<3>& sweep : {Sweep<3>{}, saw(-5, 9, 3)}) {
    const StrokeResult result = cut_along(incision, body.points, sweep);
    EXPECT_TRUE(result.changes.empty());
    EXPECT_TRUE(result.scored.empty());
  }
  EXPECT_EQ(incision.complex().vertex_count(), 64u);
  EXPECT_EQ(body.points.size(), 64u);
}

// Wherever memory ends, the points fit the complex, and the stroke can be made again.
TEST(Stroke, PointsFollowTheIncisionEvenWhenMemoryEnds) {
  const Body<2> body = bodies::kuhn<2>({4, 4}, 1);
  const Sweep<2> across = sweep_of_polyline(
      std::vector<Point<2>>{{-1, 1.4}, {0.6, 1.4}, {1.6, 1.6}, {2.4, 1.6}, {4, 1.4}});
  Incision<2> incision(body.k);
  std::vector<Point<2>> points = body.points;
  std::size_t partly_cut = 0;
  support::run_out_of_memory(
      [&] {
        incision = Incision<2>(body.k);
        points = body.points;
        cut_along(incision, points, across);
      },
      [&] {
        ASSERT_EQ(points.size(), incision.complex().vertex_count());
        for (topology::Index v = 0; v < points.size(); ++v)
          ASSERT_EQ(points[v], body.points[incision.original({v}).value]);
        if (points.size() == body.points.size()) return;
        ++partly_cut;
        cut_along(incision, points, across);
        EXPECT_GE(topology::pieces(incision.complex()).count, 2u);
      });
  EXPECT_GT(partly_cut, 10u);
  EXPECT_EQ(topology::pieces(incision.complex()).count, 2u);
}

// The last step is bad, and still nothing has been cut.
TEST(Stroke, ABadSweepChangesNothing) {
  Body<3> body = bodies::kuhn<3>({4, 4, 4}, 1);
  Incision<3> incision(body.k);
  Sweep<3> bad = saw(1, 9, 3), disordered = bad, lacking = bad;
  bad.simplices.back()[0][1] = std::numeric_limits<double>::infinity();
  disordered.step_of.back() = 0;
  lacking.step_of.pop_back();
  for (const Sweep<3>& sweep : {bad, disordered, lacking})
    EXPECT_THROW(cut_along(incision, body.points, sweep), std::invalid_argument);
  std::vector<Point<3>> few(3);
  EXPECT_THROW(cut_along(incision, few, saw(1, 9, 3)), std::invalid_argument);
  EXPECT_TRUE(incision.scored().empty());
  EXPECT_EQ(incision.complex().vertex_count(), 64u);
}

// Two strokes that meet: each goes halfway, from opposite sides, and together they separate.
TEST(Stroke, TwoStrokesThatOverlapSeparate) {
  Body<3> body = bodies::kuhn<3>({7, 7, 7}, 1);
  Incision<3> incision(body.k);
  cut_along(incision, body.points, saw(3, 3.4, 3));
  EXPECT_EQ(topology::pieces(incision.complex()).count, 1u);
  Sweep<3> from_behind = saw(3, 4.4, 3);
  for (auto& triangle : from_behind.simplices)
    for (Point<3>& p : triangle) p[1] = 6 - p[1];
  cut_along(incision, body.points, from_behind);
  EXPECT_EQ(topology::pieces(incision.complex()).count, 2u);
}

}  // namespace
}  // namespace cleave::cutting
