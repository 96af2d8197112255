#include "cleave/topology/boundary.hpp"

#include <gtest/gtest.h>

#include "view_laws.hpp"

namespace cleave::views {
namespace {

template <class Dimension>
class BoundaryOf : public ::testing::Test {};
TYPED_TEST_SUITE(BoundaryOf, Dimensions);

TYPED_TEST(BoundaryOf, IsEveryHalfFacetWithoutMate) {
  constexpr int D = TypeParam::value;
  for (const auto& k : sample_complexes<D>()) {
    std::vector<HalfFacetId> expected;
    for (const auto& [facet, half_facets] : support::facets_of<D>(k.cells()))
      if (half_facets.size() == 1) expected.push_back(half_facets.front());
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(boundary(k), expected);
  }
}

TEST(BoundaryOfSegments, IsItsTwoEnds) {
  const auto ends = boundary(complex_of<1>(kuhn_cube<1>(5)));
  EXPECT_EQ(ends, (std::vector<HalfFacetId>{half_facet<1>({0}, 1), half_facet<1>({3}, 0)}));
}

/// The boundary of a cube's Kuhn grid is a sphere of 2 D (D-1)! n^(D-1) cells.
template <int D>
void expect_sphere_around_cube(int nodes, std::size_t cells) {
  const auto k = complex_of<D>(kuhn_cube<D>(nodes));
  const auto result = boundary_complex(k);
  ASSERT_TRUE(std::holds_alternative<BoundaryComplex<D>>(result));
  const auto& sphere = std::get<BoundaryComplex<D>>(result);
  EXPECT_EQ(sphere.complex.cell_count(), cells);
  EXPECT_EQ(sphere.half_facets, boundary(k));
  EXPECT_TRUE(boundary(sphere.complex).empty()) << "T10";
  for (Index c = 0; c < cells; ++c) {
    const HalfFacetId h = sphere.half_facets[c];
    Facet<D> in_the_whole{};
    for (std::size_t i = 0; i < in_the_whole.size(); ++i)
      in_the_whole[i] = sphere.vertices[sphere.complex.vertices({c})[i].value];
    EXPECT_EQ(in_the_whole, k.facet(h));
    EXPECT_EQ(sphere.complex.sign({c}), k.facet_sign(h));
  }
}

TEST(BoundaryComplex, OfACubeIsASphere) {
  expect_sphere_around_cube<2>(4, 12);
  expect_sphere_around_cube<3>(4, 108);
  expect_sphere_around_cube<4>(2, 48);
}

TEST(BoundaryComplex, OfAClosedComplexIsEmpty) {
  const auto result = boundary_complex(complex_of(support::torus<3>(3)));
  ASSERT_TRUE(std::holds_alternative<BoundaryComplex<3>>(result));
  EXPECT_EQ(std::get<BoundaryComplex<3>>(result).complex.cell_count(), 0u);
  EXPECT_TRUE(std::get<BoundaryComplex<3>>(result).vertices.empty());
}

/// The cells of the grid whose cube `keep` takes.
template <class Keep>
Complex<3> cubes(std::array<int, 3> nodes, Keep keep) {
  const support::KuhnGrid<3> grid(nodes);
  std::vector<bool> kept;
  for (std::size_t c = 0; c < grid.cells.size(); ++c) kept.push_back(keep(grid.cube(c)));
  return complex_of(support::sub_mesh<3>(grid, kept));
}

TEST(BoundaryComplex, OfAPinchedEdgeNamesTheEdgeInFourTriangles) {
  // Two full layers hold two diagonal cubes between them, which touch in an upright edge.
  const auto k = cubes({3, 3, 4}, [](auto cube) { return cube[2] != 1 || cube[0] == cube[1]; });
  const auto result = boundary_complex(k);
  ASSERT_TRUE(std::holds_alternative<std::vector<Violation>>(result));
  const auto& violations = std::get<std::vector<Violation>>(result);
  ASSERT_EQ(violations.size(), 1u);
  ASSERT_TRUE(std::holds_alternative<FacetInThreeCells>(violations[0]));
  EXPECT_EQ(std::get<FacetInThreeCells>(violations[0]).half_facets.size(), 4u);
}

TEST(BoundaryComplex, ThatTouchesItselfInAVertexNamesTheVertex) {
  // Two opposite ones of eight cubes are missing: the centre is on two sheets.
  const auto k = cubes({3, 3, 3}, [](auto cube) {
    return cube != std::array{0, 0, 0} && cube != std::array{1, 1, 1};
  });
  const auto result = boundary_complex(k);
  ASSERT_TRUE(std::holds_alternative<std::vector<Violation>>(result));
  const auto& violations = std::get<std::vector<Violation>>(result);
  ASSERT_EQ(violations.size(), 1u);
  ASSERT_TRUE(std::holds_alternative<NotCutRegular>(violations[0]));
  EXPECT_EQ(std::get<NotCutRegular>(violations[0]).parts, 2u);
}

}  // namespace
}  // namespace cleave::views
