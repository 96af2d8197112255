// Sides moved apart: by how much, and which cells that turns inside out.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "carry_support.hpp"
#include "geometry_check.hpp"
#include "offset.hpp"

namespace cleave::app::test {
namespace {

// A Kuhn grid whose facets with `chosen` vertices alone are cut.
template <int D, class Chosen>
Mesh grid_with_seam(const support::KuhnGrid<D>& grid, support::Rng& rng, Chosen chosen) {
  Mesh mesh = grid_mesh(grid, rng);
  const auto body = make_body<D>(mesh);
  std::vector<topology::HalfFacetId> seam;
  for (const auto h : topology::FacetSet::all(body.complex).half_facets()) {
    const auto facet = body.complex.facet(h);
    if (std::all_of(facet.begin(), facet.end(),
                    [&](auto v) { return chosen(mesh.points[v.value]); }))
      seam.push_back(h);
  }
  add_facets<D>(mesh, "seam", seam, rng);
  return mesh;
}

TEST(Offset, OpensAPlaneByItsDistanceAndLeavesTheTip) {
  support::Rng rng(5);
  const support::KuhnGrid<3> grid({3, 4, 3});
  Mesh mesh = grid_with_seam(grid, rng, [](const auto& p) { return p[0] == 1 && p[1] <= 2; });
  add_nodes(mesh, rng);
  auto done = cut<3>(mesh, {"seam"});
  const Mesh before = done.output.mesh;
  move_sides(done.body, done.incision, 0.25, done.output);
  const Mesh& out = done.output.mesh;
  EXPECT_TRUE(done.output.warnings.empty());
  std::set<Index> moved;
  for (const MovedPoint& point : done.output.moved) {
    moved.insert(point.place);
    EXPECT_EQ(point.before, before.points[point.place]);
  }
  std::size_t apart = 0, halfway = 0;
  for (Index p = 0; p < out.points.size(); ++p) {
    const auto &from = before.points[p], &to = out.points[p];
    EXPECT_EQ(moved.count(p) != 0, from != to);
    EXPECT_NEAR(from[1], to[1], 1e-15);
    EXPECT_NEAR(from[2], to[2], 1e-15);
    const double by = std::abs(to[0] - from[0]);
    if (by < 1e-15) continue;
    EXPECT_LE(from[1], 2);
    // Only ends of cut edges go by half of the distance; nodes between a moved and an unmoved end
    // by a quarter.
    EXPECT_TRUE(std::abs(by - 0.125) < 1e-15 || std::abs(by - 0.0625) < 1e-15) << by;
    (by > 0.1 ? apart : halfway) += 1;
  }
  EXPECT_GT(apart, 0u);
  EXPECT_GT(halfway, 0u);
  for (Index p = 0; p < out.points.size(); ++p)
    if (before.points[p][1] >= 2 && done.output.vertex_at[p] != kNoVertex) {
      EXPECT_EQ(before.points[p], out.points[p]) << "at the tip and beyond";
    }
  EXPECT_EQ(before.cells().vertices, out.cells().vertices);
}

TEST(Offset, OpensTrianglesThatAreNotInAPlane) {
  support::Rng rng(6);
  Mesh mesh =
      grid_with_seam(support::KuhnGrid<2>({3, 3}), rng, [](const auto& p) { return p[0] == 1; });
  for (auto& p : mesh.points) p = {p[0], p[1], std::abs(p[0] - 1)};  // a V along the seam
  auto done = cut<2>(mesh, {"seam"});
  move_sides(done.body, done.incision, 0.2, done.output);
  std::size_t moved = 0;
  for (const MovedPoint& point : done.output.moved) {
    const auto& now = done.output.mesh.points[point.place];
    EXPECT_NEAR(std::hypot(now[0] - 1, now[1] - point.before[1], now[2]), 0.1, 1e-15);
    EXPECT_NEAR(now[2], std::abs(now[0] - 1), 1e-15);  // within its own triangles' plane
    ++moved;
  }
  EXPECT_EQ(moved, 6u);
}

TEST(Offset, OfZeroMovesNothing) {
  support::Rng rng(8);
  Mesh mesh =
      grid_with_seam(support::KuhnGrid<2>({3, 3}), rng, [](const auto& p) { return p[0] == 1; });
  auto done = cut<2>(mesh, {"seam"});
  const auto points = done.output.mesh.points;
  move_sides(done.body, done.incision, 0, done.output);
  EXPECT_EQ(points, done.output.mesh.points);
  EXPECT_TRUE(done.output.moved.empty());
}

// How many cells of `mesh` are turned inside out or flat, from the coordinates alone, given that
// none was before.
template <int D>
std::size_t turned(const Mesh& before, const Mesh& after) {
  const auto sign = [](const Mesh& mesh, std::size_t c) {
    std::array<std::array<double, 3>, 4> p{};
    for (std::size_t i = 0; i <= D; ++i) p[i] = mesh.points[mesh.cells().vertices[(D + 1) * c + i]];
    std::array<std::array<double, 3>, 3> e{};
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t x = 0; x < 3; ++x) e[i][x] = p[i + 1][x] - p[0][x];
    if (D == 2) e[2] = {0, 0, 1};
    const double v = e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
                     e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
                     e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
    return std::abs(v) < 1e-12 ? 0 : v > 0 ? 1 : -1;
  };
  std::size_t count = 0;
  for (std::size_t c = 0; c < before.cells().size(); ++c)
    count += sign(before, c) != sign(after, c) ? 1 : 0;
  return count;
}

template <int D>
void warns_exactly_when_a_cell_turns() {
  support::Rng rng(*rc::gen::arbitrary<std::uint64_t>());
  typename support::KuhnGrid<D>::Point nodes{};
  for (int& n : nodes) n = rng.between(3, 4);
  Mesh mesh = grid_mesh(support::KuhnGrid<D>(nodes), rng);
  for (auto& p : mesh.points)
    for (std::size_t x = 0; x < D; ++x) p[x] += 0.15 * rng.unit();
  const auto body = make_body<D>(mesh);
  std::vector<topology::HalfFacetId> facets;
  const double density = 0.3 + 0.7 * rng.unit();
  for (const auto h : topology::FacetSet::all(body.complex).half_facets())
    if (rng.chance(density)) facets.push_back(h);
  RC_PRE(!facets.empty());
  const auto original = cut<D>(mesh, {}, facets);
  const auto offset = [&](double distance) {
    CutOutput output = original.output;
    move_sides(original.body, original.incision, distance, output);
    return output;
  };
  const double distance = 3 * rng.unit();
  const CutOutput moved = offset(distance);
  const bool warned = !moved.warnings.empty();
  RC_CLASSIFY(warned, "cells turned");
  RC_CLASSIFY(moved.moved.empty(), "nothing moved");
  RC_ASSERT(warned == (turned<D>(original.output.mesh, moved.mesh) > 0));
  if (!warned) return;
  const std::string& warning = moved.warnings.front();
  const double safe = std::stod(warning.substr(warning.rfind("about ") + 6));
  RC_ASSERT(safe < distance);
  for (const double part : {0.1, 0.5, 0.9, 0.99}) RC_ASSERT(offset(part * safe).warnings.empty());
  bool turns = false;
  for (const double more : {1.01, 1.02, 1.03})
    turns = turns || !offset(more * safe).warnings.empty();
  RC_ASSERT(turns);
}

RC_GTEST_PROP(Offset, WarnsExactlyWhenATriangleTurns, ()) { warns_exactly_when_a_cell_turns<2>(); }
RC_GTEST_PROP(Offset, WarnsExactlyWhenATetrahedronTurns, ()) {
  warns_exactly_when_a_cell_turns<3>();
}

}  // namespace
}  // namespace cleave::app::test
