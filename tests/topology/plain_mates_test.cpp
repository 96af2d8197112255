// The fast way to the mates, against the references: same mates on good meshes, refusal of others,
// with any number of threads.
#include "plain_mates.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <utility>
#include <variant>

#include "cleave/support/defects.hpp"
#include "cleave/support/meshes.hpp"
#include "cleave/support/random_meshes.hpp"
#include "cleave/support/reference.hpp"
#include "cleave/topology/assemble.hpp"
#include "cleave/topology/check.hpp"
#include "facet_matching.hpp"

namespace cleave::topology {
namespace {

using support::Defect;
using support::Rng;

template <class Dimension>
class PlainMates : public ::testing::Test {};
template <int D>
using Dimension = std::integral_constant<int, D>;
TYPED_TEST_SUITE(
    PlainMates,
    decltype(::testing::Types<Dimension<1>, Dimension<2>, Dimension<3>, Dimension<4>>{}));

template <int D>
std::optional<std::vector<HalfFacetId>> mates_of(const CellSoup<D>& soup, int threads) {
  detail::Crew crew(RunOptions{threads, {}});
  return detail::plain_mates<D>(
      soup.cells, soup.vertex_count,
      [&](CellId c) { return !soup.signs.empty() && soup.signs[c.value] < 0; }, crew);
}

/// The same by records, which plain_mates would use for large meshes without order only.
template <int D>
std::optional<std::vector<HalfFacetId>> mates_by_records(const CellSoup<D>& soup, int threads) {
  detail::Crew crew(RunOptions{threads, {}});
  return detail::mates_by_records<D>(
      soup.cells, soup.vertex_count,
      [&](CellId c) { return !soup.signs.empty() && soup.signs[c.value] < 0; }, crew);
}

TYPED_TEST(PlainMates, AreThoseOfTheReference) {
  constexpr int D = TypeParam::value;
  Rng rng(D);
  for (const auto mesh_class : support::kMeshClasses)
    for (int round = 0; round < 20; ++round) {
      const auto mesh = support::random_mesh<D>(mesh_class, rng);
      const CellSoup<D> soup{mesh.cells, mesh.vertex_count,
                             support::coherent_signs<D>(mesh.cells).value()};
      const auto expected = support::mates_of<D>(soup.cells);
      for (const int threads : {1, 2, 3}) {
        const auto mates = mates_of(soup, threads);
        ASSERT_TRUE(mates.has_value());
        EXPECT_EQ(mates, mates_by_records(soup, threads));
        ASSERT_EQ(mates->size(), expected.size());
        for (std::size_t h = 0; h < mates->size(); ++h)
          ASSERT_EQ((*mates)[h].value, expected[h] ? expected[h]->value : kNoIndex);
      }
    }
}

/// Whether the violation keeps a mesh from being plain.
bool is_not_plain(const Violation& violation) {
  return std::holds_alternative<DegenerateCell>(violation) ||
         std::holds_alternative<VertexOutOfRange>(violation) ||
         std::holds_alternative<DuplicateCell>(violation) ||
         std::holds_alternative<FacetInThreeCells>(violation) ||
         std::holds_alternative<OrientationConflict>(violation) ||
         std::holds_alternative<NonOrientable>(violation);
}

template <int D>
void expect_plain_as_checked(const CellSoup<D>& soup) {
  const auto found = check(soup);
  const bool plain = std::none_of(found.begin(), found.end(), is_not_plain);
  for (const int threads : {1, 2, 3}) {
    EXPECT_EQ(mates_of(soup, threads).has_value(), plain);
    EXPECT_EQ(mates_by_records(soup, threads).has_value(), plain);
  }
}

TYPED_TEST(PlainMates, ThereAreNoneIfAnythingIsWrong) {
  constexpr int D = TypeParam::value;
  Rng rng(10 + D);
  for (const Defect defect : support::kDefects)
    for (int round = 0; support::can_occur(defect, D) && round < 20; ++round) {
      const auto planted = support::plant<D>(defect, rng);
      expect_plain_as_checked(
          CellSoup<D>{planted.mesh.cells, planted.mesh.vertex_count, planted.signs});
    }
  for (int round = 0; round < 200; ++round) {
    const auto mesh = support::random_soup<D>(rng);
    expect_plain_as_checked(CellSoup<D>{mesh.cells, mesh.vertex_count, {}});
  }
}

// Many blocks and several rounds.
TYPED_TEST(PlainMates, AreTheSameByRecordsAndByBuckets) {
  constexpr int D = TypeParam::value;
  constexpr int sizes[] = {40000, 250, 20, 7};
  typename support::KuhnGrid<D>::Point nodes{};
  nodes.fill(sizes[D - 1]);
  support::KuhnGrid<D> grid(nodes);
  Rng rng(20 + D);
  support::scramble<D>(grid, rng);
  CellSoup<D> soup{std::move(grid.cells), grid.vertex_count, {}};
  soup.signs = std::get<std::vector<std::int8_t>>(orient(soup));
  const auto expected = mates_of(soup, 1);
  ASSERT_TRUE(expected.has_value());
  for (const int threads : {1, 2, 3}) EXPECT_EQ(mates_by_records(soup, threads), expected);
}

TYPED_TEST(PlainMates, OfNoCells) {
  constexpr int D = TypeParam::value;
  for (const std::size_t vertices : {0u, 3u}) {
    const auto mates = mates_of(CellSoup<D>{{}, vertices, {}}, 2);
    ASSERT_TRUE(mates.has_value());
    EXPECT_TRUE(mates->empty());
  }
}

TEST(WithoutOrder, IsAMeshWithShuffledCells) {
  support::KuhnGrid<3> grid({38, 38, 38});
  EXPECT_FALSE(detail::without_order<3>(grid.cells, grid.vertex_count));
  Rng rng(1);
  support::scramble<3>(grid, rng);
  EXPECT_TRUE(detail::without_order<3>(grid.cells, grid.vertex_count));
}

// One bucket with all facets of the mesh.
TEST(PlainMatesOfAFan, MatchAroundItsHub) {
  constexpr Index kTriangles = 20000;
  CellSoup<2> fan{{}, kTriangles + 1, {}};
  for (Index n = 0; n < kTriangles; ++n)
    fan.cells.push_back({VertexId{0}, VertexId{1 + n}, VertexId{1 + (n + 1) % kTriangles}});
  const auto mates = mates_of(fan, 1);
  ASSERT_TRUE(mates.has_value());
  EXPECT_FALSE(mates_by_records(fan, 1).has_value());  // too many in one block
  for (Index n = 0; n < kTriangles; ++n) {
    EXPECT_EQ((*mates)[half_facet<2>({n}, 0).value].value, kNoIndex);
    const auto across = half_facet<2>({(n + 1) % kTriangles}, 2);
    EXPECT_EQ((*mates)[half_facet<2>({n}, 1).value], across);
  }
}

/// Cells around a simplex of D-1 vertices, one next to the other; the others are numbered in steps.
template <int D>
CellSoup<D> fan_in_steps(Index cells, Index step) {
  constexpr Index kHub = D - 1;
  CellSoup<D> fan{{}, kHub + cells * step + 1, {}};
  for (Index n = 0; n < cells; ++n) {
    Cell<D> cell;
    for (Index i = 0; i < kHub; ++i) cell[i] = VertexId{i};
    cell[D - 1] = VertexId{kHub + n * step};
    cell[D] = VertexId{kHub + (n + 1) * step};
    fan.cells.push_back(cell);
  }
  return fan;
}

// Many facets meet in the hash table of one bucket: an arithmetic progression is hashed badly.
TYPED_TEST(PlainMates, AroundAHubOfVerticesNumberedInSteps) {
  constexpr int D = TypeParam::value;
  for (const auto& [cells, step] : {std::pair<Index, Index>{50000, 1},
                                    {1000, 3},
                                    {10000, 256},
                                    {5000, 1},
                                    {3530, 2},
                                    {700, 4096}}) {
    CellSoup<D> fan = fan_in_steps<D>(cells, step);
    const auto mates = mates_of(fan, 1);
    ASSERT_TRUE(mates.has_value()) << cells << " cells, step " << step;
    EXPECT_EQ(*mates, detail::match_facets<D>(fan.cells, fan.vertex_count).mates);
    EXPECT_EQ(assemble(fan).cell_count(), cells);

    fan.cells.push_back(fan.cells[cells / 2]);
    EXPECT_FALSE(mates_of(fan, 1).has_value());
    std::swap(fan.cells.back()[0], fan.cells.back()[1]);
    EXPECT_FALSE(mates_of(fan, 1).has_value());
    fan.cells.pop_back();
    std::swap(fan.cells.back()[0], fan.cells.back()[1]);  // the last cell is reversed
    EXPECT_FALSE(mates_of(fan, 1).has_value());
  }
}

TEST(Crew, PassesOnWhatAWorkerThrows) {
  for (const int threads : {1, 2, 3}) {
    detail::Crew crew(RunOptions{threads, {}});
    for (int thrower = 0; thrower < threads; ++thrower)
      EXPECT_THROW(crew.on_each([&](int worker) {
        if (worker == thrower) throw std::runtime_error("tired");
      }),
                   std::runtime_error);
    int calls = 0;
    EXPECT_NO_THROW(crew.on_each([&](int worker) { calls += worker == 0 ? 1 : 0; }));
    EXPECT_EQ(calls, 1);
  }
}

TEST(Crew, SharesEachNumberOnceAndReportsProgress) {
  for (const int threads : {1, 2}) {
    std::vector<double> told;
    detail::Crew crew(RunOptions{threads, [&](double done) { told.push_back(done); }});
    std::vector<int> times(100000, 0);
    for (const double until : {0.25, 1.0}) {
      crew.next_stage(until);
      const auto count = [&](int, std::size_t begin, std::size_t end) {
        for (std::size_t n = begin; n < end; ++n) ++times[n];
      };
      crew.on_blocks(times.size(), 0, 0.5, count);
      crew.share(times.size(), 0.5, 1, count);
    }
    EXPECT_EQ(std::count(times.begin(), times.end(), 4), 100000);
    EXPECT_LE(told.size(), 250u);
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    for (const double done : told) EXPECT_TRUE(0 <= done && done <= 1);
  }
}

}  // namespace
}  // namespace cleave::topology
