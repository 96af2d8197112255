// Each kind of violation by hand, with its witness; what assemble throws; sizes; signs for D = 1.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>

#include "cleave/support/defects.hpp"
#include "cleave/support/meshes.hpp"
#include "cleave/support/random_meshes.hpp"
#include "cleave/topology/assemble.hpp"
#include "cleave/topology/check.hpp"
#include "witness.hpp"

namespace cleave::topology {
namespace {

/// The only violation of `soup` up to `level`, which must be of this kind and stand re-checking.
template <class Kind, int D>
Kind only(const CellSoup<D>& soup, Level level = Level::manifold) {
  const auto found = check(soup, level);
  EXPECT_EQ(found.size(), 1U);
  for (const Violation& violation : found) EXPECT_EQ(refute<D>(violation, soup), "");
  return std::get<Kind>(found.at(0));
}

CellSoup<2> square() { return {{{{{0}, {1}, {2}}}, {{{0}, {2}, {3}}}}, 4, {}}; }

TEST(Check, ASoundMeshHasNoViolation) {
  EXPECT_TRUE(check(square()).empty());
  EXPECT_TRUE(check(CellSoup<3>{}).empty());
  EXPECT_EQ(level_reached(2, {}), Level::manifold);
  EXPECT_EQ(level_reached(4, {}), Level::edge_regular);
}

TEST(Check, DegenerateCell) {
  auto soup = square();
  soup.cells[1][1] = {0};
  soup.vertex_count = 4;
  const auto found = check(soup);
  ASSERT_EQ(found.size(), 1U);
  const auto v = std::get<DegenerateCell>(found[0]);
  EXPECT_EQ(v.cell, CellId{1});
  EXPECT_EQ(v.repeated, VertexId{0});
  EXPECT_EQ(rule(found[0]), "degenerate-cell");
  EXPECT_EQ(level_reached(2, found), Level::none);
}

TEST(Check, VertexOutOfRange) {
  auto soup = square();
  soup.cells[1][2] = {4};
  soup.vertex_count = 3;
  const auto v = only<VertexOutOfRange>(soup);
  EXPECT_EQ(v.cell, CellId{1});
  EXPECT_EQ(v.vertex, VertexId{4});
}

TEST(Check, DuplicateCell) {
  const CellSoup<2> soup{{{{{0}, {1}, {2}}}, {{{2}, {0}, {1}}}}, 3, {}};
  const auto v = only<DuplicateCell>(soup);
  EXPECT_EQ(v.first, CellId{0});
  EXPECT_EQ(v.second, CellId{1});
}

TEST(Check, FacetInThreeCells) {
  auto soup = square();
  soup.cells.push_back({{{2}, {4}, {0}}});
  soup.vertex_count = 5;
  const auto v = only<FacetInThreeCells>(soup);
  EXPECT_EQ(v.half_facets, (std::vector<HalfFacetId>{{1}, {5}, {7}}));
  EXPECT_EQ(level_reached(2, check(soup)), Level::none);
}

TEST(Check, OrientationConflictUntilSignsMendIt) {
  CellSoup<2> soup{{{{{0}, {1}, {2}}}, {{{0}, {3}, {2}}}}, 4, {}};
  const auto v = only<OrientationConflict>(soup);
  EXPECT_EQ(v.one, HalfFacetId{1});
  EXPECT_EQ(v.other, HalfFacetId{4});
  soup.signs = std::get<0>(orient(soup));
  EXPECT_EQ(soup.signs, (std::vector<std::int8_t>{1, -1}));
  EXPECT_TRUE(check(soup).empty());
  const Complex<2> k = assemble(soup);
  EXPECT_EQ(k.sign({1}), -1);
  EXPECT_EQ(k.facet_sign({1}), -1);  // tuple (0, 2), opposite vertex 1
  EXPECT_EQ(k.facet_sign({4}), 1);
}

/// The loop that shows that a mesh has no coherent signs.
template <int D>
void expect_one_sided(const support::Mesh<D>& mesh) {
  const CellSoup<D> soup{mesh.cells, mesh.vertex_count, {}};
  const auto loop = std::get<NonOrientable>(orient(soup));
  EXPECT_GE(loop.loop.size(), 3U);
  EXPECT_EQ(refute<D>(loop, soup), "");
  EXPECT_EQ(refute<D>(only<NonOrientable>(soup, Level::cut_regular), soup), "");
  EXPECT_THROW(assemble(soup), InvalidComplex);
  EXPECT_THROW(assemble_regularized(soup), InvalidComplex);
}

TEST(NonOrientable, MoebiusBands) {
  expect_one_sided<2>(support::band(5));
  expect_one_sided<2>(support::band(11));
  EXPECT_TRUE(check(CellSoup<2>{support::band(6).cells, 6,
                                std::get<0>(orient(CellSoup<2>{support::band(6).cells, 6, {}}))},
                    Level::manifold)
                  .empty());
}

TEST(NonOrientable, ProjectivePlaneAndWhatIsBuiltOnIt) {
  const auto plane = support::projective_plane();
  expect_one_sided<2>(plane);
  expect_one_sided<3>(support::cone<3>(plane));
  expect_one_sided<3>(support::suspension<3>(plane));
  expect_one_sided<4>(support::suspension<4>(support::suspension<3>(plane)));
}

TEST(NonOrientable, OneLoopPerPiece) {
  const auto two = support::disjoint_union<2>(support::projective_plane(), support::band(7));
  const CellSoup<2> soup{two.cells, two.vertex_count, {}};
  const auto found = check(soup);
  ASSERT_EQ(found.size(), 2U);
  for (const Violation& violation : found) EXPECT_EQ(refute<2>(violation, soup), "");
  EXPECT_LT(std::get<NonOrientable>(found[0]).loop[0].value, 30U);
  EXPECT_GE(std::get<NonOrientable>(found[1]).loop[0].value, 30U);
}

/// The least number of cells in a closed chain that comes back mirrored: breadth first from every
/// cell, from each side of a triangle to the sides of its neighbours, found by comparing all pairs.
std::size_t shortest_mirroring_chain(const std::vector<Cell<2>>& cells) {
  // Whether b goes along the edge it shares with a in the same direction; 2: no common edge.
  const auto relation = [&](const Cell<2>& a, const Cell<2>& b) {
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        if (a[i] == b[j] && a[(i + 1) % 3] == b[(j + 1) % 3]) return 1;
        if (a[i] == b[(j + 1) % 3] && a[(i + 1) % 3] == b[j]) return 0;
      }
    return 2;
  };
  std::size_t shortest = SIZE_MAX;
  for (std::size_t start = 0; start < cells.size(); ++start) {
    std::vector<std::size_t> steps(2 * cells.size(), SIZE_MAX), queue{2 * start};
    steps[2 * start] = 0;
    for (std::size_t next = 0; next < queue.size(); ++next)
      for (std::size_t c = 0; c < cells.size(); ++c) {
        const int same = relation(cells[queue[next] / 2], cells[c]);
        if (c == queue[next] / 2 || same == 2) continue;
        const std::size_t to = 2 * c + (queue[next] % 2 + static_cast<std::size_t>(same)) % 2;
        if (steps[to] != SIZE_MAX) continue;
        steps[to] = steps[queue[next]] + 1;
        queue.push_back(to);
      }
    shortest = std::min(shortest, steps[2 * start + 1]);
  }
  return shortest;
}

TEST(NonOrientable, TheLoopIsAShortestOne) {
  support::Rng rng(20001126);
  std::set<std::size_t> lengths;
  for (int round = 0; round < 12; ++round) {
    auto mesh = round % 2 == 0 ? support::projective_plane() : support::band(5 + 2 * (round % 5));
    for (int i = 0; i < 3 * round; ++i) support::subdivide(mesh, rng);
    support::scramble(mesh, rng);
    const CellSoup<2> soup{mesh.cells, mesh.vertex_count, {}};
    const auto loop = std::get<NonOrientable>(orient(soup));
    EXPECT_EQ(refute<2>(loop, soup), "");
    EXPECT_EQ(loop.loop.size(), shortest_mirroring_chain(mesh.cells)) << round;
    lengths.insert(loop.loop.size());
  }
  EXPECT_GE(lengths.size(), 4u);
}

TEST(Check, NotCutRegular) {
  const CellSoup<2> soup{{{{{0}, {1}, {2}}}, {{{0}, {3}, {4}}}, {{{5}, {6}, {0}}}}, 7, {}};
  const auto v = only<NotCutRegular>(soup);
  EXPECT_EQ(v.vertex, VertexId{0});
  EXPECT_EQ(v.parts, 3U);
  EXPECT_EQ(level_reached(2, check(soup)), Level::pseudo_manifold);
}

TEST(Check, PinchedEdgeOfASolid) {
  std::vector<bool> keep;
  const auto grid = support::pinched_edge_grid<3>(keep);
  const auto solid = support::sub_mesh<3>(grid, keep);
  CellSoup<3> soup{solid.cells, solid.vertex_count, {}};
  soup.signs = std::get<0>(orient(soup));
  const auto v = only<PinchedSimplex>(soup, Level::edge_regular);
  EXPECT_EQ(v.simplex, (std::vector<VertexId>{grid.vertex({1, 1, 1}), grid.vertex({1, 1, 2})}));
  EXPECT_EQ(v.parts, 2U);
  EXPECT_EQ(level_reached(3, check(soup)), Level::cut_regular);
  EXPECT_EQ(assemble(soup).cell_count(), 60U);  // cut-regular is all that a Complex needs
}

TEST(Check, AVertexWhoseLinkIsATorus) {
  const auto cone = support::cone<3>(support::torus<2>(3));
  CellSoup<3> soup{cone.cells, cone.vertex_count, {}};
  soup.signs = std::get<0>(orient(soup));
  const auto v = only<BadVertexLink>(soup);
  EXPECT_EQ(v.vertex, VertexId{9});
  EXPECT_EQ(v.euler_characteristic, 0);
  EXPECT_EQ(v.boundary_components, 0);
  EXPECT_EQ(level_reached(3, check(soup)), Level::edge_regular);
  EXPECT_TRUE(check(soup, Level::edge_regular).empty());
}

TEST(Check, AnOrphanVertexIsReportedAndKept) {
  auto soup = square();
  soup.vertex_count = 5;
  EXPECT_EQ(only<OrphanVertex>(soup).vertex, VertexId{4});
  EXPECT_EQ(level_reached(2, check(soup)), Level::manifold);
  const Complex<2> k = assemble(soup);
  EXPECT_EQ(k.vertex_count(), 5U);
  EXPECT_FALSE(k.a_corner({4}));
}

TEST(Assemble, ThrowsAllViolationsAsData) {
  CellSoup<2> soup{{{{{0}, {0}, {2}}}, {{{0}, {2}, {7}}}}, 4, {}};
  try {
    assemble(soup);
    FAIL() << "assembled";
  } catch (const InvalidComplex& error) {
    ASSERT_EQ(error.violations.size(), 2U);
    EXPECT_EQ(std::get<DegenerateCell>(error.violations[0]).cell, CellId{0});
    EXPECT_EQ(std::get<VertexOutOfRange>(error.violations[1]).vertex, VertexId{7});
    EXPECT_NE(std::string(error.what()).find(describe(error.violations[0])), std::string::npos);
  }
}

// Signs 1 and 2 differ, but not as +1 and -1 do.
TEST(Assemble, RefusesSignsThatAreNone) {
  auto soup = square();
  soup.signs.assign(soup.cells.size(), 1);
  EXPECT_NO_THROW(check(soup));
  std::vector<std::vector<std::int8_t>> wrong(4, soup.signs);
  wrong[0].pop_back();
  wrong[1].push_back(1);
  wrong[2].back() = 2;
  wrong[3].front() = 0;
  for (const auto& signs : wrong) {
    soup.signs = signs;
    EXPECT_THROW(check(soup), std::invalid_argument);
    EXPECT_THROW(assemble(soup), std::invalid_argument);
    EXPECT_THROW(assemble_regularized(soup), std::invalid_argument);
  }
}

TEST(Assemble, RegularizesOnlyWhatIsOtherwiseSound) {
  auto soup = square();
  soup.cells.push_back({{{2}, {4}, {0}}});
  soup.vertex_count = 5;
  EXPECT_THROW(assemble_regularized(soup), InvalidComplex);
}

TEST(RequireIdsSuffice, RefusesMoreCornersOrVerticesThanIds) {
  // The greatest number means "none" and bounds every count; corners leave a bit to mark those
  // without mate.
  constexpr std::size_t kIds = kNoIndex - std::size_t{1};
  constexpr std::size_t kCorners = kIds / 2;
  for (const int dimension : {1, 2, 3, 4}) {
    const std::size_t most = kCorners / (static_cast<std::size_t>(dimension) + 1);
    EXPECT_NO_THROW(require_ids_suffice(dimension, most, kIds));
    EXPECT_THROW(require_ids_suffice(dimension, most + 1, 5), std::length_error);
    EXPECT_THROW(require_ids_suffice(dimension, std::numeric_limits<std::size_t>::max(), 5),
                 std::length_error);
    EXPECT_THROW(require_ids_suffice(dimension, 1, kIds + 1), std::length_error);
  }
  EXPECT_THROW(check(CellSoup<3>{{}, kIds + 1, {}}), std::length_error);
  EXPECT_THROW(assemble(CellSoup<3>{{}, kIds + 1, {}}), std::length_error);
}

// In time that does not grow with the square of the crowd.
TEST(Check, AVertexInManyEdgesIsOneFinding) {
  constexpr Index kEdges = 300000;
  CellSoup<1> star{{}, kEdges + 1, {}};
  for (Index v = 1; v <= kEdges; ++v) star.cells.push_back({VertexId{0}, VertexId{v}});
  EXPECT_EQ(only<FacetInThreeCells>(star).half_facets.size(), kEdges);
}

TEST(Check, CellsThatAreThereManyTimesAllRepeatTheFirst) {
  CellSoup<2> soup{{}, 4, {}};
  for (int n = 0; n < 100; ++n)
    soup.cells.push_back({VertexId{2}, VertexId{n % 2 == 0}, VertexId{3}});
  std::vector<DuplicateCell> duplicates;
  for (const Violation& violation : check(soup))
    if (const auto* duplicate = std::get_if<DuplicateCell>(&violation))
      duplicates.push_back(*duplicate);
  ASSERT_EQ(duplicates.size(), 98U);
  for (const auto& [first, second] : duplicates) {
    EXPECT_EQ(first.value, second.value % 2);
    EXPECT_GT(second, first);
  }
}

// A facet has one vertex and so one order: its orientation is the sign alone.
TEST(DimensionOne, SignsAreExplicit) {
  CellSoup<1> path{{{{{0}, {1}}}, {{{2}, {1}}}}, 3, {}};
  const auto v = only<OrientationConflict>(path);
  EXPECT_EQ(v.one, HalfFacetId{0});    // vertex 1 seen from cell 0
  EXPECT_EQ(v.other, HalfFacetId{2});  // and from cell 1
  path.signs = std::get<0>(orient(path));
  EXPECT_EQ(path.signs, (std::vector<std::int8_t>{1, -1}));
  const Complex<1> k = assemble(path);
  EXPECT_EQ(k.facet({0}), (Facet<1>{{{1}}}));
  EXPECT_EQ(k.facet_sign({0}), 1);  // + vertex 1, - vertex 0: the boundary of the edge 0 -> 1
  EXPECT_EQ(k.facet_sign({1}), -1);
  EXPECT_EQ(k.facet_sign({2}), -1);  // mates are opposite
  EXPECT_EQ(k.facet_sign({3}), 1);
}

TEST(DimensionOne, AVertexInThreeEdgesIsRefused) {
  const CellSoup<1> star{{{{{0}, {1}}}, {{{0}, {2}}}, {{{0}, {3}}}}, 4, {}};
  EXPECT_EQ(only<FacetInThreeCells>(star).half_facets, (std::vector<HalfFacetId>{{1}, {3}, {5}}));
}

}  // namespace
}  // namespace cleave::topology
