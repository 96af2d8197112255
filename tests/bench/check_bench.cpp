#include <benchmark/benchmark.h>

#include <stdexcept>
#include <vector>

#include "bodies.hpp"
#include "cleave/support/heap.hpp"
#include "cleave/topology/certify.hpp"
#include "cleave/topology/check.hpp"
#include "cleave/topology/unglue.hpp"
#include "figure.hpp"
#include "flat_checks.hpp"
#include "patches.hpp"

/// Judging a mesh, and a cut: time after the files have been read, and the most bytes per cell that
/// it takes besides its input.
namespace cleave::bench {
namespace {

using namespace topology;  // NOLINT(google-build-using-namespace): it is what is measured

template <class Work>
double peak_bytes(Work work) {
  const std::size_t before = support::heap_bytes();
  support::forget_heap_peak();
  work();
  return static_cast<double>(support::heap_peak() - before);
}

/// All rules, all levels. The yardstick answers yes or no: mates, orientations, and for every
/// vertex whether its star is one part and its link a sphere or a disk.
void check_cells(benchmark::State& state) {
  const Order order = state.range(1) == 0 ? Order::mesh : Order::random;
  const CellSoup<3> soup = kuhn_soup<3>(static_cast<int>(state.range(0)), order);
  FlatMesh<3> flat = flat_mesh(soup);
  Turns turns;
  double peak = 0;
  for (auto _ : state) {
    bool good = false;
    peak = peak_bytes([&] {
      turns.ours.push_back(seconds([&] { good = check(soup, Level::manifold).empty(); }));
    });
    flat.mates = {};
    bool flat_good = false;
    turns.flat.push_back(seconds([&] {
      flat_good = (order == Order::mesh ? flat.match() : flat.match_by_facets()) &&
                  links_are_spheres_or_disks(flat);
    }));
    if (!good || !flat_good) throw std::logic_error("the grid is a manifold");
    state.SetIterationTime(turns.ours.back());
  }
  const auto cells = static_cast<double>(soup.cells.size());
  report_ns(state, "ns/cell", turns, cells);
  state.counters["s"] = median(turns.ours);
  state.counters["peak_B/cell"] = peak / cells;
}

/// The certificate of a cut of `facets` facets. The yardstick answers yes or no.
void certify_cut(benchmark::State& state) {
  const Body<3>& whole = body<3>(static_cast<int>(state.range(0)));
  const FacetSet cut = patches(whole, static_cast<std::size_t>(state.range(1)));
  const auto flat_cut = numbers(cut.half_facets());
  Complex<3> after = whole.complex;
  unglue(after, cut);
  const std::vector<std::int8_t> signs(after.cell_count(), 1);
  const auto flat_after = flat_mesh<3>(after.cells(), after.vertex_count(), signs).cells;
  Turns turns;
  double peak = 0;
  for (auto _ : state) {
    bool good = false;
    peak = peak_bytes([&] {
      turns.ours.push_back(seconds(
          [&] { good = !certify<3>(whole.complex.cells(), cut.half_facets(), after.cells()); }));
    });
    FlatMesh<3> before = whole.flat;
    before.mates = {};
    bool flat_good = false;
    turns.flat.push_back(
        seconds([&] { flat_good = before.match() && is_unglued(before, flat_cut, flat_after); }));
    if (!good || !flat_good) throw std::logic_error("the cut is as it should be");
    state.SetIterationTime(turns.ours.back());
  }
  const auto cells = static_cast<double>(whole.complex.cell_count());
  report_ns(state, "ns/cell", turns, cells);
  state.counters["s"] = median(turns.ours);
  state.counters["peak_B/cell"] = peak / cells;
}

BENCHMARK(check_cells)
    ->ArgsProduct({{40, 100}, {0, 1}})
    ->ArgNames({"cubes", "shuffled"})
    ->Iterations(3)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

BENCHMARK(certify_cut)
    ->Args({40, 10000})
    ->Args({100, 100000})
    ->ArgNames({"cubes", "facets"})
    ->Iterations(3)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace cleave::bench
