#include "cleave/topology/pieces.hpp"

#include <gtest/gtest.h>

#include "cleave/topology/unglue.hpp"
#include "view_laws.hpp"

namespace cleave::views {
namespace {

template <class Dimension>
class PiecesOf : public ::testing::Test {};
TYPED_TEST_SUITE(PiecesOf, Dimensions);

TYPED_TEST(PiecesOf, AreNumberedByTheirLeastCell) {
  constexpr int D = TypeParam::value;
  using support::disjoint_union;
  const auto simplex = support::simplex<D>();
  const auto k =
      complex_of(disjoint_union(simplex, disjoint_union(support::simplex_boundary<D>(), simplex)));
  const Pieces found = pieces(k);
  EXPECT_EQ(found.count, 3u);
  std::vector<Index> expected(k.cell_count(), 1);
  expected.front() = 0;
  expected.back() = 2;
  EXPECT_EQ(found.of_cell, expected);
}

TYPED_TEST(PiecesOf, OfNothingAreNone) {
  const Pieces found = pieces(Complex<TypeParam::value>());
  EXPECT_EQ(found.count, 0u);
  EXPECT_TRUE(found.of_cell.empty());
}

TYPED_TEST(PiecesOf, AreCellsOnceEveryFacetIsCut) {
  constexpr int D = TypeParam::value;
  auto k = complex_of<D>(kuhn_cube<D>(3));
  EXPECT_EQ(pieces(k).count, 1u);
  unglue(k, FacetSet::all(k));
  EXPECT_EQ(pieces(k).count, k.cell_count());
}

}  // namespace
}  // namespace cleave::views
