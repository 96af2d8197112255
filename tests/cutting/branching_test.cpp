// The paper's rule branches where neighbouring cells differ in size (its Figure 5), on a straight
// sweep in general position. The numbers are those of proofs/pictures/counterexamples.py.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>
#include <variant>
#include <vector>

#include "cleave/cutting/select.hpp"
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
std::vector<std::uint32_t> outer_vertices(const Complex<D>& k, const topology::FacetSet& chosen) {
  std::vector<std::uint32_t> found;
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
  EXPECT_EQ(outer_vertices(k, chosen), (std::vector<std::uint32_t>{2, 3, 4}));
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
  EXPECT_EQ(outer_vertices(k, chosen), (std::vector<std::uint32_t>{2, 3, 4}));
  Complex<3> cut = k;
  topology::unglue(cut, chosen, topology::Verify::all);
  EXPECT_EQ(topology::pieces(cut).count, 3u);
}

}  // namespace
}  // namespace cleave::cutting
