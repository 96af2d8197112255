// Small stitches with a story. What holds for every stitch is in incision_states_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cleave/topology/carry_over.hpp"
#include "cleave/topology/incision.hpp"
#include "cleave/topology/pieces.hpp"
#include "view_laws.hpp"

namespace cleave::views {
namespace {

/// The interior facets of a grid all of whose vertices lie in `place`.
template <int D, class Place>
FacetSet facets_in(const Complex<D>& k, const support::KuhnGrid<D>& grid, Place place) {
  std::vector<HalfFacetId> found;
  for (Index h = 0; h < k.half_facet_count(); ++h) {
    const Facet<D> facet = k.facet({h});
    if (k.is_interior({h}) &&
        std::all_of(facet.begin(), facet.end(), [&](VertexId v) { return place(grid.point(v)); }))
      found.push_back({h});
  }
  return FacetSet::of(k, found);
}

/// A cube of 5^3 vertices (0..4)^3, and cuts in it.
class StitchInACube : public ::testing::Test {
 protected:
  using Point = support::KuhnGrid<3>::Point;

  std::vector<Cell<3>> cells() const {
    return {incision_.complex().cells().begin(), incision_.complex().cells().end()};
  }

  support::KuhnGrid<3> grid_ = kuhn_cube<3>(5);
  Complex<3> cube_ = complex_of<3>(grid_);
  Incision<3> incision_{cube_};
  FacetSet wall_ = facets_in(cube_, grid_, [](const Point& p) { return p[0] == 2; });
  FacetSet stem_ = facets_in(cube_, grid_, [](const Point& p) { return p[2] == 2 && p[0] >= 2; });
};

TEST_F(StitchInACube, TheStemOfATLeavesTheWall) {
  incision_.cut(wall_ | stem_);
  EXPECT_EQ(pieces(incision_.complex()).count, 3u);
  const Relabelling change = incision_.stitch(stem_, Verify::all);
  EXPECT_EQ(pieces(incision_.complex()).count, 2u);
  EXPECT_EQ(change.closed.size(), stem_.size());
  EXPECT_EQ(change.merges.size(), 15u);  // 5 x 3 vertices, the seam with the wall among them
  EXPECT_TRUE(change.opened.empty());
  EXPECT_TRUE(change.shut.empty());
  EXPECT_TRUE(change.splits.empty());
}

TEST_F(StitchInACube, TheWallOfATLeavesHalfAPlane) {
  incision_.cut(wall_ | stem_);
  const Relabelling change = incision_.stitch(wall_, Verify::all);
  EXPECT_EQ(pieces(incision_.complex()).count, 1u);
  // The 5 vertices of the seam were three each and are one, as the rim of half a plane is.
  EXPECT_EQ(change.merges.size(), 20u + 10u);
  Incision<3> stem_alone(cube_);
  stem_alone.cut(stem_);
  EXPECT_EQ(incision_.opened(), stem_alone.opened());
  EXPECT_TRUE(incision_.shut().empty());
}

TEST_F(StitchInACube, AClosedShellIsTakenBack) {
  FacetSet box;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const int side : {1, 3})
      box = box | facets_in(cube_, grid_, [&](const Point& p) {
              return p[axis] == side &&
                     std::all_of(p.begin(), p.end(), [](int x) { return 1 <= x && x <= 3; });
            });
  incision_.cut(box);
  ASSERT_EQ(pieces(incision_.complex()).count, 2u);
  EXPECT_EQ(incision_.stitch(box, Verify::all).merges.size(), 26u);
  EXPECT_EQ(pieces(incision_.complex()).count, 1u);
  EXPECT_TRUE(
      std::equal(cube_.cells().begin(), cube_.cells().end(), incision_.complex().cells().begin()));
  EXPECT_EQ(incision_.complex().vertex_count(), cube_.vertex_count());
}

TEST_F(StitchInACube, TheLastCutTakenBackGivesTheVeryIds) {
  incision_.cut(wall_);
  const auto before = cells();
  const auto there = incision_.cut(stem_);
  const auto back = incision_.stitch(stem_);
  EXPECT_EQ(cells(), before);
  const auto expected = inverse(there);
  EXPECT_EQ(back.corners, expected.corners);
  EXPECT_EQ(back.merges, expected.merges);
  EXPECT_EQ(back.closed, expected.closed);
  EXPECT_EQ(back.vertices_after, expected.vertices_after);
}

TEST_F(StitchInACube, IdsAreUsedAgain) {
  incision_.cut(wall_ | stem_);
  const std::size_t most = incision_.complex().vertex_count();
  std::vector<Cell<3>> second;
  for (int cycle = 0; cycle < 2000; ++cycle) {  // alternating, so that the ends never free up
    incision_.stitch(wall_, Verify::none);
    incision_.cut(wall_, Verify::none);
    incision_.stitch(stem_, Verify::none);
    incision_.cut(stem_, Verify::none);
    ASSERT_LE(incision_.complex().vertex_count(), most);
    if (cycle == 1) second = cells();
  }
  incision_.forget_steps();
  EXPECT_FALSE(incision_.can_undo());
  verify_all(incision_.complex());
  Incision<3> fresh(cube_);
  fresh.cut(wall_ | stem_);
  EXPECT_TRUE(support::same_partition<3>(cells(), fresh.complex().cells()));
}

TEST_F(StitchInACube, NothingScoredMeansNothingChanges) {
  incision_.cut(wall_);
  incision_.undo();
  const Relabelling change = incision_.stitch(wall_ | stem_);
  EXPECT_TRUE(change.corners.empty() && change.closed.empty() && change.shut.empty());
  EXPECT_TRUE(incision_.can_redo());  // it was no step
  incision_.cut(stem_);
  EXPECT_FALSE(incision_.can_redo());
  EXPECT_THROW(incision_.redo(), std::logic_error);
  incision_.undo();
  EXPECT_THROW(incision_.undo(), std::logic_error);
}

// Figure 7: of three edges from the boundary vertex 0 to inner ones, each alone is shut; together
// they open. Taken back one by one they shut the others again.
TEST(StitchFigure7, OneOfTwoShutsTheOther) {
  const support::Mesh<2> mesh{{{{{0}, {1}, {3}}},
                               {{{1}, {2}, {3}}},
                               {{{0}, {1}, {4}}},
                               {{{1}, {2}, {4}}},
                               {{{0}, {3}, {5}}},
                               {{{0}, {4}, {5}}},
                               {{{2}, {3}, {6}}},
                               {{{2}, {4}, {6}}}},
                              7};
  Incision<2> incision(complex_of(mesh));
  const auto edge = [&](Index a, Index b) {
    for (Index h = 0; h < incision.complex().half_facet_count(); ++h)
      if (ascending(incision.complex().facet({h})) == Vertices{{a}, {b}})
        return incision.facets(std::vector{HalfFacetId{h}});
    return FacetSet();
  };
  const FacetSet one = edge(0, 1), other = edge(1, 2);
  incision.cut(one | other);
  ASSERT_EQ(incision.opened().size(), 2u);
  const Relabelling change = incision.stitch(one, Verify::all);
  EXPECT_TRUE(incision.opened().empty());
  EXPECT_EQ(incision.shut(), other);
  EXPECT_EQ(FacetSet::of_lesser(change.shut), other);
  EXPECT_EQ(change.closed.size(), 2u);
  ASSERT_EQ(change.merges.size(), 1u);
  EXPECT_EQ(change.merges[0].into, VertexId{1});
  EXPECT_EQ(change.closed[0].by, VertexId{1});
  EXPECT_EQ(change.closed[1].by, VertexId{1});
  EXPECT_EQ(incision.undo(Verify::all).opened.size(), 2u);  // the step was one facet, two open
}

TEST(CarryOverMerges, ValuesThatMustBeEqualAreAskedToBe) {
  std::vector<int> equal{7, 8, 9, 8, 8, 7};
  carry_over(equal, some_merges());
  EXPECT_EQ(equal, (std::vector{7, 8, 9}));

  std::vector<int> unequal{7, 8, 9, 8, 5, 7};
  const auto before = unequal;
  EXPECT_EQ(conflicts(unequal, std::span<const Merge>(some_merges().merges)),
            (std::vector<Merge>{{{4}, {1}}}));
  try {
    carry_over(unequal, some_merges());
    FAIL() << "merged";
  } catch (const UnequalValues& error) {
    EXPECT_EQ(error.kept, VertexId{1});
    EXPECT_EQ(error.gone, VertexId{4});
    EXPECT_STREQ(error.what(), "vertices 1 and 4 are to be merged, but their values differ");
  }
  EXPECT_EQ(unequal, before);
}

TEST(CarryOverMerges, ForcesAddUp) {
  std::vector<double> force{1, 2, 4, 8, 16, 32};
  carry_over(force, some_merges(), merging::Sum{});
  EXPECT_EQ(force, (std::vector<double>{33, 26, 4}));
}

TEST(CarryOverMerges, DisplacementsTakeTheirMeanByWeight) {
  const std::vector<double> weights{1, 1, 1, 2, 1, 0};
  std::vector<double> u{5, 4, 6, 8, 12, 1000};
  carry_over(u, some_merges(), merging::Mean{weights});
  EXPECT_EQ(u, (std::vector<double>{5, 8, 6}));
  std::vector<double> weightless{5, 3, 6, 6, 9, 7};
  carry_over(weightless, some_merges(), merging::Mean{std::vector<double>(6, 0.0)});
  EXPECT_DOUBLE_EQ(weightless[0], 6.0);
  EXPECT_DOUBLE_EQ(weightless[1], 6.0);
}

TEST(CarryOverMerges, MovedPointsAreRestored) {
  std::vector<double> point{5, 4, 6, 4, 4.5, 5};
  carry_over(point, some_merges(),
             merging::Restored{[](VertexId v) { return 100.0 + double(v.value); }});
  EXPECT_EQ(point, (std::vector<double>{5, 101, 6}));
}

TEST(CarryOverMerges, ASetKeepsTheVertexThatStays) {
  std::vector<VertexId> set{{0}, {2}, {3}, {4}};
  carry_over_set(set, some_merges());
  EXPECT_EQ(set, (std::vector<VertexId>{{0}, {1}, {2}}));
}

}  // namespace
}  // namespace cleave::views
