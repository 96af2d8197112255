// What assembly asks of the heap, and that a lack of it comes out, from any thread.
#include <gtest/gtest.h>

#include <algorithm>
#include <thread>
#include <vector>

#include "cleave/support/heap.hpp"
#include "cleave/support/meshes.hpp"
#include "cleave/support/random_meshes.hpp"
#include "cleave/support/rng.hpp"
#include "cleave/topology/assemble.hpp"
#include "cleave/topology/check.hpp"

namespace cleave::topology {
namespace {

/// A Kuhn cube of n^3 cubes, oriented.
CellSoup<3> cube(int n, bool scrambled) {
  support::KuhnGrid<3> grid({n + 1, n + 1, n + 1});
  support::Rng rng(1);
  if (scrambled) support::scramble<3>(grid, rng);
  CellSoup<3> soup{std::move(grid.cells), grid.vertex_count, {}};
  soup.signs = std::get<std::vector<std::int8_t>>(orient(soup));
  soup.cells.shrink_to_fit();
  return soup;
}

/// How much more ids take than those of 32 bits.
constexpr double kWide = sizeof(Index) / 4.0;

struct BytesPerCell {
  double held, peak;
};

BytesPerCell bytes_of_assembly(CellSoup<3> soup, int threads) {
  const auto cells = static_cast<double>(soup.cells.size());
  const std::size_t input =
      soup.cells.capacity() * sizeof(Cell<3>) + soup.signs.capacity() * sizeof(std::int8_t);
  const std::size_t before = support::heap_bytes() - input;
  support::forget_heap_peak();
  const Complex<3> k = assemble(std::move(soup), {threads, {}});
  return {static_cast<double>(support::heap_bytes() - before) / cells,
          static_cast<double>(support::heap_peak() - before) / cells};
}

// A thread more takes 4 bytes per vertex, of which there are 5.3 cells to one here.
TEST(MemoryOfAssembly, IsFewBytesPerTetrahedron) {
  for (const bool scrambled : {false, true})
    for (const int threads : {1, 2}) {
      const BytesPerCell bytes = bytes_of_assembly(cube(24, scrambled), threads);
      EXPECT_LE(bytes.held, 33.0 * kWide);
      EXPECT_LE(bytes.peak, (threads == 1 ? 41.0 : 42.0) * kWide);
    }
}

// Large enough to be matched by records of corners.
TEST(MemoryOfAssembly, IsTwiceTheResultIfThereIsNoOrder) {
  const CellSoup<3> soup = cube(37, true);
  for (const int threads : {1, 2}) {
    const BytesPerCell bytes = bytes_of_assembly(soup, threads);
    EXPECT_LE(bytes.held, 33.0 * kWide);
    EXPECT_GE(bytes.peak, 50.0 * kWide);
    EXPECT_LE(bytes.peak, 57.0 * kWide);
  }
}

TEST(MemoryOfAssembly, ALackOfItComesOut) {
  for (const int n : {12, 37}) {
    const CellSoup<3> soup = cube(n, true);
    for (const int threads : {1, 2}) {
      std::size_t cells = 0;
      const std::size_t needed = support::run_out_of_memory(
          [&] {
            CellSoup<3> copy = soup;
            cells = assemble(std::move(copy), {threads, {}}).cell_count();
          },
          [] {});
      EXPECT_GT(needed, 8u);
      EXPECT_EQ(cells, soup.cells.size());
    }
  }
}

TEST(ProgressOfAssembly, AscendsToOneOnTheCallingThread) {
  const CellSoup<3> ordered = cube(12, false), scrambled = cube(37, true);
  const auto caller = std::this_thread::get_id();
  for (const int run : {1, 2, 3, 4, 5}) {
    const CellSoup<3>& soup = run <= 3 ? ordered : scrambled;
    const int threads = run <= 3 ? run : run - 3;
    std::vector<double> told;
    assemble(soup, {threads, [&](double done) {
                      EXPECT_EQ(std::this_thread::get_id(), caller);
                      told.push_back(done);
                    }});
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    ASSERT_FALSE(told.empty());
    EXPECT_LE(told.size(), 400u);
    EXPECT_GE(told.front(), 0.0);
    EXPECT_EQ(told.back(), 1.0);
  }
}

TEST(ProgressOfAssembly, CanEndIt) {
  const CellSoup<3> soup = cube(12, false);
  struct Interrupted {};
  for (const int threads : {1, 2})
    for (int patience = 0; patience < 5; ++patience) {
      int left = patience;
      EXPECT_THROW(assemble(soup, {threads,
                                   [&](double) {
                                     if (left-- == 0) throw Interrupted{};
                                   }}),
                   Interrupted);
    }
}

}  // namespace
}  // namespace cleave::topology
