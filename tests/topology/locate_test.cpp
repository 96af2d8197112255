#include "cleave/topology/locate.hpp"

#include <gtest/gtest.h>

#include "view_laws.hpp"

namespace cleave::views {
namespace {

template <class Dimension>
class LocateIn : public ::testing::Test {};
TYPED_TEST_SUITE(LocateIn, Dimensions);

TYPED_TEST(LocateIn, FindsTheLeastHalfFacetOfEveryFacetInAnyOrder) {
  constexpr int D = TypeParam::value;
  const auto grid = kuhn_cube<D>(3);
  std::vector<Facet<D>> asked;
  std::vector<std::optional<HalfFacetId>> expected;
  for (const auto& [facet, half_facets] : support::facets_of<D>(grid.cells)) {
    asked.push_back(facet);
    std::rotate(asked.back().begin(), asked.back().begin() + (D > 1), asked.back().end());
    expected.push_back(half_facets.front());
  }
  EXPECT_EQ(locate_facets<D>(grid.cells, asked), expected);
}

TYPED_TEST(LocateIn, KnowsNoFacetThatIsNoneAndAnswersRepetitions) {
  constexpr int D = TypeParam::value;
  const auto mesh = support::simplex<D>();
  Facet<D> absent{}, repeating{}, present{};
  for (Index i = 0; i < D; ++i) {
    absent[i] = {i + 2};  // the last one is vertex D+1
    present[i] = {i};
  }
  repeating.fill({D > 1 ? 0u : 99u});
  const std::vector<Facet<D>> asked{present, absent, present, repeating};
  const std::vector<std::optional<HalfFacetId>> expected{half_facet<D>({0}, D), std::nullopt,
                                                         half_facet<D>({0}, D), std::nullopt};
  EXPECT_EQ(locate_facets<D>(mesh.cells, asked), expected);
  EXPECT_TRUE(locate_facets<D>(mesh.cells, {}).empty());
  EXPECT_EQ(locate_facets<D>({}, asked), std::vector<std::optional<HalfFacetId>>(4));
}

TEST(Locate, TakesTheNumbersOfAFileAsTheyAre) {
  const std::vector<Cell<2>> cells{{VertexId{7}, VertexId{4294967295}, VertexId{70}},
                                   {VertexId{4294967295}, VertexId{9}, VertexId{70}}};
  const std::vector<Facet<2>> asked{{VertexId{70}, VertexId{4294967295}},
                                    {VertexId{7}, VertexId{9}},
                                    {VertexId{9}, VertexId{70}}};
  const auto found = locate_facets<2>(cells, asked);
  EXPECT_EQ(found[0], HalfFacetId{0});
  EXPECT_EQ(found[1], std::nullopt);
  EXPECT_EQ(found[2], HalfFacetId{3});
}

}  // namespace
}  // namespace cleave::views
