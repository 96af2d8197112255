#include <algorithm>
#include <cleave/support/reference.hpp>
#include <map>
#include <optional>
#include <set>

#include "bodies.hpp"
#include "cleave/cutting/predicates.hpp"
#include "cleave/cutting/select.hpp"
#include "cleave/topology/pieces.hpp"
#include "cleave/topology/unglue.hpp"
#include "properties.hpp"
#include "rational.hpp"
#include "rim.hpp"

namespace cleave::cutting {
namespace {

using bodies::Body;
using bodies::Rng;
using topology::CellId;
using topology::FacetSet;
using topology::HalfFacetId;
using topology::VertexId;

std::vector<HalfFacetId> list(const FacetSet& set) {
  return {set.half_facets().begin(), set.half_facets().end()};
}

template <int D>
void dual_edge_agrees() {
  Rng rng = any_rng();
  const Body<D> body = bodies::any_small<D>(rng);
  const Sweep<D> sweep = bodies::any_sweep(body, rng);
  const Selector<D> selector(body.k, body.points, {Rule::dual_edge, Ties::by_id});
  const auto expected =
      rational::dual_edge<D>(body.k.cells(), bodies::duals(body), sweep.simplices);
  RC_CLASSIFY(expected.empty(), "nothing chosen");
  RC_ASSERT(list(selector.select(sweep.simplices)) == expected);
}

RC_GTEST_PROP(SelectProperty, DualEdgeAgreesWithBruteForceInThePlane, ()) { dual_edge_agrees<2>(); }
RC_GTEST_PROP(SelectProperty, DualEdgeAgreesWithBruteForceInSpace, ()) { dual_edge_agrees<3>(); }

template <int D>
void nearest_vertex_agrees() {
  Rng rng = any_rng();
  const Body<D> body = bodies::any_small<D>(rng);
  const Sweep<D> sweep = bodies::any_sweep(body, rng);
  const Ties ties = rng.chance(0.5) ? Ties::by_id : Ties::both;
  const Selector<D> selector(body.k, body.points, {Rule::nearest_vertex, ties});
  const auto ends = rational::closest_ends<D>(body.k.cells(), body.points, sweep.simplices, ties);
  const auto expected = rational::nearest_vertex<D>(body.k.cells(), ends);
  RC_CLASSIFY(expected.empty(), "nothing chosen");
  RC_ASSERT(list(selector.select(sweep.simplices)) == expected);
}

RC_GTEST_PROP(SelectProperty, NearestVertexAgreesWithBruteForceInThePlane, ()) {
  nearest_vertex_agrees<2>();
}
RC_GTEST_PROP(SelectProperty, NearestVertexAgreesWithBruteForceInSpace, ()) {
  nearest_vertex_agrees<3>();
}

/// Every aligned plane (line), at full and half steps of a grid with exact and with rounded
/// coordinates, against rational numbers; returns how often facets were chosen, and how often ties
/// mattered.
template <int D>
std::pair<int, int> aligned_sweeps_agree(int nodes_per_axis) {
  std::array<int, static_cast<std::size_t>(D)> nodes, normal;
  nodes.fill(nodes_per_axis);
  int chosen = 0, ties_mattered = 0;
  const int span = nodes_per_axis - 1;
  for (const double spacing : {1.0, 0.1}) {
    const Body<D> body = bodies::kuhn<D>(nodes, spacing);
    const auto points = bodies::duals(body);
    for (int code = (D == 2 ? 9 : 27) / 2 + 1; code < (D == 2 ? 9 : 27); ++code) {
      int rest = code, low = 0, high = 0;  // each normal up to its sign
      for (int& n : normal) {
        n = rest % 3 - 1;
        rest /= 3;
        low += std::min(n, 0) * span;
        high += std::max(n, 0) * span;
      }
      for (double offset = low; offset <= high; offset += 0.5) {
        const Sweep<D> sweep = bodies::aligned_plane<D>(body, normal, offset);
        const auto by_dual_edge = Selector<D>(body.k, body.points).select(sweep.simplices);
        EXPECT_EQ(list(by_dual_edge),
                  rational::dual_edge<D>(body.k.cells(), points, sweep.simplices));
        std::vector<HalfFacetId> of_ties[2];
        for (const Ties ties : {Ties::by_id, Ties::both}) {
          const Selector<D> selector(body.k, body.points, {Rule::nearest_vertex, ties});
          auto& found = of_ties[ties == Ties::both ? 1 : 0];
          found = list(selector.select(sweep.simplices));
          const auto ends =
              rational::closest_ends<D>(body.k.cells(), body.points, sweep.simplices, ties);
          EXPECT_EQ(found, rational::nearest_vertex<D>(body.k.cells(), ends));
        }
        chosen += by_dual_edge.empty() ? 0 : 1;
        ties_mattered += of_ties[0] != of_ties[1] ? 1 : 0;
      }
    }
  }
  return {chosen, ties_mattered};
}

TEST(SelectProperty, AlignedSweepsAgreeWithBruteForceInThePlane) {
  const auto [chosen, ties_mattered] = aligned_sweeps_agree<2>(5);
  EXPECT_GE(chosen, 60);
  EXPECT_GE(ties_mattered, 10);
}
TEST(SelectProperty, AlignedSweepsAgreeWithBruteForceInSpace) {
  const auto [chosen, ties_mattered] = aligned_sweeps_agree<3>(3);
  EXPECT_GE(chosen, 60);
  EXPECT_GE(ties_mattered, 10);
}

/// A larger body; exact answers are not compared there, only what theorems promise.
template <int D>
Body<D> any_body(Rng& rng) {
  std::array<int, static_cast<std::size_t>(D)> nodes;
  for (int& n : nodes) n = rng.between(D == 2 ? 5 : 4, D == 2 ? 12 : 6);
  return rng.chance(0.5) ? bodies::kuhn<D>(nodes, 0.1) : bodies::jittered<D>(nodes, 0.1, 0.2, rng);
}

template <int D>
FacetSet by_dual_edge(const Body<D>& body, const Sweep<D>& sweep) {
  return Selector<D>(body.k, body.points).select(sweep.simplices);
}

template <int D>
Sweep<D> joined(Sweep<D> a, const Sweep<D>& b) {
  a.simplices.insert(a.simplices.end(), b.simplices.begin(), b.simplices.end());
  a.step_of.assign(a.simplices.size(), 0);
  return a;
}

// Theorem B: X(S1 + S2) = X(S1) + X(S2).
template <int D>
void sweeps_add_up() {
  Rng rng = any_rng();
  const Body<D> body = any_body<D>(rng);
  const Sweep<D> one = bodies::any_sweep(body, rng), other = bodies::any_sweep(body, rng);
  const FacetSet of_one = by_dual_edge(body, one), of_other = by_dual_edge(body, other);
  RC_CLASSIFY(!(of_one & of_other).empty(), "both choose a facet");
  RC_ASSERT(by_dual_edge(body, joined(one, other)) == (of_one ^ of_other));
}

RC_GTEST_PROP(TheoremBProperty, SweepsAddUpInThePlane, ()) { sweeps_add_up<2>(); }
RC_GTEST_PROP(TheoremBProperty, SweepsAddUpInSpace, ()) { sweeps_add_up<3>(); }

/// For each ridge: its cells' vertices, and whether a boundary facet contains it.
struct Surroundings {
  std::set<VertexId> vertices;
  bool on_boundary = false;
};

template <int D>
std::map<std::vector<VertexId>, Surroundings> ridges(const Body<D>& body) {
  std::map<std::vector<VertexId>, Surroundings> result;
  for (topology::Index c = 0; c < body.k.cell_count(); ++c) {
    const topology::Cell<D>& cell = body.k.vertices(CellId{c});
    for (std::size_t i = 0; i < cell.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        std::vector<VertexId> ridge;
        for (std::size_t n = 0; n < cell.size(); ++n)
          if (n != i && n != j) ridge.push_back(cell[n]);
        std::sort(ridge.begin(), ridge.end());
        Surroundings& around = result[ridge];
        around.vertices.insert(cell.begin(), cell.end());
        for (const std::size_t n : {i, j})
          if (!body.k.is_interior(topology::half_facet<D>(CellId{c}, static_cast<int>(n))))
            around.on_boundary = true;
      }
  }
  return result;
}

// Theorem B: a ridge inside the body that the rim stays away from has even degree.
template <int D>
void ridges_away_from_the_rim_are_even() {
  Rng rng = any_rng();
  const Body<D> body = any_body<D>(rng);
  const Sweep<D> sweep =
      rng.chance(0.3) ? bodies::full_crossing(body, rng) : bodies::any_path(body, rng);
  const FacetSet chosen = by_dual_edge(body, sweep);
  const auto degrees = support::ridge_degrees<D>(body.k.cells(), list(chosen));
  std::vector<Box<D>> rim_boxes;
  for (const auto& face : rim(sweep)) rim_boxes.push_back(box_around<D>(face, 0));
  std::size_t even = 0;
  for (const auto& [ridge, around] : ridges(body)) {
    const auto degree = degrees.find(ridge);
    if (degree == degrees.end() || around.on_boundary) continue;
    std::vector<Point<D>> star;
    for (const VertexId v : around.vertices) star.push_back(body.points[v.value]);
    const Box<D> box = box_around<D>(star, 1e-9);
    const auto is_away = [&](const Box<D>& face) { return disjoint(box, face); };
    if (!std::all_of(rim_boxes.begin(), rim_boxes.end(), is_away)) continue;
    RC_ASSERT(degree->second % 2 == 0u);
    ++even;
  }
  RC_CLASSIFY(even > 0, "chosen facets around such ridges");
}

RC_GTEST_PROP(TheoremBProperty, RidgesAwayFromTheRimAreEvenInThePlane, ()) {
  ridges_away_from_the_rim_are_even<2>();
}
RC_GTEST_PROP(TheoremBProperty, RidgesAwayFromTheRimAreEvenInSpace, ()) {
  ridges_away_from_the_rim_are_even<3>();
}

/// Labels of cells that differ across exactly the facets of `set`; none if there are none. The body
/// is one piece.
template <int D>
std::optional<std::vector<int>> labels(const topology::Complex<D>& k, const FacetSet& set) {
  std::vector<int> label(k.cell_count(), -1);
  std::vector<CellId> todo{CellId{0}};
  label[0] = 0;
  while (!todo.empty()) {
    const CellId cell = todo.back();
    todo.pop_back();
    for (int i = 0; i <= D; ++i) {
      const HalfFacetId h = topology::half_facet<D>(cell, i);
      const auto mate = k.mate(h);
      if (!mate) continue;
      const CellId next = topology::cell_of<D>(*mate);
      const int expected = label[cell.value] ^ (set.contains(std::min(h, *mate)) ? 1 : 0);
      if (label[next.value] == -1) {
        label[next.value] = expected;
        todo.push_back(next);
      }
      if (label[next.value] != expected) return std::nullopt;
    }
  }
  return label;
}

// Theorem B: a sweep whose rim is so far outside that it passes through no triangle of dual points
// chooses exactly the facets between two sets of cells, and the cut along them separates; holes of
// the body do not matter then.
template <int D>
void full_crossings_separate() {
  Rng rng = any_rng();
  const Body<D> body = any_body<D>(rng);
  const FacetSet chosen = by_dual_edge(body, bodies::full_crossing(body, rng));
  const auto label = labels(body.k, chosen);
  RC_ASSERT(label.has_value());
  RC_CLASSIFY(chosen.empty(), "all cells on one side");
  topology::Complex<D> cut = body.k;
  topology::unglue(cut, chosen);
  RC_ASSERT((topology::pieces(cut).count >= 2) == !chosen.empty());
}

RC_GTEST_PROP(TheoremBProperty, FullCrossingsSeparateInThePlane, ()) {
  full_crossings_separate<2>();
}
RC_GTEST_PROP(TheoremBProperty, FullCrossingsSeparateInSpace, ()) { full_crossings_separate<3>(); }

// Lemma 1, mended: of one plane, a vertex is closest iff it is no farther than the farthest vertex
// on the other side; so ties by id leave at most three, and with both all four are closest iff the
// farthest ones of the two sides are equally far.
RC_GTEST_PROP(Lemma1Property, TheMendedLemmaSaysWhichVerticesAreClosest, ()) {
  Rng rng = any_rng();
  std::array<int, 4> height;
  for (int& h : height) h = rng.between(-3, 3);
  const std::array<double, 2> base{rng.unit(), rng.unit()};
  const std::array<Point<3>, 4> places{{{base[0], base[1], 1.0 * height[0]},
                                        {1, 0, 1.0 * height[1]},
                                        {0, 1, 1.0 * height[2]},
                                        {1, 1, 1.0 * height[3]}}};
  const std::vector<std::array<Point<3>, 3>> plane{{{{-90, -90, 0}, {90, -90, 0}, {0, 90, 0}}}};
  std::array<int, 2> farthest{-1, -1};  // of the lower side, which has height 0 too, and the upper
  for (const int h : height)
    farthest[h > 0 ? 1 : 0] = std::max(farthest[h > 0 ? 1 : 0], std::abs(h));
  std::array<bool, 4> expected;
  for (std::size_t i = 0; i < 4; ++i)
    expected[i] = std::abs(height[i]) <= farthest[height[i] > 0 ? 0 : 1];

  const topology::Cell<3> cell{{{0}, {1}, {2}, {3}}};
  const auto both = nearest_vertices<3>(cell, places, plane, Ties::both);
  const auto by_id = nearest_vertices<3>(cell, places, plane, Ties::by_id);
  RC_ASSERT(both == expected);
  RC_ASSERT(std::count(by_id.begin(), by_id.end(), true) <= 3);
  for (std::size_t i = 0; i < 4; ++i) RC_ASSERT(!by_id[i] || both[i]);
  const bool all_four = std::count(both.begin(), both.end(), true) == 4;
  RC_CLASSIFY(all_four, "four are closest");
  RC_ASSERT(all_four == (farthest[0] == farthest[1] && farthest[0] >= 0));
}

// A triangle of a sweep puts in no vertex that its plane would not.
RC_GTEST_PROP(Lemma1Property, ATrianglePutsInNoMoreThanItsPlane, ()) {
  Rng rng = any_rng();
  const auto any_point = [&] {
    return Point<3>{3.0 * rng.between(-3, 3), 3.0 * rng.between(-3, 3), 3.0 * rng.between(-3, 3)};
  };
  const std::array<Point<3>, 4> places{any_point(), any_point(), any_point(), any_point()};
  std::vector<std::array<Point<3>, 3>> triangle{{any_point(), any_point(), any_point()}};
  RC_PRE(!SweptSimplex<3>(triangle[0]).is_flat());
  // Large enough for all of the cell: grown about its centroid, in whole numbers.
  auto plane = triangle;
  for (std::size_t i = 0; i < 3; ++i) {
    const double centre = (triangle[0][0][i] + triangle[0][1][i] + triangle[0][2][i]) / 3;
    for (std::size_t c = 0; c < 3; ++c)
      plane[0][c][i] = centre + 1024.0 * (triangle[0][c][i] - centre);
  }
  const topology::Cell<3> cell{{{0}, {1}, {2}, {3}}};
  bool less = false;
  for (const Ties ties : {Ties::both, Ties::by_id}) {
    const auto few = nearest_vertices<3>(cell, places, triangle, ties);
    const auto all = nearest_vertices<3>(cell, places, plane, ties);
    for (std::size_t i = 0; i < 4; ++i) RC_ASSERT(!few[i] || all[i]);
    less = less || few != all;
  }
  RC_CLASSIFY(less, "the triangle puts in less");
}

}  // namespace
}  // namespace cleave::cutting
