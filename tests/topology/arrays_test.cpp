#include "cleave/topology/arrays.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <numeric>

#include "cleave/support/heap.hpp"
#include "cleave/support/meshes.hpp"
#include "cleave/topology/assemble.hpp"
#include "cleave/topology/certify.hpp"
#include "cleave/topology/check.hpp"
#include "cleave/topology/facet_set.hpp"
#include "cleave/topology/locate.hpp"
#include "cleave/topology/unglue.hpp"

namespace cleave::topology {
namespace {

using Signed = std::make_signed_t<Index>;

/// Kuhn's cube of six tetrahedra, as the plain numbers that somebody else holds.
template <class Number>
std::vector<Number> cube() {
  const support::KuhnGrid<3> grid({2, 2, 2});
  std::vector<Number> numbers;
  for (const Cell<3>& cell : grid.cells)
    for (const VertexId v : cell) numbers.push_back(static_cast<Number>(v.value));
  return numbers;
}

/// Does `action` and expects that no memory was asked for.
template <class Action>
void expect_no_memory(Action action) {
  const support::MemoryLimit nothing(0);
  EXPECT_NO_THROW(action());
}

template <class Number, class Array>
void expect_seen_where_it_lies(const Array& array, const Number* first, std::size_t numbers) {
  std::span<const Cell<3>> cells;
  expect_no_memory([&] { cells = as_cells<3>(array); });
  EXPECT_EQ(static_cast<const void*>(cells.data()), static_cast<const void*>(first));
  ASSERT_EQ(4 * cells.size(), numbers);
  for (std::size_t n = 0; n < numbers; ++n)
    EXPECT_EQ(cells[n / 4][n % 4].value, static_cast<Index>(first[n]));

  CellView<3> view = CellView<3>::of({}, 0);
  expect_no_memory([&] { view = CellView<3>::of(cells, 8); });
  EXPECT_EQ(view.cells.data(), cells.data());
}

TEST(Arrays, AreSeenWhereTheyLie) {
  const auto ours = cube<Index>();
  expect_seen_where_it_lies(ours, ours.data(), ours.size());
  const auto theirs = cube<Signed>();
  expect_seen_where_it_lies(theirs, theirs.data(), theirs.size());
  expect_seen_where_it_lies(std::span(theirs.data(), 8), theirs.data(), 8);  // a bare pointer

  std::vector<std::array<Index, 4>> tuples(6);
  for (std::size_t n = 0; n < ours.size(); ++n) tuples[n / 4][n % 4] = ours[n];
  expect_seen_where_it_lies(tuples, tuples[0].data(), ours.size());

  using Rows = Eigen::Matrix<Signed, Eigen::Dynamic, 4, Eigen::RowMajor>;
  const Rows rows = Eigen::Map<const Rows>(theirs.data(), 6, 4);
  expect_seen_where_it_lies(std::span(rows.data(), static_cast<std::size_t>(rows.size())),
                            rows.data(), theirs.size());
  using Columns = Eigen::Matrix<Signed, 4, Eigen::Dynamic>;  // one cell per column
  const Columns columns = rows.transpose();
  expect_seen_where_it_lies(std::span(columns.data(), static_cast<std::size_t>(columns.size())),
                            columns.data(), theirs.size());
}

TEST(Arrays, OfNoWholeTuplesAreRefused) {
  const std::vector<Signed> seven(7), none;
  EXPECT_THROW(as_cells<3>(seven), std::invalid_argument);
  EXPECT_THROW(as_facets<3>(seven), std::invalid_argument);
  EXPECT_TRUE(as_cells<3>(none).empty());
  static_assert(!ArrayOfNumbers<std::vector<Signed>>, "a temporary would leave nothing to see");
}

TEST(Arrays, AreJudgedAsTheirCopiesAre) {
  const auto numbers = cube<Signed>();
  const auto view = CellView<3>::of(as_cells<3>(numbers), 8);
  const CellSoup<3> copy = copy_of(view);
  const auto found = check(view), expected = check(copy);
  ASSERT_EQ(found.size(), expected.size());
  EXPECT_FALSE(found.empty());  // every second cell is turned over
  for (std::size_t n = 0; n < found.size(); ++n)
    EXPECT_EQ(describe(found[n]), describe(expected[n]));
  const auto signs = std::get<0>(orient(view));
  EXPECT_EQ(signs, std::get<0>(orient(copy)));
  const auto oriented = CellView<3>::of(view.cells, 8, signs);
  EXPECT_TRUE(check(oriented).empty());
  EXPECT_EQ(assemble(copy_of(oriented)).cell_count(), 6u);
}

TEST(Arrays, ShowNegativeNumbersAsOutOfRange) {
  auto numbers = cube<Signed>();
  numbers[5] = -1;
  const auto violations = check(CellView<3>::of(as_cells<3>(numbers), 8));
  ASSERT_EQ(violations.size(), 1u);
  const auto& found = std::get<VertexOutOfRange>(violations[0]);
  EXPECT_EQ(found.cell, CellId{1});
  EXPECT_EQ(found.vertex, VertexId{kNoIndex});
}

TEST(Arrays, NameFacetsAndCutsToo) {
  const auto numbers = cube<Signed>();
  const auto before = as_cells<3>(numbers);
  const std::vector<Signed> facet = {numbers[0], numbers[1], numbers[3]};  // around the diagonal
  const auto found = locate_facets<3>(before, as_facets<3>(facet));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0], (half_facet<3>({0}, 2)));

  const auto signs = std::get<0>(orient(CellView<3>::of(before, 8)));
  auto k = assemble(copy_of(CellView<3>::of(before, 8, signs)));
  std::vector<Signed> cut(k.half_facet_count());
  std::iota(cut.begin(), cut.end(), 0);
  std::erase_if(cut, [&](Signed h) { return !k.is_interior({static_cast<Index>(h)}); });
  unglue(k, FacetSet::of(k, as_ids<HalfFacetId>(cut)));
  EXPECT_EQ(k.vertex_count(), 24u);

  const auto after = as_numbers(k.cells());
  EXPECT_EQ(static_cast<const void*>(after.data()), static_cast<const void*>(k.cells().data()));
  EXPECT_EQ(after.size(), 24u);
  EXPECT_EQ(as_numbers(k.mates()).size(), k.half_facet_count());
  EXPECT_FALSE(certify<3>(before, as_ids<HalfFacetId>(cut), as_cells<3>(after)));
}

TEST(Arrays, AreTakenOverByAssembleIfTheyAreMoved) {
  auto numbers = cube<Signed>();
  const auto view = CellView<3>::of(as_cells<3>(numbers), 8);
  CellSoup<3> soup = copy_of(view);
  soup.signs = std::get<0>(orient(view));
  const auto* lies = soup.cells.data();
  const Complex<3> k = assemble(std::move(soup));
  EXPECT_EQ(k.cells().data(), lies);
}

}  // namespace
}  // namespace cleave::topology
