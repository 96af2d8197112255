#include "cleave/topology/ranges.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <ranges>

#include "cleave/support/random_meshes.hpp"
#include "cleave/topology/boundary.hpp"
#include "cleave/topology/link_view.hpp"
#include "cleave/topology/ridge_walk.hpp"
#include "cleave/topology/simplices.hpp"
#include "cleave/topology/star_walker.hpp"
#include "cleave/topology/unglue.hpp"
#include "view_laws.hpp"

namespace cleave::views {
namespace {

/// A view that can be asked again and again, const as well, and whose iterators outlive it.
template <class R>
constexpr bool is_cheap_view() {
  return std::ranges::view<R> && std::ranges::borrowed_range<R> && std::ranges::common_range<R> &&
         std::ranges::forward_range<const R>;
}

template <int D>
constexpr bool models_what_it_says() {
  using K = const Complex<D>&;
  using std::declval;
  using Cells = decltype(cells(declval<K>()));
  using Corners = decltype(corners(declval<K>(), CellId{}));
  using Neighbours = decltype(neighbours(declval<K>(), CellId{}));
  using Boundary = decltype(boundary_facets(declval<K>()));
  using Link = decltype(link(declval<K>(), std::span<const CornerId>()));
  static_assert(is_cheap_view<Cells>() && is_cheap_view<Corners>() && is_cheap_view<Neighbours>());
  static_assert(is_cheap_view<Boundary>() && is_cheap_view<Link>());
  static_assert(std::ranges::random_access_range<Cells> && std::ranges::sized_range<Cells>);
  static_assert(std::ranges::random_access_range<Corners> && std::ranges::sized_range<Corners>);
  static_assert(std::ranges::random_access_range<Link> && std::ranges::sized_range<Link>);
  static_assert(std::same_as<std::ranges::range_value_t<Link>, Facet<D>>);
  static_assert(std::same_as<std::ranges::range_value_t<Neighbours>, CellId>);
  static_assert(std::ranges::random_access_range<const Simplices<D>>);
  static_assert(std::ranges::sized_range<const Simplices<D>>);
  static_assert(std::ranges::contiguous_range<decltype(mates(declval<K>(), CellId{}))>);
  if constexpr (D >= 2)
    static_assert(is_cheap_view<decltype(around_ridge(declval<K>(), CornerId{}, CornerId{}))>());
  return true;
}
static_assert(models_what_it_says<1>() && models_what_it_says<2>());
static_assert(models_what_it_says<3>() && models_what_it_says<4>());

template <class R>
auto listed(R&& range) {
  std::vector<std::ranges::range_value_t<R>> values;
  for (const auto& value : range) values.push_back(value);
  return values;
}

/// A random mesh of a random class, regularized, and perhaps cut.
template <int D>
Complex<D> random_complex() {
  support::Rng rng(*rc::gen::arbitrary<std::uint64_t>());
  const auto mesh_class = support::kMeshClasses[rng.below(support::kMeshClasses.size())];
  auto k = complex_of(support::random_mesh<D>(mesh_class, rng));
  if (rng.chance(0.5)) unglue(k, dense_cut(k));
  return k;
}

template <int D>
void expect_every_id(const Complex<D>& k) {
  const auto all = cells(k);
  ASSERT_EQ(all.size(), k.cell_count());
  EXPECT_EQ(all.empty(), k.cell_count() == 0);
  EXPECT_EQ(vertices(k).size(), k.vertex_count());
  EXPECT_EQ(half_facets(k).size(), k.half_facet_count());
  EXPECT_EQ(listed(corners(k)), listed(half_facets(k)));
  std::vector<CornerId> by_cell;
  for (const CellId cell : all) {
    EXPECT_EQ(all[cell.value], cell);
    for (const CornerId corner : corners(k, cell)) by_cell.push_back(corner);
  }
  EXPECT_EQ(by_cell, listed(corners(k)));
}

template <int D>
void expect_facets_by_definition(const Complex<D>& k) {
  const auto expected = support::facets_of<D>(k.cells());
  std::vector<HalfFacetId> free, inner, every;
  for (const auto& [facet, sides] : expected) {
    (sides.size() == 1 ? free : inner).push_back(sides[0]);
    every.push_back(sides[0]);
  }
  for (auto* list : {&free, &inner, &every}) std::sort(list->begin(), list->end());
  EXPECT_EQ(listed(boundary_facets(k)), free);
  EXPECT_EQ(listed(interior_facets(k)), inner);
  EXPECT_EQ(listed(facets(k)), every);
  EXPECT_EQ(boundary(k), free);
}

template <int D>
void expect_neighbours_by_definition(const Complex<D>& k) {
  const auto expected = support::mates_of<D>(k.cells());
  for (const CellId cell : cells(k)) {
    std::vector<CellId> across;
    for (const HalfFacetId h : half_facets(k, cell)) {
      const auto mate = expected[h.value];
      if (mate) across.push_back(cell_of<D>(*mate));
      const HalfFacetId entry = mates(k, cell)[static_cast<std::size_t>(local_index<D>(h))];
      EXPECT_EQ(mate.has_value(), entry.value < k.half_facet_count());
      EXPECT_EQ(mate.value_or(entry), entry);
    }
    EXPECT_EQ(listed(neighbours(k, cell)), across);
  }
}

/// The corners at `vertex` in the order of Algorithm 5: first come, first served.
template <int D>
std::vector<CornerId> flooded(const Complex<D>& k, VertexId vertex) {
  std::vector<CornerId> reached;
  if (const auto start = k.a_corner(vertex)) reached.push_back(*start);
  for (std::size_t next = 0; next < reached.size(); ++next)
    for (const HalfFacetId h : half_facets(k, cell_of<D>(reached[next]))) {
      const auto mate = k.mate(h);
      if (h == reached[next] || !mate) continue;
      for (const CornerId corner : corners(k, cell_of<D>(*mate)))
        if (k.vertex(corner) == vertex && std::ranges::count(reached, corner) == 0)
          reached.push_back(corner);
    }
  return reached;
}

template <int D>
void expect_stars_and_links_by_definition(const Complex<D>& k) {
  const auto expected = support::stars_of<D>(k.cells());
  StarWalker walker(k);
  for (const VertexId v : vertices(k)) {
    const auto corners = walker.around(v);
    EXPECT_EQ(listed(corners), flooded(k, v));
    EXPECT_EQ(listed(corners), star(k, v));
    std::set<std::size_t> reached;
    for (const CornerId corner : corners) {
      EXPECT_EQ(k.vertex(corner), v);
      reached.insert(cell_of<D>(corner).value);
    }
    EXPECT_EQ(reached.size(), corners.size());
    const auto found = expected.find(v);
    EXPECT_EQ(reached, found == expected.end() ? std::set<std::size_t>() : found->second);

    std::vector<Vertices> opposite;
    for (const Facet<D>& facet : link(k, corners)) opposite.push_back(ascending(facet));
    std::sort(opposite.begin(), opposite.end());
    EXPECT_EQ(opposite, link(k, std::span(&v, 1)));
  }
}

/// The cells around a ridge: each next to the one before, and all of its star that a flood through
/// the facets with the ridge reaches.
template <int D>
void expect_rings_around_ridges(const Complex<D>& k) {
  for (const CellId cell : cells(k))
    for (const CornerId a : corners(k, cell))
      for (const CornerId b : corners(k, cell)) {
        if (a == b) continue;
        Vertices ridge;
        for (const CornerId corner : corners(k, cell))
          if (corner != a && corner != b) ridge.push_back(k.vertex(corner));
        std::sort(ridge.begin(), ridge.end());
        const auto has_ridge = [&](HalfFacetId h) {
          const Vertices facet = ascending(k.facet(h));
          return std::includes(facet.begin(), facet.end(), ridge.begin(), ridge.end());
        };
        std::set<CellId> part = {cell};
        std::vector<CellId> todo = {cell};
        while (!todo.empty()) {
          const CellId from = todo.back();
          todo.pop_back();
          for (const HalfFacetId h : half_facets(k, from))
            if (has_ridge(h) && k.mate(h) && part.insert(cell_of<D>(*k.mate(h))).second)
              todo.push_back(cell_of<D>(*k.mate(h)));
        }

        const auto ring = listed(around_ridge(k, a, b));
        ASSERT_EQ(ring.size(), part.size());
        bool meets = false;
        for (std::size_t n = 0; n < ring.size(); ++n) {
          EXPECT_TRUE(part.contains(cell_of<D>(ring[n].enter)));
          EXPECT_EQ(cell_of<D>(ring[n].enter), cell_of<D>(ring[n].leave));
          EXPECT_TRUE(has_ridge(ring[n].enter) && has_ridge(ring[n].leave));
          if (n > 0) {
            EXPECT_EQ(k.mate(ring[n - 1].leave), ring[n].enter);
          }
          if (cell_of<D>(ring[n].enter) == cell) {
            meets = true;
            EXPECT_EQ(ring[n], (AtRidge{b, a}));
          }
        }
        EXPECT_TRUE(meets);
        if (k.is_interior(ring[0].enter)) {
          EXPECT_EQ(k.mate(ring.back().leave), ring[0].enter);
        } else {
          EXPECT_FALSE(k.is_interior(ring.back().leave));
        }
      }
}

template <int D>
void expect_all_ranges_by_definition(const Complex<D>& k) {
  expect_every_id(k);
  expect_facets_by_definition(k);
  expect_neighbours_by_definition(k);
  expect_stars_and_links_by_definition(k);
  if constexpr (D >= 2) expect_rings_around_ridges(k);
}

template <class Dimension>
class Ranges : public ::testing::Test {};
TYPED_TEST_SUITE(Ranges, Dimensions);

template <class Dimension>
class RangesProperty : public ::testing::Test {};
TYPED_TEST_SUITE(RangesProperty, Dimensions);

TYPED_TEST(Ranges, AreWhatTheDefinitionsSay) {
  for (const auto& k : sample_complexes<TypeParam::value>()) expect_all_ranges_by_definition(k);
}

TYPED_TEST(RangesProperty, AreWhatTheDefinitionsSayForRandomComplexes) {
  EXPECT_TRUE(rc::check([] {
    const auto k = random_complex<TypeParam::value>();
    expect_all_ranges_by_definition(k);
    RC_ASSERT(!::testing::Test::HasFailure());
  }));
}

TYPED_TEST(Ranges, SimplicesAreARangeOfSpans) {
  constexpr int D = TypeParam::value;
  for (const auto& k : sample_complexes<D>())
    for (int dimension = 0; dimension <= D; ++dimension) {
      const Simplices<D> simplices(k, dimension);
      std::size_t n = 0;
      for (const std::span<const VertexId> simplex : simplices) {
        EXPECT_EQ(simplex.data(), simplices[n].data());
        EXPECT_EQ(simplex.size(), static_cast<std::size_t>(dimension) + 1);
        ++n;
      }
      EXPECT_EQ(n, simplices.count());
      EXPECT_EQ(std::ranges::size(simplices), n);
    }
}

// The cone over a cycle: as many cells around its apex as the cycle has, beyond what a walker has
// room for at first.
TEST(StarWalker, WalksStarsOfAnySize) {
  for (const std::uint32_t size : {3u, 62u, 63u, 64u, 65u, 1000u, 5000u}) {
    CellSoup<2> soup;
    soup.vertex_count = size + 1;
    for (std::uint32_t v = 0; v < size; ++v)
      soup.cells.push_back({VertexId{v}, VertexId{(v + 1) % size}, VertexId{size}});
    const Complex<2> k = assemble(soup);
    StarWalker walker(k);
    for (int again = 0; again < 3; ++again) {
      EXPECT_EQ(listed(walker.around({size})), star(k, {size}));
      EXPECT_EQ(walker.around({0}).size(), 2u);
    }
  }
}

TEST(StarWalker, FollowsCuts) {
  auto k = complex_of<3>(kuhn_cube<3>(4));
  StarWalker walker(k);
  for (const VertexId v : vertices(k)) walker.around(v);
  unglue(k, dense_cut(k));
  for (const VertexId v : vertices(k)) EXPECT_EQ(listed(walker.around(v)), star(k, v));
}

TEST(Ranges, WorkWithAlgorithmsOfTheStandardLibrary) {
  const auto k = complex_of<3>(kuhn_cube<3>(3));
  EXPECT_EQ(std::ranges::count_if(half_facets(k), [&](auto h) { return !k.is_interior(h); }),
            std::ranges::distance(boundary_facets(k)));
  const auto corner =
      std::ranges::find(corners(k), VertexId{13}, [&](auto c) { return k.vertex(c); });
  ASSERT_NE(corner, corners(k).end());
  EXPECT_EQ(k.vertex(*corner), VertexId{13});
  EXPECT_TRUE(std::ranges::is_sorted(interior_facets(k)));
  EXPECT_EQ(*std::ranges::upper_bound(cells(k), CellId{4}), CellId{5});
}

}  // namespace
}  // namespace cleave::views
