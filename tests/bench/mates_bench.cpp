#include <benchmark/benchmark.h>

#include <chrono>
#include <stdexcept>

#include "bodies.hpp"
#include "cleave/topology/assemble.hpp"
#include "figure.hpp"
#include "plain_mates.hpp"

/// What assembly spends most of its time on, apart; and what a second thread brings.
namespace cleave::bench {
namespace {

using namespace topology;  // NOLINT(google-build-using-namespace): it is what is measured

const CellSoup<3>& cube(const benchmark::State& state) {
  const auto cubes = static_cast<int>(state.range(0));
  const Order order = state.range(1) == 0 ? Order::mesh : Order::random;
  return last_made<CellSoup<3>>(std::pair(cubes, order),
                                [&] { return kuhn_soup<3>(cubes, order); });
}

std::vector<HalfFacetId> match(const CellSoup<3>& soup, int threads) {
  topology::detail::Crew crew(RunOptions{threads, {}});
  auto mates = topology::detail::plain_mates<3>(
      soup.cells, soup.vertex_count, [&](CellId c) { return soup.signs[c.value] < 0; }, crew);
  if (!mates) throw std::logic_error("the cube is not plain");
  return std::move(*mates);
}

/// Mates of tuples with signs, and whether these are coherent; beside the faster of the yardstick's
/// two ways.
void match_cells(benchmark::State& state) {
  const CellSoup<3>& soup = cube(state);
  FlatMesh<3> flat = flat_mesh(soup);
  Turns turns;
  for (auto _ : state) {
    turns.ours.push_back(seconds([&] { benchmark::DoNotOptimize(match(soup, 1)); }));
    flat.mates = {};
    const double by_cells = seconds([&] { flat.match(); });
    flat.mates = {};
    turns.flat.push_back(std::min(by_cells, seconds([&] { flat.match_by_facets(); })));
    state.SetIterationTime(turns.ours.back());
  }
  report_millions(state, "Mtet/s", turns, static_cast<double>(soup.cells.size()));
}

/// How much faster two threads are than one, by the clock: only a quiet machine tells. `ours_of_1`
/// and `ours_of_2` are the processor time of the calling thread, which bears all that is not
/// shared.
void assemble_on_two_threads(benchmark::State& state) {
  const CellSoup<3>& soup = cube(state);
  std::vector<double> speedups, own[2];
  for (auto _ : state) {
    double took[2] = {};
    for (const int threads : {1, 2}) {
      CellSoup<3> input = soup;
      const auto start = std::chrono::steady_clock::now();
      own[threads - 1].push_back(seconds([&] {
        benchmark::DoNotOptimize(assemble(std::move(input), {threads, {}}).cell_count());
      }));
      took[threads - 1] =
          std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
    speedups.push_back(took[0] / took[1]);
    state.SetIterationTime(took[1]);
  }
  const auto tets = static_cast<double>(soup.cells.size());
  state.counters["speedup"] = median(speedups);
  state.counters["ours_of_1"] = 1e9 * median(own[0]) / tets;
  state.counters["ours_of_2"] = 1e9 * median(own[1]) / tets;
}

void sizes(benchmark::internal::Benchmark* b) {
  for (const int shuffle : {0, 1})
    for (const int cubes : {40, 100}) b->Args({cubes, shuffle});
  b->ArgNames({"cubes", "shuffled"})->Iterations(5)->UseManualTime()->Unit(benchmark::kMillisecond);
}

BENCHMARK(match_cells)->Apply(sizes);
BENCHMARK(assemble_on_two_threads)->Apply(sizes);

}  // namespace
}  // namespace cleave::bench
