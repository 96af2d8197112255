#include <benchmark/benchmark.h>

#include <cstdint>
#include <stdexcept>

#include "bodies.hpp"
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

/// Nanoseconds per tetrahedron to name all its neighbours.
void neighbours(benchmark::State& state) {
  const Body<3>& whole = body_of(state);
  Turns turns;
  for (auto _ : state) {
    std::uint64_t sum = 0, flat_sum = 0;
    turns.ours.push_back(seconds([&] {
      const auto cells = static_cast<Index>(whole.complex.cell_count());
      for (Index c = 0; c < cells; ++c)
        for (int i = 0; i < 4; ++i)
          if (const auto mate = whole.complex.mate(half_facet<3>(CellId{c}, i)))
            sum += cell_of<3>(*mate).value;
    }));
    turns.flat.push_back(seconds([&] {
      for (const std::uint32_t mate : whole.flat.mates)
        if (mate != FlatMesh<3>::kNone) flat_sum += mate / 4;
    }));
    same(sum, flat_sum);
    state.SetIterationTime(turns.ours.back());
  }
  report_ns(state, "ns/tet", turns, static_cast<double>(whole.complex.cell_count()));
}

/// Nanoseconds per incidence of a vertex and a tetrahedron, through the mates.
void stars(benchmark::State& state) {
  const Body<3>& whole = body_of(state);
  Turns turns;
  for (auto _ : state) {
    std::uint64_t sum = 0, flat_sum = 0;
    turns.ours.push_back(seconds([&] {
      const auto vertices = static_cast<Index>(whole.complex.vertex_count());
      for (Index v = 0; v < vertices; ++v)
        for (const CornerId corner : star(whole.complex, VertexId{v})) sum += corner.value;
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

void bodies(benchmark::internal::Benchmark* b) {
  b->ArgsProduct({{40, 100}, {0, 1}})
      ->ArgNames({"cubes", "shuffled"})
      ->Iterations(5)
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond);
}

BENCHMARK(neighbours)->Apply(bodies);
BENCHMARK(stars)->Apply(bodies);

}  // namespace
}  // namespace cleave::bench
