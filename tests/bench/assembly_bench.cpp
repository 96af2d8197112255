#include <benchmark/benchmark.h>

#include <span>
#include <stdexcept>

#include "bodies.hpp"
#include "cleave/support/heap.hpp"
#include "figure.hpp"
#include "flat_checks.hpp"

/// From tuples to mates and orientation, and to a validated complex.
namespace cleave::bench {
namespace {

using namespace topology;  // NOLINT(google-build-using-namespace): it is what is measured

/// The faster of the yardstick's two ways.
template <int D>
double seconds_to_match(FlatMesh<D>& flat) {
  flat.mates = {};
  bool coherent = true;
  const double by_cells = seconds([&] { coherent &= flat.match(); });
  flat.mates = {};
  const double by_facets = seconds([&] { coherent &= flat.match_by_facets(); });
  if (!coherent) throw std::logic_error("the yardstick finds the cells not coherent");
  return std::min(by_cells, by_facets);
}

const CellSoup<3>& cube(int cubes, Order order) {
  return last_made<CellSoup<3>>(std::pair(cubes, order),
                                [&] { return kuhn_soup<3>(cubes, order); });
}

Order order_of(const benchmark::State& state) {
  return state.range(1) == 0 ? Order::mesh : Order::random;
}

/// Mates from tuples, and signs that make them coherent: the public `orient`.
void orient_cells(benchmark::State& state) {
  const CellSoup<3>& soup = cube(static_cast<int>(state.range(0)), order_of(state));
  const auto tets = static_cast<double>(soup.cells.size());
  FlatMesh<3> flat = flat_mesh(soup);
  Turns turns;
  for (auto _ : state) {
    turns.ours.push_back(seconds([&] { benchmark::DoNotOptimize(orient(soup)); }));
    turns.flat.push_back(seconds_to_match(flat));
    state.SetIterationTime(turns.ours.back());
  }
  report_millions(state, "Mtet/s", turns, tets);
}

/// `held`: bytes per tetrahedron of the complex; `peak`: at the worst moment of assemble, its
/// input, which becomes part of the complex, included. The yardstick finds mates, compares
/// orientations and walks around every vertex, as assemble does, but says nothing of what it finds.
void assemble_cells(benchmark::State& state) {
  const CellSoup<3>& soup = cube(static_cast<int>(state.range(0)), order_of(state));
  const auto tets = static_cast<double>(soup.cells.size());
  FlatMesh<3> flat = flat_mesh(soup);
  Turns turns;
  double held = 0, peak = 0;
  for (auto _ : state) {
    const std::size_t before = support::heap_bytes();
    CellSoup<3> input = soup;
    support::forget_heap_peak();
    {
      Complex<3> k;
      turns.ours.push_back(seconds([&] { k = assemble(std::move(input)); }));
      held = static_cast<double>(support::heap_bytes() - before);
      peak = static_cast<double>(support::heap_peak() - before);
    }
    const double match = seconds_to_match(flat);
    bool regular = false;
    turns.flat.push_back(match + seconds([&] { regular = is_cut_regular(flat); }));
    if (!regular) throw std::logic_error("the yardstick finds a star in parts");
    state.SetIterationTime(turns.ours.back());
  }
  report_millions(state, "Mtet/s", turns, tets);
  state.counters["held_B/cell"] = held / tets;
  state.counters["peak_B/cell"] = peak / tets;
}

void sizes(benchmark::internal::Benchmark* b) {
  for (const int shuffle : {0, 1})
    for (const int cubes : {40, 50, 63, 80, 100}) b->Args({cubes, shuffle});
  b->ArgNames({"cubes", "shuffled"})->Iterations(5)->UseManualTime()->Unit(benchmark::kMillisecond);
}

BENCHMARK(orient_cells)->Apply(sizes);
BENCHMARK(assemble_cells)->Apply(sizes);

}  // namespace
}  // namespace cleave::bench
