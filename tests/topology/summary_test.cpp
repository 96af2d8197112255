#include "cleave/topology/summary.hpp"

#include <gtest/gtest.h>

#include "view_laws.hpp"

namespace cleave::views {
namespace {

template <int D>
void expect_summary(const support::Mesh<D>& mesh, std::size_t pieces,
                    std::size_t boundary_components, std::int64_t euler_characteristic) {
  const Summary summary = summarize<D>({mesh.cells, mesh.vertex_count, {}});
  EXPECT_EQ(summary.pieces, pieces);
  EXPECT_EQ(summary.boundary_components, boundary_components);
  EXPECT_EQ(summary.euler_characteristic, euler_characteristic);
}

template <class Dimension>
class SummaryOf : public ::testing::Test {};
TYPED_TEST_SUITE(SummaryOf, Dimensions);

TYPED_TEST(SummaryOf, BallsSpheresAndTori) {
  constexpr int D = TypeParam::value;
  expect_summary<D>(kuhn_cube<D>(3), 1, D == 1 ? 2 : 1, 1);
  expect_summary<D>(support::simplex_boundary<D>(), 1, 0, D % 2 == 0 ? 2 : 0);
  expect_summary<D>(support::torus<D>(3), 1, 0, 0);
  expect_summary<D>({}, 0, 0, 0);
  expect_summary<D>(support::disjoint_union(support::simplex<D>(), support::simplex_boundary<D>()),
                    2, D == 1 ? 2 : 1, D % 2 == 0 ? 3 : 1);
}

TEST(Summary, OfSurfacesWithAndWithoutTwist) {
  expect_summary(support::band(6), 1, 2, 0);
  expect_summary(support::band(5), 1, 1, 0);
  expect_summary(support::projective_plane(), 1, 0, 1);
}

TEST(Summary, OfAHollowCubeHasTwoBoundaries) {
  const auto grid = kuhn_cube<3>(4);
  std::vector<bool> shell;
  for (std::size_t c = 0; c < grid.cells.size(); ++c)
    shell.push_back(grid.cube(c) != std::array{1, 1, 1});
  expect_summary(support::sub_mesh<3>(grid, shell), 1, 2, 2);
}

Cell<2> triangle(Index a, Index b, Index c) { return {VertexId{a}, VertexId{b}, VertexId{c}}; }

TEST(Summary, OfThreeTrianglesOnOneEdge) {
  // The common edge is no boundary; the other six close up at its two ends.
  expect_summary<2>({{triangle(0, 1, 2), triangle(0, 1, 3), triangle(0, 1, 4)}, 5}, 1, 1, 1);
}

TEST(Summary, OfTrianglesThatTouchInAVertex) {
  expect_summary<2>({{triangle(0, 1, 2), triangle(0, 3, 4)}, 5}, 2, 1, 1);
}

TEST(Summary, OfCellsNamedTwice) {
  expect_summary<2>({{triangle(0, 1, 2), triangle(2, 0, 1)}, 3}, 1, 0, 1);
}

TEST(Summary, CountsARepeatedVertexOnce) {
  // The first cell is the edge {0, 1} in truth, and shares it with the second.
  expect_summary<2>({{triangle(0, 0, 1), triangle(0, 1, 2)}, 3}, 1, 1, 1);
  expect_summary<2>({{triangle(5, 5, 5)}, 6}, 1, 0, 1);
}

TEST(Summary, TakesVerticesOutOfRangeAndIgnoresOrphans) {
  expect_summary<2>({{triangle(0, 1, 4000000000)}, 2}, 1, 1, 1);
  expect_summary<2>({{triangle(0, 1, 2)}, 100}, 1, 1, 1);
}

}  // namespace
}  // namespace cleave::views
