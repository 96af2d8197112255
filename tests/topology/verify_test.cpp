#include <gtest/gtest.h>

#include <functional>

#include "cleave/topology/unglue.hpp"
#include "cleave/topology/violation.hpp"
#include "view_laws.hpp"

namespace cleave::views {
namespace {

template <class Dimension>
class VerifyTouched : public ::testing::Test {};
TYPED_TEST_SUITE(VerifyTouched, Dimensions);

TYPED_TEST(VerifyTouched, AcceptsWhatHappenedAndRefusesEveryOtherStory) {
  constexpr int D = TypeParam::value;
  auto k = complex_of<D>(kuhn_cube<D>(D <= 2 ? 5 : 3));
  const auto before = k;
  const FacetSet cut = dense_cut(k);
  const Relabelling truth = unglue(k, cut, Verify::none);
  ASSERT_FALSE(truth.splits.empty());
  ASSERT_FALSE(truth.opened.empty());
  EXPECT_NO_THROW(verify_touched(k, cut, truth));
  EXPECT_THROW(verify_touched(before, cut, truth), InvariantBroken) << "the complex did not follow";
  EXPECT_THROW(verify_touched(k, cut, Relabelling{}), InvariantBroken) << "nothing is told";

  const std::vector<std::function<void(Relabelling&)>> lies{
      [](Relabelling& told) { ++told.vertices_after; },
      [](Relabelling& told) { told.splits.front().parent = told.splits.front().vertex; },
      [](Relabelling& told) { ++told.splits.back().vertex.value; },
      [](Relabelling& told) { std::swap(told.corners.front().from, told.corners.front().to); },
      [](Relabelling& told) { ++told.corners.front().to.value; },
      [](Relabelling& told) { told.corners.front().from.value ^= 1; },
      [](Relabelling& told) { told.opened.pop_back(); },
      [](Relabelling& told) { told.opened.front().former_mate = told.opened.back().former_mate; },
      [](Relabelling& told) {
        told.shut.push_back(told.opened.back().half_facet);
        std::sort(told.shut.begin(), told.shut.end());
        told.opened.pop_back();
      },
      [](Relabelling& told) { told.shut.push_back(HalfFacetId{UINT32_MAX - 1}); }};
  for (std::size_t n = 0; n < lies.size(); ++n) {
    Relabelling told = truth;
    lies[n](told);
    EXPECT_THROW(verify_touched(k, cut, told), InvariantBroken) << "lie " << n;
  }
}

TYPED_TEST(VerifyTouched, FindsAShutFacetThatIsToldAsOpened) {
  constexpr int D = TypeParam::value;
  if constexpr (D >= 3) {  // one facet inside a split simplex stays shut
    auto k = complex_of(support::cone<D>(support::simplex_boundary<D - 1>()));
    const auto cut = FacetSet::of(k, std::vector{half_facet<D>({0}, 0)});
    Relabelling told = unglue(k, cut);
    ASSERT_EQ(told.shut.size(), 1u);
    told.opened.push_back({told.shut[0], *k.mate(told.shut[0]), VertexId{0}});
    told.shut.clear();
    EXPECT_THROW(verify_touched(k, cut, told), InvariantBroken);
  }
}

}  // namespace
}  // namespace cleave::views
