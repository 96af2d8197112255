#include <gtest/gtest.h>

#include <functional>

#include "cleave/topology/incision.hpp"
#include "cleave/topology/unglue.hpp"
#include "cleave/topology/violation.hpp"
#include "complex_access.hpp"
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

/// What a complex is made of, to be spoiled.
template <int D>
struct Parts {
  std::vector<Cell<D>> cells;
  std::vector<HalfFacetId> mates;
  std::vector<bool> reversed;
  std::vector<CornerId> a_corner;

  explicit Parts(const Complex<D>& k) : cells(k.cells().begin(), k.cells().end()) {
    for (Index h = 0; h < k.half_facet_count(); ++h)
      mates.push_back(k.mate({h}).value_or(HalfFacetId{kNoIndex}));
    for (Index c = 0; c < k.cell_count(); ++c) reversed.push_back(k.sign({c}) < 0);
    for (Index v = 0; v < k.vertex_count(); ++v)
      a_corner.push_back(k.a_corner({v}).value_or(CornerId{kNoIndex}));
  }
  Complex<D> complex() const {
    return detail::ComplexAccess<D>::make(cells, mates, reversed, a_corner);
  }
  VertexId& vertex(CornerId corner) {
    return cells[cell_of<D>(corner).value][static_cast<std::size_t>(local_index<D>(corner))];
  }
};

TYPED_TEST(VerifyTouched, FindsEachFaultInAStarThatWasTouched) {
  constexpr int D = TypeParam::value;
  auto k = complex_of<D>(kuhn_cube<D>(D <= 2 ? 9 : D == 3 ? 4 : 3));
  const FacetSet all = FacetSet::all(k);
  std::vector<HalfFacetId> some;  // so few that stars keep interior facets
  for (std::size_t n = 0; n < all.size(); n += 3) some.push_back(all.half_facets()[n]);
  const FacetSet cut = FacetSet::of_lesser(some);
  const Relabelling truth = unglue(k, cut);
  ASSERT_FALSE(truth.corners.empty());
  const auto expect_found = [&](const Parts<D>& spoiled, const char* fault) {
    EXPECT_THROW(verify_touched(spoiled.complex(), cut, truth), InvariantBroken) << fault;
  };
  EXPECT_NO_THROW(verify_touched(Parts<D>(k).complex(), cut, truth));

  std::vector<HalfFacetId> around;  // interior facets that contain a renamed corner
  for (const RenamedCorner& renamed : truth.corners)
    for (int i = 0; i <= D; ++i) {
      const auto h = half_facet<D>(cell_of<D>(renamed.corner), i);
      if (h != renamed.corner && k.is_interior(h)) around.push_back(h);
    }
  if constexpr (D > 1) {
    ASSERT_GE(around.size(), 4u);
  }
  for (std::size_t n = 0; n + 1 < around.size(); n += 1 + around.size() / 20) {
    const HalfFacetId h = around[n], mate = *k.mate(h);
    Parts<D> spoiled(k);
    spoiled.mates[mate.value] = {kNoIndex};
    expect_found(spoiled, "one of two mates knows of none");
    spoiled = Parts<D>(k);
    spoiled.reversed[cell_of<D>(h).value].flip();
    expect_found(spoiled, "a cell is the wrong way round");
    spoiled = Parts<D>(k);
    std::swap(spoiled.cells[cell_of<D>(mate).value][0], spoiled.cells[cell_of<D>(mate).value][1]);
    expect_found(spoiled, "two vertices of a cell are exchanged");
    spoiled = Parts<D>(k);
    spoiled.cells[cell_of<D>(h).value][0] = spoiled.cells[cell_of<D>(h).value][1];
    expect_found(spoiled, "a cell has a vertex twice");
    // Of the vertices of the facet, all but one are in the other cell.
    for (int i = 0; i <= D; ++i) {
      const auto corner = half_facet<D>(cell_of<D>(mate), i);
      if (corner == mate) continue;
      spoiled = Parts<D>(k);
      spoiled.vertex(corner) = VertexId{static_cast<Index>(k.vertex_count() - 1)};
      if (spoiled.vertex(corner) == k.vertex(corner)) continue;
      expect_found(spoiled, "mates differ in a vertex");
    }
    const HalfFacetId other = around[n + 1], others_mate = *k.mate(other);
    if (other == h || other == mate) continue;
    spoiled = Parts<D>(k);
    spoiled.mates[h.value] = others_mate;
    spoiled.mates[others_mate.value] = h;
    spoiled.mates[other.value] = mate;
    spoiled.mates[mate.value] = other;
    expect_found(spoiled, "two facets have each other's mates");
  }
  for (const Split& split : truth.splits)
    for (const VertexId v : {split.vertex, split.parent}) {
      const std::vector<CornerId> corners = star(k, v);
      EXPECT_EQ(k.a_corner(v), *std::min_element(corners.begin(), corners.end()));
      Parts<D> spoiled(k);
      spoiled.a_corner[v.value] = *k.a_corner(v == split.vertex ? split.parent : split.vertex);
      expect_found(spoiled, "a vertex names a corner of another");
      if (corners.size() == 1) continue;
      spoiled.a_corner[v.value] = *std::max_element(corners.begin(), corners.end());
      expect_found(spoiled, "a vertex names a corner that is not its least");
    }
}

TYPED_TEST(VerifyTouched, FindsAVertexThatShouldHaveBeenSplit) {
  constexpr int D = TypeParam::value;
  auto k = complex_of<D>(kuhn_cube<D>(D <= 2 ? 5 : 3));
  const FacetSet cut = dense_cut(k);
  const Relabelling truth = unglue(k, cut);
  // The last copy is its parent still, and nothing is said of it.
  const Split last = truth.splits.back();
  Parts<D> spoiled(k);
  Relabelling told = truth;
  told.corners.clear();
  for (const RenamedCorner& renamed : truth.corners)
    if (renamed.to == last.vertex)
      spoiled.vertex(renamed.corner) = last.parent;
    else
      told.corners.push_back(renamed);
  told.splits.pop_back();
  --told.vertices_after;
  spoiled.a_corner.pop_back();
  EXPECT_THROW(verify_touched(spoiled.complex(), cut, told), InvariantBroken);
}

TYPED_TEST(VerifyTouched, WantsOpenedAndShutFacetsOnceEach) {
  constexpr int D = TypeParam::value;
  auto k = complex_of<D>(kuhn_cube<D>(D <= 2 ? 5 : 3));
  const FacetSet cut = dense_cut(k);
  const Relabelling truth = unglue(k, cut);
  Relabelling told = truth;
  told.opened.push_back(told.opened.back());
  EXPECT_THROW(verify_touched(k, cut, told), InvariantBroken) << "one twice";
  told = truth;
  std::swap(told.opened.front(), told.opened.back());
  EXPECT_THROW(verify_touched(k, cut, told), InvariantBroken) << "out of order";
  told = truth;
  told.opened.erase(told.opened.begin());
  EXPECT_THROW(verify_touched(k, cut, told), InvariantBroken) << "the first is missing";
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
