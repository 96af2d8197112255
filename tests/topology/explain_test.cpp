#include "cleave/topology/explain.hpp"

#include <gtest/gtest.h>

#include "cleave/topology/unglue.hpp"
#include "explain_law.hpp"

namespace cleave::views {
namespace {

template <class Dimension>
class Explain : public ::testing::Test {};
TYPED_TEST_SUITE(Explain, Dimensions);

TYPED_TEST(Explain, NamesTheThirdCellAroundAnInnerFacetOfASplitSimplex) {
  // A simplex split into D+1 cells: around any vertex of an inner facet, a third cell joins its two
  // sides when D >= 3. This is the smallest cut that opens nothing.
  constexpr int D = TypeParam::value;
  if constexpr (D >= 3) {
    auto k = complex_of(support::cone<D>(support::simplex_boundary<D - 1>()));
    const auto mate = k.mate(half_facet<D>({0}, 0));
    ASSERT_TRUE(mate);
    const auto cut = FacetSet::of(k, std::vector{half_facet<D>({0}, 0)});
    const auto change = unglue(k, cut);
    ASSERT_EQ(change.shut.size(), 1u);
    const auto reasons = explain(k, cut, change.shut[0]);
    ASSERT_EQ(reasons.size(), static_cast<std::size_t>(D));
    for (const Because& because : reasons) {
      ASSERT_EQ(because.through.size(), 3u);
      EXPECT_EQ(because.through.front(), CellId{0});
      EXPECT_EQ(because.through.back(), cell_of<D>(*mate));
    }
  }
}

TYPED_TEST(Explain, HoldsForEveryShutFacetOfADenseCut) {
  constexpr int D = TypeParam::value;
  for (auto& k : sample_complexes<D>()) {
    std::vector<HalfFacetId> facets;
    const FacetSet every = FacetSet::all(k);
    for (const HalfFacetId h : every.half_facets())
      if (h.value * 2654435761u % 5 < 2) facets.push_back(h);
    EXPECT_EQ(explanation_flaw(k, FacetSet::of_lesser(facets)), "");
  }
}

TYPED_TEST(Explain, ForetellsAnEmptyChainWhereAVertexSeparates) {
  constexpr int D = TypeParam::value;
  const auto k = complex_of<D>(kuhn_cube<D>(2 + (D == 1)));
  const FacetSet every = FacetSet::all(k);
  for (const Because& because : explain(k, every, every.half_facets()[0]))
    EXPECT_TRUE(because.through.empty());
}

TYPED_TEST(Explain, RefusesABoundaryFacet) {
  constexpr int D = TypeParam::value;
  const auto k = complex_of(support::simplex<D>());
  EXPECT_THROW(explain(k, FacetSet(), HalfFacetId{0}), NotInterior);
}

}  // namespace
}  // namespace cleave::views
