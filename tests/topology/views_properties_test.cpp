#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numeric>

#include "cleave/support/rng.hpp"
#include "cleave/topology/boundary.hpp"
#include "cleave/topology/check.hpp"
#include "cleave/topology/locate.hpp"
#include "cleave/topology/pieces.hpp"
#include "cleave/topology/simplices.hpp"
#include "cleave/topology/summary.hpp"
#include "explain_law.hpp"

namespace cleave::views {
namespace {

/// A random part of a Kuhn grid: holes, several pieces, pinched ridges, and vertices that were
/// pinched before they were split.
template <int D>
Complex<D> random_complex(support::Rng& rng) {
  const auto grid = kuhn_cube<D>(D == 1 ? 9 : D == 2 ? 5 : D == 3 ? 4 : 3);
  const double density = 0.3 + 0.7 * rng.unit();
  std::vector<bool> keep(grid.cells.size());
  for (std::size_t c = 0; c < keep.size(); ++c) keep[c] = rng.chance(density);
  return complex_of(support::sub_mesh<D>(grid, keep));
}

template <int D>
FacetSet random_cut(const Complex<D>& k, support::Rng& rng) {
  const double density = rng.unit();
  std::vector<HalfFacetId> facets;
  const FacetSet every = FacetSet::all(k);
  for (const HalfFacetId h : every.half_facets())
    if (rng.chance(density)) facets.push_back(h);
  return FacetSet::of_lesser(facets);
}

/// The number of classes of 0 .. size-1 under the transitive closure of `related`.
template <class Related>
std::size_t classes(std::size_t size, Related related) {
  std::vector<std::size_t> label(size);
  std::iota(label.begin(), label.end(), std::size_t{0});
  for (std::size_t a = 0; a < size; ++a)
    for (std::size_t b = 0; b < size; ++b)
      if (const auto from = label[b], to = label[a]; related(a, b))
        std::replace(label.begin(), label.end(), from, to);
  return std::set(label.begin(), label.end()).size();
}

/// The distinct non-empty sets of vertices of cells, and the cells that have them.
template <int D>
std::map<Vertices, std::set<std::size_t>> sets_of(const CellSoup<D>& soup) {
  std::map<Vertices, std::set<std::size_t>> sets;
  for (std::size_t c = 0; c < soup.cells.size(); ++c)
    for (unsigned subset = 1; subset < 1u << (D + 1); ++subset) {
      std::set<VertexId> vertices;
      for (std::size_t i = 0; i <= D; ++i)
        if ((subset >> i & 1u) != 0) vertices.insert(soup.cells[c][i]);
      sets[Vertices(vertices.begin(), vertices.end())].insert(c);
    }
  return sets;
}

template <int D>
Summary summary_by_definition(const CellSoup<D>& soup) {
  const auto sets = sets_of(soup);
  Summary summary;
  summary.simplices = sets.size();
  std::vector<std::set<std::size_t>> facets;  // the cells of each
  std::vector<Vertices> boundary;
  for (const auto& [vertices, cells] : sets) {
    summary.euler_characteristic += vertices.size() % 2 == 1 ? 1 : -1;
    if (vertices.size() != D) continue;
    facets.push_back(cells);
    if (cells.size() == 1) boundary.push_back(vertices);
  }
  summary.pieces = classes(soup.cells.size(), [&](std::size_t a, std::size_t b) {
    return std::any_of(facets.begin(), facets.end(),
                       [&](const auto& cells) { return cells.contains(a) && cells.contains(b); });
  });
  summary.boundary_components = classes(boundary.size(), [&](std::size_t a, std::size_t b) {
    Vertices ridge;
    std::set_intersection(boundary[a].begin(), boundary[a].end(), boundary[b].begin(),
                          boundary[b].end(), std::back_inserter(ridge));
    return D > 1 && ridge.size() == D - 1;
  });
  return summary;
}

support::Rng random_numbers() { return support::Rng(*rc::gen::arbitrary<std::uint64_t>()); }

template <class Dimension>
class ViewsProperty : public ::testing::Test {};
TYPED_TEST_SUITE(ViewsProperty, Dimensions);

TYPED_TEST(ViewsProperty, SimplicesAreClosedUnderSubsets) {
  constexpr int D = TypeParam::value;
  EXPECT_TRUE(rc::check([] {
    auto rng = random_numbers();
    const auto k = random_complex<D>(rng);
    std::vector<Simplices<D>> all;
    for (int dimension = 0; dimension <= D; ++dimension) all.emplace_back(k, dimension);
    for (std::size_t dimension = 1; dimension <= D; ++dimension)
      for (std::size_t i = 0; i < all[dimension].count(); ++i)
        for (std::size_t without = 0; without <= dimension; ++without) {
          const auto simplex = all[dimension][i];
          Vertices face(simplex.begin(), simplex.end());
          face.erase(face.begin() + static_cast<std::ptrdiff_t>(without));
          const auto found = all[dimension - 1].find(face);
          RC_ASSERT(found.has_value());
          RC_ASSERT(found->sign == 1);
          const auto star = all[dimension].star(i), around = all[dimension - 1].star(found->index);
          RC_ASSERT(std::includes(around.begin(), around.end(), star.begin(), star.end()));
        }
  }));
}

TYPED_TEST(ViewsProperty, ARandomTupleIsFoundIffItIsASimplex) {
  constexpr int D = TypeParam::value;
  EXPECT_TRUE(rc::check([] {
    auto rng = random_numbers();
    const auto k = random_complex<D>(rng);
    RC_PRE(k.cell_count() > 0u);
    const int dimension = rng.between(0, D);
    const Simplices<D> simplices(k, dimension);
    const auto expected = simplices_by_definition(k, static_cast<std::size_t>(dimension) + 1);
    for (int trial = 0; trial < 50; ++trial) {
      Vertices tuple;  // most of a cell, and now and then something else
      const auto& cell = k.cells()[rng.below(k.cell_count())];
      for (int i = 0; i <= dimension; ++i)
        tuple.push_back(rng.chance(0.9)
                            ? cell[static_cast<std::size_t>(i)]
                            : VertexId{static_cast<Index>(rng.below(k.vertex_count()))});
      rng.shuffle(tuple);
      const auto found = simplices.find(tuple);
      RC_ASSERT(found.has_value() == expected.contains(ascending(tuple)));
      if (found) RC_ASSERT(found->sign == support::parity(tuple));
    }
  }));
}

TYPED_TEST(ViewsProperty, PiecesAreComponentsByBoostGraph) {
  constexpr int D = TypeParam::value;
  EXPECT_TRUE(rc::check([] {
    auto rng = random_numbers();
    auto k = random_complex<D>(rng);
    unglue(k, random_cut(k, rng));
    const auto expected = support::components<D>(k.cells());
    const Pieces found = pieces(k);
    RC_CLASSIFY(found.count > 1, "several pieces");
    RC_ASSERT(
        std::equal(expected.begin(), expected.end(), found.of_cell.begin(), found.of_cell.end()));
  }));
}

TYPED_TEST(ViewsProperty, TheBoundaryIsClosedOrSaysWhereItTouchesItself) {
  constexpr int D = TypeParam::value;
  if constexpr (D >= 2) {
    EXPECT_TRUE(rc::check([] {
      auto rng = random_numbers();
      const auto k = random_complex<D>(rng);
      CellSoup<D - 1> soup;  // with the numbers of the whole
      for (const HalfFacetId h : boundary(k)) {
        soup.cells.push_back(k.facet(h));
        soup.signs.push_back(static_cast<std::int8_t>(k.facet_sign(h)));
      }
      soup.vertex_count = k.vertex_count();
      std::vector<std::string_view> expected;
      for (const Violation& violation : check(soup, Level::cut_regular))
        if (rule(violation) != "orphan-vertex") expected.push_back(rule(violation));

      const auto result = boundary_complex(k);
      RC_CLASSIFY(!expected.empty(), "touches itself");
      if (const auto* sphere = std::get_if<BoundaryComplex<D>>(&result)) {
        RC_ASSERT(expected.empty());
        RC_ASSERT(boundary(sphere->complex).empty());  // T10
      } else {
        std::vector<std::string_view> found;
        for (const auto& violation : std::get<std::vector<Violation>>(result))
          found.push_back(rule(violation));
        RC_ASSERT(found == expected);
      }
    }));
  }
}

TYPED_TEST(ViewsProperty, ShutFacetsAreExplainedByShortestChains) {
  constexpr int D = TypeParam::value;
  EXPECT_TRUE(rc::check([] {
    auto rng = random_numbers();
    const auto k = random_complex<D>(rng);
    RC_ASSERT(explanation_flaw(k, random_cut(k, rng)) == "");
  }));
}

TYPED_TEST(ViewsProperty, SummariesOfAnySoupCountSetsAsDefined) {
  constexpr int D = TypeParam::value;
  EXPECT_TRUE(rc::check([] {
    auto rng = random_numbers();
    CellSoup<D> soup;  // few vertices: repeated ones, equal cells, crowded facets
    soup.vertex_count = 2 + rng.below(2 * D + 4);
    soup.cells.resize(rng.below(12));
    for (Cell<D>& cell : soup.cells)
      for (VertexId& v : cell) v = {static_cast<Index>(rng.below(soup.vertex_count))};
    const Summary found = summarize(soup), expected = summary_by_definition(soup);
    RC_CLASSIFY(expected.pieces > 1, "several pieces");
    RC_CLASSIFY(expected.boundary_components > 1, "several boundary components");
    RC_ASSERT(found.pieces == expected.pieces);
    RC_ASSERT(found.boundary_components == expected.boundary_components);
    RC_ASSERT(found.euler_characteristic == expected.euler_characteristic);
    RC_ASSERT(found.simplices == expected.simplices);
  }));
}

/// A mesh with or without pinches and coherent tuples, beside the same mesh and one cell that is a
/// point in truth: what is unsound is summarized in another way.
TYPED_TEST(ViewsProperty, MeshesAreSummarizedAsSoups) {
  constexpr int D = TypeParam::value;
  EXPECT_TRUE(rc::check([] {
    auto rng = random_numbers();
    const auto grid = kuhn_cube<D>(D == 1 ? 9 : D == 2 ? 5 : D == 3 ? 4 : 3);
    const double density = 0.1 + 0.9 * rng.unit();
    std::vector<bool> keep(grid.cells.size());
    for (std::size_t c = 0; c < keep.size(); ++c) keep[c] = rng.chance(density);
    const auto mesh = support::sub_mesh<D>(grid, keep);
    CellSoup<D> soup{mesh.cells, mesh.vertex_count, {}};
    if (rng.chance(0.5))
      for (Cell<D>& cell : soup.cells) rng.shuffle(cell);
    if (rng.chance(0.5)) rng.shuffle(soup.cells);
    const Summary found = summarize(soup);
    soup.cells.emplace_back().fill(VertexId{static_cast<Index>(soup.vertex_count++)});
    const Summary with_point = summarize(soup);
    RC_ASSERT(found.pieces + 1 == with_point.pieces);
    RC_ASSERT(found.boundary_components + (D == 1 ? 1 : 0) == with_point.boundary_components);
    RC_ASSERT(found.euler_characteristic + 1 == with_point.euler_characteristic);
    RC_ASSERT(found.simplices + 1 == with_point.simplices);
  }));
}

TYPED_TEST(ViewsProperty, FacetsAreLocatedWhereTheyAre) {
  constexpr int D = TypeParam::value;
  EXPECT_TRUE(rc::check([] {
    auto rng = random_numbers();
    const auto k = random_complex<D>(rng);
    const auto facets = support::facets_of<D>(k.cells());
    std::vector<Facet<D>> asked;
    std::vector<std::optional<HalfFacetId>> expected;
    for (const auto& [facet, half_facets] : facets) {
      if (rng.chance(0.5)) continue;
      asked.push_back(facet);
      rng.shuffle(asked.back());
      if (rng.chance(0.2)) asked.back()[0] = {static_cast<Index>(k.vertex_count())};
      Facet<D> sorted = asked.back();
      std::sort(sorted.begin(), sorted.end());
      const auto found = facets.find(sorted);
      expected.push_back(found == facets.end() ? std::nullopt
                                               : std::optional(found->second.front()));
    }
    RC_ASSERT(locate_facets<D>(k.cells(), asked) == expected);
  }));
}

}  // namespace
}  // namespace cleave::views
