// What a cut asks of the heap: little, and when it gets none, nothing has happened.
#include <gtest/gtest.h>

#include "cleave/support/heap.hpp"
#include "cleave/topology/incision.hpp"
#include "cleave/topology/unglue.hpp"
#include "view_laws.hpp"

namespace cleave::views {
namespace {

template <class Dimension>
class Memory : public ::testing::Test {};
TYPED_TEST_SUITE(Memory, Dimensions);

/// All that can be seen of a complex.
template <int D>
struct Sight {
  std::vector<Cell<D>> cells;
  std::vector<std::optional<HalfFacetId>> mates;
  std::vector<std::optional<CornerId>> corners;  // that its vertices name
  friend bool operator==(const Sight&, const Sight&) = default;
};

template <int D>
Sight<D> sight_of(const Complex<D>& k) {
  Sight<D> sight{{k.cells().begin(), k.cells().end()}, {}, {}};
  for (std::uint32_t h = 0; h < k.half_facet_count(); ++h) sight.mates.push_back(k.mate({h}));
  for (std::uint32_t v = 0; v < k.vertex_count(); ++v) sight.corners.push_back(k.a_corner({v}));
  return sight;
}

TYPED_TEST(Memory, UnglueThatRunsOutOfItChangesNothing) {
  constexpr int D = TypeParam::value;
  const auto before = complex_of<D>(kuhn_cube<D>(D <= 2 ? 5 : 3));
  const FacetSet cut = dense_cut(before);
  const Sight<D> sight = sight_of(before);
  for (const Verify verify : {Verify::none, Verify::touched, Verify::all}) {
    Complex<D> k = before;
    const std::size_t needed = support::run_out_of_memory([&] { unglue(k, cut, verify); },
                                                          [&] { return sight_of(k) == sight; });
    EXPECT_GT(needed, verify == Verify::none ? 5u : 10u);
    Complex<D> at_once = before;
    ASSERT_FALSE(unglue(at_once, cut).splits.empty());
    EXPECT_EQ(sight_of(k), sight_of(at_once));
  }
}

TYPED_TEST(Memory, AnIncisionThatRunsOutOfItChangesNothing) {
  constexpr int D = TypeParam::value;
  const auto original = complex_of<D>(kuhn_cube<D>(D <= 2 ? 5 : 3));
  const FacetSet cut = dense_cut(original);
  std::vector<HalfFacetId> half;
  for (std::size_t i = 0; i < cut.size(); i += 2) half.push_back(cut.half_facets()[i]);
  Incision<D> staged(original);
  staged.cut(FacetSet::of_lesser(half));

  const Sight<D> sight = sight_of(staged.complex());
  const auto opened = staged.opened();
  const FacetSet shut = staged.shut();
  const std::size_t needed =
      support::run_out_of_memory([&] { staged.cut(cut); },
                                 [&] {
                                   EXPECT_EQ(sight_of(staged.complex()), sight);
                                   EXPECT_EQ(staged.opened(), opened);
                                   EXPECT_EQ(staged.shut(), shut);
                                 });
  EXPECT_GT(needed, 15u);
  Incision<D> at_once(original);
  at_once.cut(cut);
  EXPECT_EQ(staged.scored(), at_once.scored());
  EXPECT_EQ(staged.shut(), at_once.shut());
  const auto one = canonical(staged), other = canonical(at_once);
  for (std::uint32_t c = 0; c < original.half_facet_count(); ++c)
    ASSERT_EQ(one[staged.complex().vertex({c}).value], other[at_once.complex().vertex({c}).value]);
}

/// All that can be seen of an incision.
template <int D>
struct IncisionSight {
  Sight<D> complex;
  std::vector<OpenedFacet> opened;
  FacetSet shut;
  std::vector<VertexId> originals;
  bool can_undo, can_redo;
  friend bool operator==(const IncisionSight&, const IncisionSight&) = default;
};

template <int D>
IncisionSight<D> sight_of(const Incision<D>& incision) {
  IncisionSight<D> sight{sight_of(incision.complex()), incision.opened(),  incision.shut(), {},
                         incision.can_undo(),          incision.can_redo()};
  for (std::uint32_t v = 0; v < incision.complex().vertex_count(); ++v)
    sight.originals.push_back(incision.original({v}));
  return sight;
}

TYPED_TEST(Memory, AStitchThatRunsOutOfItChangesNothing) {
  constexpr int D = TypeParam::value;
  const auto original = complex_of<D>(kuhn_cube<D>(D <= 2 ? 5 : 3));
  const FacetSet cut = dense_cut(original);
  std::vector<HalfFacetId> third;
  for (std::size_t i = 0; i < cut.size(); i += 3) third.push_back(cut.half_facets()[i]);
  const FacetSet taken_back = FacetSet::of_lesser(third);
  for (const Verify verify : {Verify::none, Verify::touched, Verify::all}) {
    Incision<D> incision(original);
    incision.cut(cut);
    const auto before = sight_of(incision);
    const auto still = [&] { EXPECT_EQ(sight_of(incision), before); };
    Relabelling change;
    const std::size_t needed =
        support::run_out_of_memory([&] { change = incision.stitch(taken_back, verify); }, still);
    EXPECT_GT(needed, 8u);
    EXPECT_FALSE(change.merges.empty());
    Incision<D> at_once(original);
    at_once.cut(cut - taken_back);
    const auto one = canonical(incision), other = canonical(at_once);
    for (std::uint32_t c = 0; c < original.half_facet_count(); ++c)
      ASSERT_EQ(one[incision.complex().vertex({c}).value],
                other[at_once.complex().vertex({c}).value]);

    // Taken back and done again with ids in use and free ones.
    const auto after = sight_of(incision);
    support::run_out_of_memory([&] { incision.undo(verify); },
                               [&] { EXPECT_EQ(sight_of(incision), after); });
    const auto undone = sight_of(incision);
    EXPECT_EQ(undone.opened, before.opened);
    support::run_out_of_memory([&] { incision.redo(verify); },
                               [&] { EXPECT_EQ(sight_of(incision), undone); });
    EXPECT_EQ(incision.shut(), after.shut);
    EXPECT_EQ(incision.opened(), after.opened);
  }
}

/// The most bytes that a cut along all interior facets around the middle vertex of a grid holds.
template <int D>
std::size_t most_held(int nodes) {
  const auto grid = kuhn_cube<D>(nodes);
  typename support::KuhnGrid<D>::Point middle{};
  middle.fill(nodes / 2);
  const auto k = complex_of<D>(grid);
  std::vector<HalfFacetId> around;
  for (const CornerId corner : star(k, grid.vertex(middle)))
    for (int i = 0; i <= D; ++i) {
      const auto h = half_facet<D>(cell_of<D>(corner), i);
      if (h != corner && k.is_interior(h)) around.push_back(h);
    }
  const FacetSet cut = FacetSet::of(k, around);
  Incision<D> incision(k);
  const std::size_t before = support::heap_bytes();
  support::forget_heap_peak();
  const auto change = incision.cut(cut);
  const std::size_t held = support::heap_peak() - before;
  EXPECT_FALSE(change.splits.empty());
  return held;
}

// The hash tables of the verification differ a little with the numbers of the cells.
TYPED_TEST(Memory, ACutTakesAsMuchInALargeMeshAsInASmallOne) {
  constexpr int D = TypeParam::value;
  constexpr int small[] = {5, 5, 5, 4}, large[] = {20000, 140, 17, 7};
  EXPECT_LE(most_held<D>(large[D - 1]), 2 * most_held<D>(small[D - 1]));
}

}  // namespace
}  // namespace cleave::views
