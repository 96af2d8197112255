#include <gtest/gtest.h>

#include <functional>

#include "cleave/topology/incision.hpp"
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
      [](Relabelling& told) { told.shut.push_back(HalfFacetId{kNoIndex - 1}); }};
  for (std::size_t n = 0; n < lies.size(); ++n) {
    Relabelling told = truth;
    lies[n](told);
    EXPECT_THROW(verify_touched(k, cut, told), InvariantBroken) << "lie " << n;
  }
}

TYPED_TEST(VerifyTouched, AcceptsAStitchAndRefusesEveryOtherStory) {
  constexpr int D = TypeParam::value;
  Incision<D> incision(complex_of<D>(kuhn_cube<D>(D <= 2 ? 5 : 3)));
  incision.cut(dense_cut(incision.complex()));
  const Complex<D> before = incision.complex();
  std::vector<HalfFacetId> half;
  for (const OpenedFacet& facet : incision.opened())
    if (facet.half_facet.value % 2 == 0) half.push_back(facet.half_facet);
  const Relabelling truth = incision.stitch(FacetSet::of_lesser(half), Verify::none);
  const Complex<D>& k = incision.complex();
  ASSERT_GT(truth.merges.size(), 1u);
  ASSERT_GT(truth.closed.size(), 1u);
  const FacetSet shut = FacetSet::of_lesser(truth.shut);
  EXPECT_NO_THROW(verify_touched(k, shut, truth));
  EXPECT_THROW(verify_touched(before, shut, truth), InvariantBroken);

  const std::vector<std::function<void(Relabelling&)>> lies{
      [](Relabelling& told) { --told.vertices_after; },
      [](Relabelling& told) { told.vertices_before = told.vertices_after - 1; },
      [](Relabelling& told) { told.merges.front().into = told.merges.back().vertex; },
      [](Relabelling& told) { told.merges.front().vertex = told.merges.front().into; },
      [](Relabelling& told) { std::swap(told.merges.front(), told.merges.back()); },
      [](Relabelling& told) {
        told.splits.push_back({{0}, {0}});
      },
      [](Relabelling& told) { std::swap(told.corners.front().from, told.corners.front().to); },
      [](Relabelling& told) { ++told.corners.front().to.value; },
      [](Relabelling& told) { told.corners.front().from = told.corners.front().to; },
      [](Relabelling& told) { told.closed.front().former_mate = told.closed.back().former_mate; },
      [](Relabelling& told) { told.shut.push_back(HalfFacetId{kNoIndex - 1}); }};
  for (std::size_t n = 0; n < lies.size(); ++n) {
    Relabelling told = truth;
    lies[n](told);
    EXPECT_THROW(verify_touched(k, shut, told), InvariantBroken) << "lie " << n;
  }
}

// For D = 1 every facet of a cut opens.
template <int D>
void expect_shut_facet_told_as_opened_to_be_found() {
  const auto whole = complex_of<D>(kuhn_cube<D>(D == 2 ? 5 : 4));
  const FacetSet all = FacetSet::all(whole);
  for (const HalfFacetId h : all.half_facets()) {
    auto k = whole;
    const FacetSet cut = FacetSet::of_lesser({h});
    Relabelling told = unglue(k, cut);
    if (told.shut.empty()) continue;
    told.opened.push_back({h, *k.mate(h), k.facet(h)[0]});
    told.shut.clear();
    EXPECT_THROW(verify_touched(k, cut, told), InvariantBroken);
    return;
  }
  FAIL() << "no facet stays shut alone";
}

TEST(VerifyShut, FindsAShutFacetThatIsToldAsOpened) {
  expect_shut_facet_told_as_opened_to_be_found<2>();
  expect_shut_facet_told_as_opened_to_be_found<3>();
  expect_shut_facet_told_as_opened_to_be_found<4>();
}

}  // namespace
}  // namespace cleave::views
