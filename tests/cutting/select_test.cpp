#include "cleave/cutting/select.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cleave/support/reference.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "bodies.hpp"
#include "cleave/cutting/predicates.hpp"
#include "cleave/topology/pieces.hpp"
#include "cleave/topology/unglue.hpp"

namespace cleave::cutting {
namespace {

using bodies::Body;

constexpr SelectOptions kDualEdge{Rule::dual_edge, Ties::by_id};
constexpr SelectOptions kNearest{Rule::nearest_vertex, Ties::by_id};
constexpr SelectOptions kNearestBoth{Rule::nearest_vertex, Ties::both};

template <int D>
topology::FacetSet chosen(const Body<D>& body, const Sweep<D>& sweep, SelectOptions options) {
  return Selector<D>(body.k, body.points, options).select(sweep.simplices);
}

template <int D>
std::size_t pieces_after(const Body<D>& body, const topology::FacetSet& cut) {
  topology::Complex<D> k = body.k;
  topology::unglue(k, cut);
  return topology::pieces(k).count;
}

/// A cell whose vertices lie at these heights above the plane z = 0, and that plane.
template <std::size_t N>
std::array<bool, 4> set_of(const std::array<double, N>& heights, Ties ties) {
  const std::array<Point<3>, 4> places{
      {{0, 0, heights[0]}, {1, 0, heights[1]}, {0, 1, heights[2]}, {1, 1, heights[3]}}};
  const std::vector<std::array<Point<3>, 3>> plane{{{{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}}}};
  return nearest_vertices<3>({{{0}, {1}, {2}, {3}}}, places, plane, ties);
}

// Lemma 1 of the paper says that four vertices are selected only if all are equally far.
TEST(NearestVertex, HeightsThatRefuteLemma1SelectFourUnlessTiesGoById) {
  for (const std::array<double, 4>& heights :
       {std::array{1.0, 0.5, -1.0, -0.5}, std::array{1.0, -1.0, -0.5, -0.5}}) {
    const auto both = set_of(heights, Ties::both), by_id = set_of(heights, Ties::by_id);
    EXPECT_EQ(std::count(both.begin(), both.end(), true), 4);
    EXPECT_EQ(std::count(by_id.begin(), by_id.end(), true), 3);
  }
  EXPECT_EQ(set_of(std::array{1.0, 0.5, -1.0, -0.5}, Ties::by_id),
            (std::array{true, true, false, true}));
}

// Even a fold of general position gives a set of four: the lemma says nothing of several planes.
TEST(NearestVertex, AFoldSelectsFourWithoutAnyTie) {
  const std::array<Point<3>, 4> places{{{0, 0, 1}, {1, 0, 0.5}, {0, 1, -0.7}, {1, 1, -0.6}}};
  const std::vector<std::array<Point<3>, 3>> fold{{{{-9, -9, 0.2}, {9, -9, 0.2}, {0, 9, 0.2}}},
                                                  {{{-9, -9, -0.2}, {9, -9, -0.2}, {0, 9, -0.2}}}};
  const auto set = nearest_vertices<3>({{{0}, {1}, {2}, {3}}}, places, fold, Ties::by_id);
  EXPECT_EQ(std::count(set.begin(), set.end(), true), 4);
}

// A sweep that ends in a cell may enter through a face and meet no edge. Then the set is empty, and
// yet the sweep intersects the cell.
TEST(NearestVertex, ASweepThatEntersThroughAFaceSelectsNothing) {
  const std::array<Point<3>, 4> places{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}}};
  const Point<3> tip{1, 1, 1};
  const std::vector<std::array<Point<3>, 3>> blade{{{{1, 1, -1}, {2, 1, -1}, tip}}};
  const int inside = orient3d(places[0], places[1], places[2], places[3]);
  for (std::size_t i = 0; i < 4; ++i) {
    auto with_tip = places;
    with_tip[i] = tip;
    EXPECT_EQ(orient3d(with_tip[0], with_tip[1], with_tip[2], with_tip[3]), inside);
  }
  for (const Ties ties : {Ties::both, Ties::by_id})
    EXPECT_EQ(nearest_vertices<3>({{{0}, {1}, {2}, {3}}}, places, blade, ties),
              (std::array<bool, 4>{}));
}

// The proof of Lemma 1 knows three places of a plane: all vertices on one side of it, one parted
// from three, or two from two. Here it leaves one above, two below, and goes through the fourth.
TEST(NearestVertex, APlaneThroughAVertexSelectsThatVertex) {
  for (const Ties ties : {Ties::both, Ties::by_id})
    EXPECT_EQ(set_of(std::array{0.0, 3.0, -1.0, -2.0}, ties),
              (std::array{true, false, true, true}));
}

TEST(NearestVertex, APlaneNearAGridPlaneSelectsThatGridPlane) {
  const Body<3> body = bodies::kuhn<3>({5, 5, 5}, 1);
  const auto cut = chosen(body, bodies::aligned_plane<3>(body, {1, 0, 0}, 2.2), kNearest);
  EXPECT_EQ(cut.size(), 32u);  // two triangles in each of 4 x 4 squares
  for (const topology::HalfFacetId h : cut.half_facets())
    for (const topology::VertexId v : body.k.facet(h)) EXPECT_EQ(body.points[v.value][0], 2);
}

TEST(NearestVertex, APathNearAGridLineSelectsThatLine) {
  const Body<2> body = bodies::kuhn<2>({7, 4}, 1);
  const auto cut = chosen(body, bodies::aligned_plane<2>(body, {1, 0}, 3.3), kNearest);
  EXPECT_EQ(cut.size(), 3u);
  for (const topology::HalfFacetId h : cut.half_facets())
    for (const topology::VertexId v : body.k.facet(h)) EXPECT_EQ(body.points[v.value][0], 3);
}

// The uniform cube, cut in the middle between two grid planes: all of the paper's ties at once. In
// units where all coordinates are exact, its rule then selects nothing.
TEST(NearestVertex, OnTiesThePapersTextSelectsNothingAndIdsDecide) {
  const Body<3> body = bodies::kuhn<3>({5, 5, 5}, 1);
  const Sweep<3> middle = bodies::aligned_plane<3>(body, {1, 0, 0}, 1.5);
  EXPECT_TRUE(chosen(body, middle, kNearestBoth).empty());
  const auto cut = chosen(body, middle, kNearest);
  EXPECT_EQ(cut.size(), 32u);
  EXPECT_EQ(pieces_after(body, cut), 2u);
}

TEST(DualEdge, AGridPlaneIsSelectedItself) {
  const Body<3> body = bodies::kuhn<3>({5, 5, 5}, 0.1);
  const auto cut = chosen(body, bodies::aligned_plane<3>(body, {0, 1, 0}, 3), kDualEdge);
  EXPECT_EQ(cut.size(), 32u);
  EXPECT_EQ(pieces_after(body, cut), 2u);
}

// Half way between two grid planes the dual points lie on both sides, so the cut zigzags.
TEST(DualEdge, BetweenGridPlanesTheCutZigzags) {
  const Body<3> body = bodies::kuhn<3>({5, 5, 5}, 1);
  const Sweep<3> middle = bodies::aligned_plane<3>(body, {1, 0, 0}, 1.5);
  const auto cut = chosen(body, middle, kDualEdge);
  EXPECT_GT(cut.size(), chosen(body, middle, kNearest).size());
  EXPECT_EQ(pieces_after(body, cut), 2u);
}

// Theorem B says even, not two.
TEST(DualEdge, FourChosenFacetsMayMeetInARidge) {
  bodies::Rng rng(4);
  bool found = false;
  for (int run = 0; run < 10; ++run) {
    const Body<3> body = bodies::jittered<3>({7, 7, 7}, 1, 0.2, rng);
    const auto cut = chosen(body, bodies::full_crossing(body, rng), kDualEdge);
    const std::vector<topology::HalfFacetId> facets(cut.half_facets().begin(),
                                                    cut.half_facets().end());
    for (const auto& [ridge, degree] : support::ridge_degrees<3>(body.k.cells(), facets))
      found = found || degree == 4;
  }
  EXPECT_TRUE(found);
}

/// Eight squares (cubes) around a hole, so 16 triangles or 48 tetrahedra.
template <int D>
Body<D> ring() {
  std::array<int, static_cast<std::size_t>(D)> nodes{4, 4};
  if constexpr (D == 3) nodes[2] = 2;
  const Body<D> body = bodies::kuhn<D>(nodes, 1);
  std::vector<bool> keep;
  for (const Point<D>& p : bodies::duals(body))
    keep.push_back(std::max(std::abs(p[0] - 1.5), std::abs(p[1] - 1.5)) > 0.5);
  return bodies::part(body, keep);
}

/// What the blade covers on its straight way; in space it stands upright and reaches beyond the
/// body.
template <int D>
Sweep<D> straight(std::array<double, 2> from, std::array<double, 2> to) {
  if constexpr (D == 2)
    return sweep_of_polyline(std::vector<Point<2>>{from, to});
  else
    return sweep_of_blade(
        std::vector<std::array<Point<3>, 2>>{{{{from[0], from[1], -1}, {from[0], from[1], 2}}},
                                             {{{to[0], to[1], -1}, {to[0], to[1], 2}}}});
}

/// The rim of the sweep is outside the body, in part in its hole: what it chooses opens, but it is
/// not all facets between two sets of cells. The next cut across parts the ring.
template <int D>
void a_full_crossing_of_a_ring_opens_it_without_parting_it() {
  const Body<D> body = ring<D>();
  const auto first = chosen(body, straight<D>({1.5, 1.5}, {1.4, -1}), kDualEdge);
  const auto second = chosen(body, straight<D>({1.5, 1.5}, {1.4, 4}), kDualEdge);
  EXPECT_FALSE(first.empty());
  topology::Complex<D> k = body.k;
  const topology::Relabelling change = topology::unglue(k, first);
  EXPECT_EQ(change.opened.size(), first.size());
  EXPECT_EQ(topology::pieces(k).count, 1u);
  topology::unglue(k, second);
  EXPECT_EQ(topology::pieces(k).count, 2u);
}

TEST(TheoremB, AFullCrossingOfARingOpensItWithoutPartingIt) {
  a_full_crossing_of_a_ring_opens_it_without_parting_it<2>();
}
TEST(TheoremB, AFullCrossingOfASolidRingOpensItWithoutPartingIt) {
  a_full_crossing_of_a_ring_opens_it_without_parting_it<3>();
}

// A cut closer to the surface than any dual point is beyond the rule; so is a blade that passes
// between all dual edges.
TEST(DualEdge, ASweepBetweenAllDualEdgesSelectsNothing) {
  const Body<3> body = bodies::kuhn<3>({4, 4, 4}, 1);
  EXPECT_TRUE(chosen(body, bodies::aligned_plane<3>(body, {1, 0, 0}, 0.2), kDualEdge).empty());
  const Sweep<3> speck = sweep_of_blade(std::vector<std::array<Point<3>, 2>>{
      {{{1.01, 1.02, 1.01}, {1.02, 1.01, 1.01}}}, {{{1.01, 1.02, 1.03}, {1.02, 1.03, 1.01}}}});
  EXPECT_TRUE(chosen(body, speck, kDualEdge).empty());
}

// One step that goes there and back crosses every dual edge twice.
TEST(DualEdge, AStepThatComesBackSelectsNothing) {
  const Body<3> body = bodies::kuhn<3>({4, 4, 4}, 1);
  const Sweep<3> sweep = bodies::aligned_plane<3>(body, {1, 0, 0}, 1.5);
  EXPECT_FALSE(chosen(body, sweep, kDualEdge).empty());
  EXPECT_TRUE(chosen(body, bodies::there_and_back(sweep), kDualEdge).empty());
}

TEST(DualEdge, TheDualPointIsTheCentroidAndDoesNotOverflow) {
  const Body<2> plane = bodies::kuhn<2>({2, 2}, 3);
  for (const topology::Index c : {0u, 1u}) {
    const Point<2> p = dual_point(plane.k, plane.points, topology::CellId{c});
    EXPECT_EQ(std::max(p[0], p[1]), 2);
    EXPECT_EQ(std::min(p[0], p[1]), 1);
  }
  const Body<3> vast = bodies::kuhn<3>({2, 2, 2}, 1.5e308);
  for (topology::Index c = 0; c < 6; ++c)
    for (const double x : dual_point(vast.k, vast.points, topology::CellId{c}))
      EXPECT_TRUE(std::isfinite(x));
}

TEST(Selector, ASweepThatMissesSelectsNothing) {
  const Body<3> body = bodies::kuhn<3>({4, 4, 4}, 1);
  const Body<2> plane = bodies::kuhn<2>({4, 4}, 1);
  for (const SelectOptions options : {kDualEdge, kNearest, kNearestBoth}) {
    for (const double beside : {-1.0, 3.5, 40.0}) {
      EXPECT_TRUE(chosen(body, bodies::aligned_plane<3>(body, {0, 0, 1}, beside), options).empty());
      EXPECT_TRUE(chosen(plane, bodies::aligned_plane<2>(plane, {0, 1}, beside), options).empty());
    }
    EXPECT_TRUE(chosen(body, Sweep<3>{}, options).empty());
    EXPECT_TRUE(chosen(Body<3>{}, bodies::aligned_plane<3>(body, {0, 0, 1}, 1), options).empty());
  }
}

TEST(Selector, FlatSimplicesSelectNothing) {
  const Body<3> body = bodies::kuhn<3>({4, 4, 4}, 1);
  Sweep<3> flat;
  flat.simplices = {{{{0, 0, 0}, {3, 3, 3}, {3, 3, 3}}}, {{{0, 1, 1}, {1, 1, 1}, {3, 1, 1}}}};
  flat.step_of = {0, 0};
  for (const SelectOptions options : {kDualEdge, kNearest, kNearestBoth})
    EXPECT_TRUE(chosen(body, flat, options).empty());
}

// Whatever the unit: powers of two change no sign, and the least and largest ones need the exact
// way.
TEST(Selector, ScaleDoesNotMatter) {
  const Body<3> body = bodies::kuhn<3>({4, 4, 4}, 0.1);
  const Sweep<3> sweep = bodies::aligned_plane<3>(body, {1, 1, 0}, 2.5);
  for (const SelectOptions options : {kDualEdge, kNearest, kNearestBoth}) {
    const auto expected = chosen(body, sweep, options);
    EXPECT_FALSE(expected.empty());
    for (const int exponent : {-1000, -400, 400, 1000}) {
      Body<3> scaled_body = body;
      Sweep<3> scaled = sweep;
      for (Point<3>& p : scaled_body.points)
        for (double& x : p) x = std::ldexp(x, exponent);
      for (auto& simplex : scaled.simplices)
        for (Point<3>& p : simplex)
          for (double& x : p) x = std::ldexp(x, exponent);
      EXPECT_EQ(chosen(scaled_body, scaled, options), expected) << exponent;
    }
  }
}

TEST(Selector, RefusesCoordinatesThatAreNotFinite) {
  const Body<3> body = bodies::kuhn<3>({3, 3, 3}, 1);
  const Sweep<3> good = bodies::aligned_plane<3>(body, {1, 0, 0}, 1);
  const Selector<3> selector(body.k, body.points);
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity()}) {
    Sweep<3> sweep = good;
    sweep.simplices[3][1][2] = bad;
    EXPECT_THROW(selector.select(sweep.simplices), std::invalid_argument);
    EXPECT_THROW(selector.select_step(sweep, 1), std::invalid_argument);
    Body<3> body_with = body;
    body_with.points[5][1] = bad;
    EXPECT_THROW(Selector<3>(body_with.k, body_with.points), std::invalid_argument);
  }
}

TEST(Selector, RefusesPointsThatDoNotFitTheComplex) {
  Body<2> body = bodies::kuhn<2>({3, 3}, 1);
  body.points.pop_back();
  EXPECT_THROW(Selector<2>(body.k, body.points), std::invalid_argument);
}

TEST(Selector, StepsAreSelectedOneByOne) {
  const Body<2> body = bodies::kuhn<2>({7, 4}, 1);
  const Sweep<2> path = bodies::aligned_plane<2>(body, {1, 0}, 3);
  const Selector<2> selector(body.k, body.points, kDualEdge);
  const auto lower = selector.select_step(path, 0), upper = selector.select_step(path, 1);
  EXPECT_FALSE(lower.empty());
  EXPECT_FALSE(upper.empty());
  EXPECT_EQ(lower ^ upper, selector.select(path.simplices));
  EXPECT_TRUE(selector.select_step(path, 2).empty());
}

}  // namespace
}  // namespace cleave::cutting
