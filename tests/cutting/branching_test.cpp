// The paper's rule branches where neighbouring cells differ in size (its Figure 5), on a straight
// sweep in general position. The numbers are those of proofs/pictures/counterexamples.py.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>
#include <variant>
#include <vector>

#include "bodies.hpp"
#include "cleave/cutting/select.hpp"
#include "cleave/support/reference.hpp"
#include "cleave/topology/assemble.hpp"
#include "cleave/topology/check.hpp"
#include "cleave/topology/pieces.hpp"
#include "cleave/topology/unglue.hpp"

namespace cleave::cutting {
namespace {

using topology::Cell;
using topology::Complex;
using topology::HalfFacetId;
using topology::VertexId;

constexpr SelectOptions kNearest{Rule::nearest_vertex, Ties::both};

/// Around vertex 0 at (0, -2), and 1 .. 4.
constexpr std::array<std::array<double, 2>, 5> kPlaces{
    {{0, -2}, {-2, -10}, {5, 3}, {1, 1}, {-10, 4}}};

template <int D>
Complex<D> complex_of(std::vector<Cell<D>> cells, std::size_t vertex_count) {
  topology::CellSoup<D> soup{std::move(cells), vertex_count, {}};
  soup.signs = std::get<0>(topology::orient(soup));
  return topology::assemble(std::move(soup));
}

/// The vertices of the chosen facets that are on the outside, ascending.
template <int D>
std::vector<topology::Index> outer_vertices(const Complex<D>& k, const topology::FacetSet& chosen) {
  std::vector<topology::Index> found;
  for (const HalfFacetId h : chosen.half_facets())
    for (const VertexId v : k.facet(h))
      if (v.value >= 1 && v.value <= 4) found.push_back(v.value);
  std::sort(found.begin(), found.end());
  return found;
}

TEST(NearestVertexBranching, ThreeEdgesMeetInThePlane) {
  const Complex<2> k = complex_of<2>(
      {{{{0}, {1}, {2}}}, {{{0}, {2}, {3}}}, {{{0}, {3}, {4}}}, {{{0}, {4}, {1}}}}, 5);
  std::vector<Point<2>> points;
  for (const auto& place : kPlaces) points.push_back({place[0], place[1]});
  const std::vector<std::array<Point<2>, 2>> line{{{{-20, 0}, {20, 0}}}};
  const auto chosen = Selector<2>(k, points, kNearest).select(line);
  EXPECT_EQ(outer_vertices(k, chosen), (std::vector<topology::Index>{2, 3, 4}));
}

// The same seen along an edge: four tetrahedra around the edge 0-5, of which three facets are
// chosen. The body still falls apart, into three pieces.
TEST(NearestVertexBranching, ThreeTrianglesMeetInSpace) {
  const Complex<3> k = complex_of<3>({{{{0}, {5}, {1}, {2}}},
                                      {{{0}, {5}, {2}, {3}}},
                                      {{{0}, {5}, {3}, {4}}},
                                      {{{0}, {5}, {4}, {1}}}},
                                     6);
  std::vector<Point<3>> points{{0, -3, -2}};
  for (std::size_t v = 1; v < 5; ++v) points.push_back({kPlaces[v][0], 0, kPlaces[v][1]});
  points.push_back({0, 3, -2});
  const std::vector<std::array<Point<3>, 3>> plane{{{{-90, -90, 0}, {90, -90, 0}, {0, 90, 0}}}};
  const auto chosen = Selector<3>(k, points, kNearest).select(plane);
  EXPECT_EQ(outer_vertices(k, chosen), (std::vector<topology::Index>{2, 3, 4}));
  Complex<3> cut = k;
  topology::unglue(cut, chosen, topology::Verify::all);
  EXPECT_EQ(topology::pieces(cut).count, 3u);
}

/// Whether more than two chosen facets meet in a ridge.
bool branches(const bodies::Body<3>& body, const topology::FacetSet& chosen) {
  const auto facets = chosen.half_facets();
  for (const auto& [ridge, degree] :
       support::ridge_degrees<3>(body.k.cells(), {facets.begin(), facets.end()}))
    if (degree > 2) return true;
  return false;
}

// How often: of 100 planes in general position through disturbed grids, by how much these are
// disturbed, in edges.
TEST(NearestVertexBranching, IsTheMoreCommonTheMoreUnevenTheCells) {
  int last = 0;
  for (const double jitter : {0.1, 0.2, 0.3}) {
    bodies::Rng rng(2000);
    int nearest = 0, dual = 0;
    for (int run = 0; run < 100; ++run) {
      const auto body = bodies::jittered<3>({9, 9, 9}, 1, jitter, rng);
      const double a = rng.unit() - 0.5, b = rng.unit() - 0.5, c = 3.5 + rng.unit();
      const auto at = [&](double x, double y) {
        return Point<3>{x, y, c + a * (x - 4) + b * (y - 4)};
      };
      const std::vector<std::array<Point<3>, 3>> plane{{at(-90, -90), at(90, -90), at(0, 150)}};
      const auto select = [&](Rule rule) {
        return Selector<3>(body.k, body.points, {rule, Ties::by_id}).select(plane);
      };
      nearest += branches(body, select(Rule::nearest_vertex)) ? 1 : 0;
      dual += branches(body, select(Rule::dual_edge)) ? 1 : 0;
    }
    std::printf(
        "grids disturbed by %.1f: of 100 planes nearest-vertex branches along %d, "
        "dual-edge along %d\n",
        jitter, nearest, dual);
    EXPECT_GE(nearest, last);
    last = nearest;
  }
  EXPECT_GT(last, 0);
}

}  // namespace
}  // namespace cleave::cutting
