// Fix-its against brute force: all subsets of the facets of small complexes, opened by the
// reference.
#include "cleave/topology/fix_it.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "cleave/support/random_meshes.hpp"
#include "cleave/topology/check.hpp"
#include "cleave/topology/incision.hpp"
#include "view_laws.hpp"

namespace cleave::views {
namespace {

/// A simplex subdivided until it has `facets` interior facets or more.
template <int D>
Complex<D> small_ball(support::Rng& rng, std::size_t facets) {
  support::Mesh<D> mesh = support::simplex<D>();
  while (support::interior_facets<D>(mesh.cells).size() < facets) support::subdivide(mesh, rng);
  return complex_of(mesh);
}

template <int D>
bool opens(const Complex<D>& k, const FacetSet& scored, HalfFacetId facet) {
  const auto opened = support::opened_facets<D>(
      k.cells(), support::algorithm_3<D>(k.cells(), scored.half_facets()));
  return std::find(opened.begin(), opened.end(), facet) != opened.end();
}

std::vector<HalfFacetId> list(const FacetSet& facets) {
  return {facets.half_facets().begin(), facets.half_facets().end()};
}

/// Whether some set of `size` of `choice` satisfies `good`.
bool some_subset(const std::vector<HalfFacetId>& choice, std::size_t size,
                 const std::function<bool(const FacetSet&)>& good) {
  if (size > choice.size()) return false;
  std::vector<bool> chosen(choice.size());
  std::fill(chosen.end() - static_cast<std::ptrdiff_t>(size), chosen.end(), true);
  do {
    std::vector<HalfFacetId> subset;
    for (std::size_t i = 0; i < choice.size(); ++i)
      if (chosen[i]) subset.push_back(choice[i]);
    if (good(FacetSet::of_lesser(subset))) return true;
  } while (std::next_permutation(chosen.begin(), chosen.end()));
  return false;
}

template <class Dimension>
class FixIt : public ::testing::Test {};
TYPED_TEST_SUITE(FixIt, Dimensions);

TYPED_TEST(FixIt, ForOneFacetIsSmallest) {
  constexpr int D = TypeParam::value;
  std::map<std::size_t, int> sizes;
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    support::Rng rng(seed);
    const Complex<D> k = small_ball<D>(rng, D == 1 ? 5 : 8);
    const FacetSet all = FacetSet::all(k);
    const HalfFacetId facet = rng.pick(list(all));
    std::vector<HalfFacetId> scored{facet}, others;
    for (const HalfFacetId h : all.half_facets())
      if (h != facet) (rng.chance(0.2) ? scored : others).push_back(h);
    const FacetSet asked = FacetSet::of_lesser(scored);
    const FacetSet fix = separating_facets(k, asked, facet);
    ++sizes[fix.size()];

    EXPECT_TRUE(opens(k, asked | fix, facet));
    EXPECT_TRUE((fix & asked).empty());
    EXPECT_EQ(separating_facets(k, asked, *k.mate(facet)), fix);
    for (std::size_t fewer = 0; fewer < fix.size() && fewer < 4; ++fewer)
      EXPECT_FALSE(some_subset(others, fewer,
                               [&](const FacetSet& more) { return opens(k, asked | more, facet); }))
          << "seed " << seed << ": " << fewer << " instead of " << fix.size();

    // The same after a cut of what is scored.
    Incision<D> incision(k);
    incision.cut(asked);
    if (incision.shut().contains(facet)) {
      EXPECT_EQ(separating_facets(incision.complex(), incision.shut(), facet).size(), fix.size());
    } else {
      EXPECT_TRUE(fix.empty());
    }
  }
  if (D > 1) {
    EXPECT_GT(sizes.size(), D == 2 ? 1u : 2u) << "they were all alike";
  }
  if (D == 1) {
    EXPECT_EQ(sizes.size(), 1u);
  }
}

TYPED_TEST(FixIt, ForSeveralOpensAllAndLeavesOutWhatIsNotNeeded) {
  constexpr int D = TypeParam::value;
  std::size_t answers = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    support::Rng rng(seed);
    const Complex<D> k = small_ball<D>(rng, 12);
    const FacetSet all = FacetSet::all(k);
    std::vector<HalfFacetId> asked;
    for (int n = 0; n < 3; ++n) asked.push_back(rng.pick(list(all)));
    const FacetSet wanted = FacetSet::of(k, asked);
    const FacetSet fix = separating_facets(k, FacetSet(), asked);
    const auto all_open = [&](const FacetSet& more) {
      const auto scored = wanted | more;
      return std::all_of(asked.begin(), asked.end(),
                         [&](HalfFacetId h) { return opens(k, scored, h); });
    };
    EXPECT_TRUE(all_open(fix));
    for (const HalfFacetId h : fix.half_facets())
      EXPECT_FALSE(all_open(fix - FacetSet::of_lesser({h}))) << "seed " << seed;
    answers += fix.size();
  }
  if (D > 1) {
    EXPECT_GT(answers, 0u);
  }
}

TYPED_TEST(FixIt, RefusesABoundaryFacet) {
  constexpr int D = TypeParam::value;
  const auto k = complex_of(support::simplex<D>());
  EXPECT_THROW(separating_facets(k, FacetSet(), HalfFacetId{0}), NotInterior);
}

// A tetrahedron split 1 to 4: any one further facet that makes two at an outer vertex will do.
TEST(FixItExample, OneMoreFacetOpensAnInnerFacetOfASplitTetrahedron) {
  const auto k = complex_of(support::cone<3>(support::simplex_boundary<2>()));
  const FacetSet all = FacetSet::all(k);
  for (const HalfFacetId h : all.half_facets())
    EXPECT_EQ(separating_facets(k, FacetSet::of_lesser({h}), h).size(), 1u);
}

template <int D>
std::vector<Violation> violations(const Complex<D>& k, Level level) {
  CellSoup<D> soup{{k.cells().begin(), k.cells().end()}, k.vertex_count(), {}};
  for (Index c = 0; c < k.cell_count(); ++c)
    soup.signs.push_back(static_cast<std::int8_t>(k.sign({c})));
  auto found = check(soup, level);
  std::erase_if(found, [](const Violation& v) { return std::holds_alternative<OrphanVertex>(v); });
  return found;
}

/// Random cells of a grid: pinched edges by the dozen, and links that are no disks.
template <int D>
Complex<D> scattered(support::Rng& rng) {
  const auto grid = kuhn_cube<D>(D == 1 ? 9 : D == 2 ? 6 : D == 3 ? 4 : 3);
  std::vector<bool> keep(grid.cells.size());
  const double density = 0.35 + 0.6 * rng.unit();
  for (std::size_t c = 0; c < keep.size(); ++c) keep[c] = rng.chance(density);
  return complex_of(support::sub_mesh<D>(grid, keep));
}

TYPED_TEST(FixIt, ALevelIsReached) {
  constexpr int D = TypeParam::value;
  std::size_t pinched = 0, bad_links = 0, shut = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    support::Rng rng(seed);
    const Complex<D> k = scattered<D>(rng);
    const FacetSet all = FacetSet::all(k);
    std::vector<HalfFacetId> scored;
    for (const HalfFacetId h : all.half_facets())
      if (rng.chance(0.1)) scored.push_back(h);
    for (const Level level : {Level::cut_regular, Level::edge_regular, Level::manifold}) {
      if (D == 4 && level == Level::manifold) continue;
      Incision<D> incision(k);
      incision.cut(FacetSet::of_lesser(scored));
      shut += incision.shut().size();
      const auto before = violations(incision.complex(), level);
      for (const Violation& v : before) {
        if (std::holds_alternative<PinchedSimplex>(v)) ++pinched;
        if (std::holds_alternative<BadVertexLink>(v)) ++bad_links;
      }
      const FacetSet more = facets_to_reach(k, FacetSet::of_lesser(scored), level);
      EXPECT_EQ(more.empty(), before.empty());
      EXPECT_TRUE((more & FacetSet::of_lesser(scored)).empty());
      // After the cut, the same question with its state.
      EXPECT_EQ(facets_to_reach(incision.complex(), incision.shut(), level).empty(), more.empty());
      const auto change = incision.cut(more, Verify::all);
      EXPECT_TRUE(violations(incision.complex(), level).empty()) << "seed " << seed;
      if (!more.empty()) {
        EXPECT_FALSE(change.opened.empty());
      }
    }
  }
  if (D >= 3) {
    EXPECT_GT(pinched, 20u);
  }
  if (D == 3) {
    EXPECT_GT(bad_links, 20u);
  }
  if (D >= 2) {
    EXPECT_GT(shut, 0u);
  }
}

TEST(FixItLevels, AManifoldIsNotDecidedInDimension4) {
  const auto k = complex_of(support::simplex<4>());
  EXPECT_THROW(facets_to_reach(k, FacetSet(), Level::manifold), std::invalid_argument);
  EXPECT_TRUE(facets_to_reach(k, FacetSet(), Level::edge_regular).empty());
}

// The suspension of an annulus: both apexes have an annulus for a link, which is divided.
TEST(FixItLevels, AnAnnulusIsDividedIntoDisks) {
  const auto k = complex_of(support::suspension<3>(support::band(6)));
  ASSERT_EQ(violations(k, Level::manifold).size(), 2u);
  ASSERT_TRUE(violations(k, Level::edge_regular).empty());
  const FacetSet more = facets_to_reach(k, FacetSet(), Level::manifold);
  Incision<3> incision(k);
  incision.cut(more, Verify::all);
  EXPECT_TRUE(violations(incision.complex(), Level::manifold).empty());
  EXPECT_LT(more.size(), FacetSet::all(k).size());
}

}  // namespace
}  // namespace cleave::views
