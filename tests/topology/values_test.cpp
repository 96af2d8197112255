// What callers may hold on to, and what the small functions refuse.
#include <gtest/gtest.h>

#include "cleave/topology/carry_over.hpp"
#include "cleave/topology/explain.hpp"
#include "view_laws.hpp"

namespace cleave::views {
namespace {

TEST(Temporaries, HandOverWhatALoopGoesThrough) {
  const auto k = complex_of<3>(kuhn_cube<3>(3));
  const FacetSet all = FacetSet::all(k);
  std::size_t facets = 0;
  for (const HalfFacetId h : FacetSet::all(k).half_facets())
    ASSERT_EQ(h, all.half_facets()[facets++]);
  EXPECT_EQ(facets, all.size());
  std::size_t cells = 0;
  for (const Cell<3>& cell : complex_of<3>(kuhn_cube<3>(3)).cells())
    ASSERT_EQ(cell, k.cells()[cells++]);
  EXPECT_EQ(cells, k.cell_count());
}

TEST(CarryOver, RefusesDataOfAnotherComplexAndLeavesItAlone) {
  Relabelling change;
  change.vertices_before = 4;
  change.vertices_after = 5;
  change.splits = {{VertexId{4}, VertexId{3}}};
  for (const std::size_t size : {0u, 3u, 5u}) {
    std::vector<int> data(size, 7);
    EXPECT_THROW(carry_over(data, change), std::invalid_argument);
    EXPECT_EQ(data, std::vector<int>(size, 7));
  }
  std::vector<int> data{1, 2, 3, 4};
  carry_over(data, change);
  EXPECT_EQ(data, (std::vector<int>{1, 2, 3, 4, 4}));
}

TEST(Explain, RefusesAHalfFacetThatDoesNotExist) {
  const auto k = complex_of<2>(kuhn_cube<2>(3));
  const HalfFacetId beyond{static_cast<Index>(k.half_facet_count())};
  EXPECT_THROW(explain(k, FacetSet::all(k), beyond), NotInterior);
}

}  // namespace
}  // namespace cleave::views
