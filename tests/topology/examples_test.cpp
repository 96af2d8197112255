// The figures of the paper, small cuts with a story, and planes in a cube, by their counts.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <initializer_list>
#include <vector>

#include "cleave/support/meshes.hpp"
#include "cleave/support/reference.hpp"
#include "cleave/topology/assemble.hpp"
#include "cleave/topology/certify.hpp"
#include "cleave/topology/check.hpp"
#include "cleave/topology/incision.hpp"
#include "cleave/topology/locate.hpp"
#include "cleave/topology/pieces.hpp"

namespace cleave::topology {
namespace {

/// The complex of these cells, oriented by `orient`.
template <int D>
Complex<D> complex_of(std::vector<Cell<D>> cells, std::size_t vertex_count) {
  CellSoup<D> soup{std::move(cells), vertex_count, {}};
  soup.signs = std::get<0>(orient(soup));
  return assemble(std::move(soup));
}

template <int D>
FacetSet facets(const Complex<D>& k, const std::vector<Facet<D>>& tuples) {
  std::vector<HalfFacetId> found;
  for (const auto& h : locate_facets<D>(k.cells(), tuples)) found.push_back(h.value());
  return FacetSet::of(k, found);
}

/// How many vertices there are now in place of `vertex`.
std::size_t copies_of(const Relabelling& change, VertexId vertex) {
  return 1 + static_cast<std::size_t>(
                 std::count_if(change.splits.begin(), change.splits.end(),
                               [&](const Split& split) { return split.parent == vertex; }));
}

// Six triangles around vertex 0; the ring is 1 .. 6.
Complex<2> fan() {
  std::vector<Cell<2>> cells;
  for (Index i = 1; i <= 6; ++i) cells.push_back({VertexId{0}, {i}, {i % 6 + 1}});
  return complex_of<2>(cells, 7);
}

TEST(Figure6, AsManyCopiesAsComponents) {
  const std::vector<std::vector<Index>> spokes{{}, {1}, {1, 4}, {1, 3, 5}};
  const std::array<std::size_t, 4> components{1, 1, 2, 3};
  for (std::size_t i = 0; i < spokes.size(); ++i) {
    Complex<2> k = fan();
    std::vector<Facet<2>> cut;
    for (const Index ring : spokes[i]) cut.push_back({VertexId{0}, VertexId{ring}});
    const Relabelling change = unglue(k, facets<2>(k, cut), Verify::all);
    EXPECT_EQ(copies_of(change, {0}), components[i]);
    EXPECT_EQ(change.opened.size(), cut.size());  // the ring's vertex lies on the boundary
    EXPECT_EQ(pieces(k).count, components[i]);
  }
}

TEST(Figure7, AnInnerEdgeBetweenInnerVerticesStaysShut) {
  Complex<2> k = complex_of<2>({{{{0}, {1}, {2}}},
                                {{{0}, {2}, {4}}},
                                {{{0}, {4}, {3}}},
                                {{{0}, {3}, {1}}},
                                {{{1}, {3}, {5}}},
                                {{{1}, {5}, {2}}}},
                               6);
  const FacetSet cut = facets<2>(k, {{{{0}, {1}}}});
  const Relabelling change = unglue(k, cut, Verify::all);
  EXPECT_TRUE(change.corners.empty());
  EXPECT_TRUE(change.splits.empty());
  EXPECT_TRUE(change.opened.empty());
  EXPECT_EQ(change.shut.size(), 1U);
  EXPECT_TRUE(k.is_interior(cut.half_facets()[0]));
}

TEST(Figure8, AnEmptyCutSplitsAVertexWhoseStarIsInTwoParts) {
  const CellSoup<2> soup{{{{{0}, {1}, {2}}}, {{{0}, {3}, {4}}}}, 5, {}};
  EXPECT_THROW(assemble(soup), InvalidComplex);
  const auto made = assemble_regularized(soup);
  EXPECT_EQ(made.splits, (std::vector<Split>{{{5}, {0}}}));
  EXPECT_EQ(made.complex.vertices({0}), soup.cells[0]);
  EXPECT_EQ(made.complex.vertices({1}), (Cell<2>{{{5}, {3}, {4}}}));
  EXPECT_TRUE(check<2>({soup.cells, 5, {}}, Level::pseudo_manifold).empty());
}

// A tetrahedron split 1 to 4 at vertex 4: the smallest solid form of Figure 7.
Complex<3> split_tetrahedron() {
  return complex_of<3>({{{{0}, {1}, {2}, {4}}},
                        {{{0}, {1}, {3}, {4}}},
                        {{{0}, {2}, {3}, {4}}},
                        {{{1}, {2}, {3}, {4}}}},
                       5);
}

TEST(SplitTetrahedron, OneInnerFacetOpensNothing) {
  const std::vector<Facet<3>> inner{{{{0}, {1}, {4}}}, {{{0}, {2}, {4}}}, {{{0}, {3}, {4}}},
                                    {{{1}, {2}, {4}}}, {{{1}, {3}, {4}}}, {{{2}, {3}, {4}}}};
  for (const Facet<3>& facet : inner) {
    Complex<3> k = split_tetrahedron();
    const Relabelling change = unglue(k, facets<3>(k, {facet}), Verify::all);
    EXPECT_TRUE(change.splits.empty());
    EXPECT_EQ(change.shut.size(), 1U);
  }
}

/// Two cuts that open nothing apart and something together: `split` vertices, `opened` facets.
template <int D>
void expect_together(const Complex<D>& start, const Facet<D>& first, const Facet<D>& second,
                     std::size_t split, std::size_t opened) {
  const FacetSet one = facets<D>(start, {first});
  const FacetSet other = facets<D>(start, {second});
  for (const FacetSet& alone : {one, other}) {
    Complex<D> k = start;
    EXPECT_TRUE(unglue(k, alone, Verify::all).splits.empty());
  }
  Complex<D> k = start;
  const Relabelling together = unglue(k, one | other, Verify::all);
  EXPECT_EQ(together.splits.size(), split);
  EXPECT_EQ(together.opened.size(), opened);

  Complex<D> forgetful = start;
  unglue(forgetful, one);
  EXPECT_TRUE(unglue(forgetful, other, Verify::all).splits.empty());

  Incision<D> incision(start);
  EXPECT_EQ(incision.cut(one).shut, std::vector<HalfFacetId>{one.half_facets()[0]});
  const Relabelling second_stage = incision.cut(other, Verify::all);
  EXPECT_EQ(second_stage.opened, together.opened);
  EXPECT_EQ(incision.scored(), one | other);
  EXPECT_TRUE(std::equal(k.cells().begin(), k.cells().end(), incision.complex().cells().begin()));
  EXPECT_FALSE(certify<D>(start.cells(), (one | other).half_facets(), incision.complex().cells()));

  Incision<D> forgets(start);
  forgets.cut(one);
  forgets.forget_shut(one);
  EXPECT_TRUE(forgets.cut(other).opened.empty());
}

TEST(SplitTetrahedron, TwoInnerFacetsOpenTogether) {
  const Complex<3> k = split_tetrahedron();
  // Both contain the edge 0-4; corner 0 lies on the boundary, and its cell 0-1-2-4 is cut off
  // there.
  expect_together<3>(k, {{{0}, {1}, {4}}}, {{{0}, {2}, {4}}}, 1, 2);
}

TEST(Strip, TwoEdgesOpenTogether) {
  const Complex<2> k = complex_of<2>({{{{0}, {1}, {3}}},
                                      {{{1}, {2}, {3}}},
                                      {{{0}, {1}, {4}}},
                                      {{{1}, {2}, {4}}},
                                      {{{0}, {3}, {5}}},
                                      {{{0}, {4}, {5}}},
                                      {{{2}, {3}, {6}}},
                                      {{{2}, {4}, {6}}}},
                                     7);
  expect_together<2>(k, {{{0}, {1}}}, {{{1}, {2}}}, 1, 2);
}

// Why Theorem C asks more than an even number of cut facets at every ridge: the torus with seven
// vertices, joined to the tips 7 and 8, and three facets from a cycle that does not part the torus
// to the tip 7.
TEST(TheoremC, TheSuspendedTorusStaysShut) {
  std::vector<Cell<3>> cells;
  for (const Index tip : {7U, 8U})
    for (Index i = 0; i < 7; ++i)
      for (const Index step : {1U, 2U})
        cells.push_back({VertexId{i}, {(i + step) % 7}, {(i + 3) % 7}, {tip}});
  Complex<3> k = complex_of<3>(cells, 9);
  EXPECT_EQ(k.cell_count(), 28U);
  const FacetSet cut = facets<3>(k, {{{{0}, {1}, {7}}}, {{{1}, {2}, {7}}}, {{{0}, {2}, {7}}}});
  std::size_t at_tip = 0;
  const std::vector<HalfFacetId> asked(cut.half_facets().begin(), cut.half_facets().end());
  for (const auto& [ridge, degree] : support::ridge_degrees<3>(k.cells(), asked))
    if (ridge.back() == VertexId{7}) {
      EXPECT_EQ(degree, 2U);
      ++at_tip;
    }
  EXPECT_EQ(at_tip, 3U);
  const Relabelling change = unglue(k, cut, Verify::all);
  EXPECT_TRUE(change.splits.empty());
  EXPECT_TRUE(change.opened.empty());
  EXPECT_EQ(change.shut.size(), 3U);
}

/// Cuts in the Kuhn cube of 7^3 vertices (0..6)^3.
class KuhnCube : public ::testing::Test {
 protected:
  using Point = std::array<int, 3>;
  using Place = std::function<bool(const Point&)>;

  /// Vertices that the cut along all interior facets within one of `places` adds.
  std::size_t new_vertices(std::initializer_list<Place> places) {
    std::vector<HalfFacetId> asked;
    for (Index h = 0; h < cube_.half_facet_count(); ++h)
      if (cube_.is_interior({h}) && std::any_of(places.begin(), places.end(),
                                                [&](const Place& p) { return lies_in({h}, p); }))
        asked.push_back({h});
    Complex<3> k = cube_;
    const FacetSet cut = FacetSet::of(k, asked);
    EXPECT_FALSE(cut.empty());
    const Relabelling change = unglue(k, cut, Verify::all);
    shut_ = change.shut.size();
    EXPECT_FALSE(certify<3>(cube_.cells(), asked, k.cells()));
    pieces_ = pieces(k).count;
    return change.splits.size();
  }

  bool lies_in(HalfFacetId h, const Place& place) const {
    const Facet<3> facet = cube_.facet(h);
    return std::all_of(facet.begin(), facet.end(),
                       [&](VertexId v) { return place(grid_.point(v)); });
  }

  support::KuhnGrid<3> grid_{{7, 7, 7}};
  Complex<3> cube_ = complex_of<3>(grid_.cells, grid_.vertex_count);
  std::size_t pieces_ = 0;
  std::size_t shut_ = 0;
};

TEST_F(KuhnCube, APlaneGets49) {
  EXPECT_EQ(new_vertices({[](const Point& p) { return p[0] == 3; }}), 49U);
  EXPECT_EQ(pieces_, 2U);
  EXPECT_EQ(shut_, 0U);
}

TEST_F(KuhnCube, HalfAPlaneGets21) {
  EXPECT_EQ(new_vertices({[](const Point& p) { return p[0] == 3 && p[1] <= 3; }}), 21U);
  EXPECT_EQ(pieces_, 1U);
  EXPECT_EQ(shut_, 0U);
}

TEST_F(KuhnCube, ATJunctionGets77) {
  EXPECT_EQ(new_vertices({[](const Point& p) { return p[0] == 3; },
                          [](const Point& p) { return p[2] == 3 && p[0] >= 3; }}),
            77U);
  EXPECT_EQ(pieces_, 3U);
  EXPECT_EQ(shut_, 0U);
}

TEST_F(KuhnCube, AnXJunctionGets105) {
  EXPECT_EQ(new_vertices({[](const Point& p) { return p[0] == 3; },
                          [](const Point& p) { return p[2] == 3; }}),
            105U);
  EXPECT_EQ(pieces_, 4U);
  EXPECT_EQ(shut_, 0U);
}

TEST_F(KuhnCube, ThreePlanesGet169) {
  EXPECT_EQ(new_vertices({[](const Point& p) { return p[0] == 3; },
                          [](const Point& p) { return p[1] == 3; },
                          [](const Point& p) { return p[2] == 3; }}),
            169U);
  EXPECT_EQ(pieces_, 8U);
  EXPECT_EQ(shut_, 0U);
}

TEST_F(KuhnCube, ABoxInsideGets26) {
  const auto in_box = [](const Point& p) {
    return std::all_of(p.begin(), p.end(), [](int x) { return 2 <= x && x <= 4; });
  };
  const auto side = [&](std::size_t axis, int at) {
    return [=](const Point& p) { return in_box(p) && p[axis] == at; };
  };
  EXPECT_EQ(new_vertices({side(0, 2), side(0, 4), side(1, 2), side(1, 4), side(2, 2), side(2, 4)}),
            26U);
  EXPECT_EQ(pieces_, 2U);
  EXPECT_EQ(shut_, 0U);
}

TEST_F(KuhnCube, ATJunctionThatFloatsInsideGets15) {
  const auto within = [](int x) { return 1 <= x && x <= 5; };
  EXPECT_EQ(new_vertices({[&](const Point& p) { return p[0] == 3 && within(p[1]) && within(p[2]); },
                          [&](const Point& p) {
                            return p[2] == 3 && 3 <= p[0] && p[0] <= 5 && within(p[1]);
                          }}),
            15U);
  EXPECT_EQ(pieces_, 1U);
  EXPECT_EQ(shut_, 3U);  // triangles in corners of the sheets, whose vertices all lie on the rim
}

}  // namespace
}  // namespace cleave::topology
