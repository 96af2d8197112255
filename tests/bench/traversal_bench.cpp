#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

#include "bodies.hpp"
#include "cleave/topology/ranges.hpp"
#include "cleave/topology/star_walker.hpp"
#include "cleave/topology/vertex_index.hpp"
#include "figure.hpp"
#include "flat_checks.hpp"

/// Walking through a complex that is there: all neighbours of all cells, all stars of all vertices.
namespace cleave::bench {
namespace {

using namespace topology;  // NOLINT(google-build-using-namespace): it is what is measured

const Body<3>& body_of(const benchmark::State& state) {
  return body<3>(static_cast<int>(state.range(0)),
                 state.range(1) == 0 ? Order::mesh : Order::random);
}

void same(std::uint64_t ours, std::uint64_t flat) {
  if (ours != flat) throw std::logic_error("the yardstick disagrees");
}

// Functions of their own, indices and sums of 32 bits: else g++ does not vectorize these loops.

[[gnu::noinline]] std::uint32_t sum_of_neighbours(std::span<const HalfFacetId> mates) {
  std::uint32_t sum = 0;
  for (std::size_t h = 0; h < mates.size(); ++h)
    if (detail::is_mate(mates[h])) sum += static_cast<std::uint32_t>(cell_of<3>(mates[h]).value);
  return sum;
}

[[gnu::noinline]] std::uint32_t sum_of_neighbours(const Complex<3>& k) {
  std::uint32_t sum = 0;
  for (const CellId cell : cells(k))
    for (const CellId neighbour : neighbours(k, cell))
      sum += static_cast<std::uint32_t>(neighbour.value);
  return sum;
}

[[gnu::noinline]] std::uint32_t sum_of_neighbours(const std::vector<std::uint32_t>& mates) {
  std::uint32_t sum = 0;
  for (const std::uint32_t mate : mates)
    if (mate != FlatMesh<3>::kNone) sum += mate / 4;
  return sum;
}

/// Nanoseconds per tetrahedron to name all its neighbours, from the array of mates; `range`: by the
/// range of the neighbours of each cell.
void all_neighbours(benchmark::State& state) {
  const Body<3>& whole = body_of(state);
  Turns turns;
  std::vector<double> range;
  for (auto _ : state) {
    std::uint32_t sum = 0, range_sum = 0, flat_sum = 0;
    turns.ours.push_back(seconds([&] { sum = sum_of_neighbours(whole.complex.mates()); }));
    turns.flat.push_back(seconds([&] { flat_sum = sum_of_neighbours(whole.flat.mates); }));
    range.push_back(seconds([&] { range_sum = sum_of_neighbours(whole.complex); }));
    same(sum, flat_sum);
    same(range_sum, flat_sum);
    state.SetIterationTime(turns.ours.back());
  }
  const auto cells = static_cast<double>(whole.complex.cell_count());
  report_ns(state, "ns/tet", turns, cells);
  state.counters["range"] = 1e9 * median(range) / cells;
}

/// Nanoseconds per incidence of a vertex and a tetrahedron, through the mates.
void all_stars(benchmark::State& state) {
  const Body<3>& whole = body_of(state);
  Turns turns;
  for (auto _ : state) {
    std::uint64_t sum = 0, flat_sum = 0;
    turns.ours.push_back(seconds([&] {
      StarWalker walker(whole.complex);
      for (const VertexId v : vertices(whole.complex))
        for (const CornerId corner : walker.around(v)) sum += corner.value;
    }));
    turns.flat.push_back(seconds([&] {
      for_each_star(whole.flat, [&](std::uint32_t, const auto& star) {
        for (const std::uint32_t corner : star) flat_sum += corner;
      });
    }));
    same(sum, flat_sum);
    state.SetIterationTime(turns.ours.back());
  }
  report_ns(state, "ns/incidence", turns, static_cast<double>(whole.complex.half_facet_count()));
}

/// What stands at every corner, so that an incidence is a look at a cell.
std::uint64_t sum_of_cell(const Cell<3>& cell) { return cell[0].value + cell[3].value; }

/// The same by an index of the corners of each vertex: making it, and then visiting the cells.
void indexed_stars(benchmark::State& state) {
  const Body<3>& whole = body_of(state);
  Turns make, visit;
  for (auto _ : state) {
    std::uint64_t sum = 0, flat_sum = 0;
    VertexIndex<3> index;
    make.ours.push_back(seconds([&] { index = VertexIndex<3>(whole.complex); }));
    visit.ours.push_back(seconds([&] {
      for (const VertexId v : vertices(whole.complex))
        for (const CornerId corner : index[v])
          sum += sum_of_cell(whole.complex.vertices(cell_of<3>(corner)));
    }));
    FlatIndex flat;
    make.flat.push_back(seconds([&] { flat = FlatIndex(whole.flat); }));
    visit.flat.push_back(seconds([&] {
      for (std::uint32_t v = 0; v < whole.flat.vertices; ++v)
        for (std::uint32_t n = flat.start[v]; n < flat.start[v + 1]; ++n) {
          const auto& cell = whole.flat.cells[flat.corners[n] / 4];
          flat_sum += std::uint64_t{cell[0]} + cell[3];
        }
    }));
    same(sum, flat_sum);
    state.SetIterationTime(visit.ours.back());
  }
  const auto incidences = static_cast<double>(whole.complex.half_facet_count());
  report_ns(state, "ns/incidence", visit, incidences);
  report_ns(state, "make", make, incidences, "make_");
}

void bodies(benchmark::internal::Benchmark* b) {
  b->ArgsProduct({{40, 100}, {0, 1}})
      ->ArgNames({"cubes", "shuffled"})
      ->Iterations(5)
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond);
}

BENCHMARK(all_neighbours)->Apply(bodies);
BENCHMARK(all_stars)->Apply(bodies);
BENCHMARK(indexed_stars)->Apply(bodies);

}  // namespace
}  // namespace cleave::bench
