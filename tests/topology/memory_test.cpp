// What a cut asks of the heap: little, and when it gets none, nothing has happened.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "cleave/support/heap.hpp"
#include "cleave/topology/incision.hpp"
#include "cleave/topology/properties.hpp"
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
  for (Index h = 0; h < k.half_facet_count(); ++h) sight.mates.push_back(k.mate({h}));
  for (Index v = 0; v < k.vertex_count(); ++v) sight.corners.push_back(k.a_corner({v}));
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
  for (Index v = 0; v < incision.complex().vertex_count(); ++v)
    sight.originals.push_back(incision.original({v}));
  return sight;
}

/// Lets `step` run out of memory after 0, 1, 2, .. allocations, each time on a fresh copy of
/// `incision`, which has no memory of earlier calls, until there is enough; nothing must have
/// happened before. `incision` has undergone the step then. Returns how many allocations it took.
template <int D, class Step>
std::size_t run_out_of_memory(Incision<D>& incision, Step step) {
  const IncisionSight<D> before = sight_of(incision);
  for (std::size_t allocations = 0;; ++allocations) {
    Incision<D> fresh = incision;
    try {
      const support::MemoryLimit limit(allocations);
      step(fresh);
    } catch (const std::bad_alloc&) {
      EXPECT_EQ(sight_of(fresh), before) << allocations;
      continue;
    }
    incision = std::move(fresh);
    return allocations;
  }
}

/// Every n-th facet of a set.
FacetSet every(std::size_t n, const FacetSet& facets) {
  std::vector<HalfFacetId> some;
  for (std::size_t i = 0; i < facets.size(); i += n) some.push_back(facets.half_facets()[i]);
  return FacetSet::of_lesser(some);
}

/// That two incisions are the same but for the ids of copies.
template <int D>
void expect_same_state(const Incision<D>& one, const Incision<D>& other) {
  EXPECT_EQ(one.scored(), other.scored());
  EXPECT_EQ(one.shut(), other.shut());
  const auto here = canonical(one), there = canonical(other);
  for (Index c = 0; c < one.complex().half_facet_count(); ++c)
    ASSERT_EQ(here[one.complex().vertex({c}).value], there[other.complex().vertex({c}).value]);
}

TYPED_TEST(Memory, AnIncisionThatRunsOutOfItChangesNothing) {
  constexpr int D = TypeParam::value;
  const auto original = complex_of<D>(kuhn_cube<D>(D <= 2 ? 5 : 3));
  const FacetSet cut = dense_cut(original);
  Incision<D> staged(original);
  staged.cut(every(2, cut));
  EXPECT_GT(run_out_of_memory(staged, [&](Incision<D>& incision) { incision.cut(cut); }), 10u);
  Incision<D> at_once(original);
  at_once.cut(cut);
  expect_same_state(staged, at_once);
}

TYPED_TEST(Memory, AStitchThatRunsOutOfItChangesNothing) {
  constexpr int D = TypeParam::value;
  const auto original = complex_of<D>(kuhn_cube<D>(D <= 2 ? 5 : 3));
  const FacetSet cut = dense_cut(original), taken_back = every(3, cut);
  for (const Verify verify : {Verify::none, Verify::touched, Verify::all}) {
    Incision<D> incision(original);
    incision.cut(cut);
    const auto before = sight_of(incision);
    Relabelling change;
    EXPECT_GT(
        run_out_of_memory(incision, [&](Incision<D>& i) { change = i.stitch(taken_back, verify); }),
        8u);
    EXPECT_FALSE(change.merges.empty());
    Incision<D> at_once(original);
    at_once.cut(cut - taken_back);
    expect_same_state(incision, at_once);

    // Taken back and done again with ids in use and free ones.
    const auto after = sight_of(incision);
    run_out_of_memory(incision, [&](Incision<D>& i) { i.undo(verify); });
    EXPECT_EQ(incision.opened(), before.opened);
    run_out_of_memory(incision, [&](Incision<D>& i) { i.redo(verify); });
    EXPECT_EQ(incision.shut(), after.shut);
    EXPECT_EQ(incision.opened(), after.opened);
  }
}

// With the memory of earlier calls at hand, too.
TYPED_TEST(Memory, AWarmIncisionThatRunsOutOfItChangesNothing) {
  constexpr int D = TypeParam::value;
  const auto original = complex_of<D>(kuhn_cube<D>(D <= 2 ? 5 : 3));
  const FacetSet cut = dense_cut(original);
  Incision<D> incision(original);
  incision.cut(every(3, cut));
  incision.stitch(every(6, cut));
  for (const auto& step : std::vector<std::function<void()>>{
           [&] { incision.cut(cut); }, [&] { incision.stitch(every(2, cut)); },
           [&] { incision.undo(); }, [&] { incision.redo(); }}) {
    const auto before = sight_of(incision);
    support::run_out_of_memory(step, [&] { EXPECT_EQ(sight_of(incision), before); });
  }
  Incision<D> at_once(original);
  at_once.cut(cut - every(2, cut));
  expect_same_state(incision, at_once);
}

TYPED_TEST(Memory, PropertiesThatRunOutOfItAllStay) {
  constexpr int D = TypeParam::value;
  Incision<D> incision(complex_of<D>(kuhn_cube<D>(D <= 2 ? 5 : 3)));
  VertexProperties properties(incision.complex().vertex_count());
  const auto& number = properties.add_constant("number", 7);
  const auto& name = properties.add_constant("name", std::string(40, 'x'));  // copies allocate
  const auto follow = [&](const Relabelling& change) {
    const auto numbers = number.values();
    const auto names = name.values();
    const std::size_t needed = support::run_out_of_memory([&] { properties.follow(change); },
                                                          [&] {
                                                            EXPECT_EQ(number.values(), numbers);
                                                            EXPECT_EQ(name.values(), names);
                                                          });
    EXPECT_GT(needed, 0u);
    EXPECT_EQ(number.values(), std::vector<int>(incision.complex().vertex_count(), 7));
    EXPECT_EQ(name.values(),
              std::vector<std::string>(incision.complex().vertex_count(), std::string(40, 'x')));
  };
  follow(incision.cut(dense_cut(incision.complex())));
  follow(incision.undo());
}

/// How many allocations the calls of a round take in the third round and later.
template <class Round>
std::size_t allocations_in_steady_state(Round round) {
  round();
  round();
  const std::size_t before = support::allocations();
  for (int n = 0; n < 5; ++n) round();
  return support::allocations() - before;
}

TYPED_TEST(Memory, CutsAndStitchesInSteadyStateAskForNone) {
  constexpr int D = TypeParam::value;
  const auto original = complex_of<D>(kuhn_cube<D>(D <= 2 ? 5 : 3));
  const FacetSet cut = dense_cut(original), third = every(3, cut), half = every(2, cut);
  std::vector<HalfFacetId> named(cut.half_facets().begin(), cut.half_facets().end());
  std::reverse(named.begin(), named.end());
  for (const Verify verify : {Verify::none, Verify::touched}) {
    Incision<D> incision(original);
    VertexProperties properties(incision.complex().vertex_count());
    const auto& number = properties.add_constant("number", 7);
    const auto& weight = properties.add_constant("weight", 1.0, merging::Sum{});
    properties.add_constant("heat", 2.0, merging::MeanBy{weight});
    Relabelling change;
    FacetSet facets;
    const auto follow = [&] { properties.follow(change); };
    EXPECT_EQ(allocations_in_steady_state([&] {
                incision.facets(named, facets);
                incision.cut(facets, change, verify);
                follow();
                incision.stitch(third, change, verify);  // leaves free ids
                follow();
                incision.cut(half, change, verify);
                follow();
                for (int n = 0; n < 3; ++n) incision.undo(change, verify), follow();
                for (int n = 0; n < 3; ++n) incision.redo(change, verify), follow();
                incision.stitch(cut, change, verify);
                follow();
                incision.forget_steps();
              }),
              0u);
    EXPECT_EQ(number.values(), std::vector<int>(original.vertex_count(), 7));

    incision.keep_steps(2);
    EXPECT_EQ(allocations_in_steady_state([&] {
                for (int n = 0; n < 10; ++n) {
                  incision.cut(third, change, verify);
                  incision.cut(cut, change, verify);
                  incision.stitch(half, change, verify);
                  incision.stitch(cut, change, verify);
                }
              }),
              0u);
    incision.undo();
    incision.undo();
    EXPECT_FALSE(incision.can_undo());
    EXPECT_EQ(incision.scored(), cut);
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
