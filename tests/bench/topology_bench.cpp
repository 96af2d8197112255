#include <benchmark/benchmark.h>

#include <memory>
#include <stdexcept>

#include "cleave/support/heap.hpp"
#include "cleave/support/meshes.hpp"
#include "cleave/support/rng.hpp"
#include "cleave/topology/assemble.hpp"
#include "cleave/topology/check.hpp"
#include "cleave/topology/incision.hpp"
#include "cleave/topology/locate.hpp"
#include "cleave/topology/unglue.hpp"
#include "flat_yardstick.hpp"
#include "median.hpp"

/// Times are processor time on one thread, medians over the iterations; `flat` is the yardstick,
/// run in turn with the library, `ratio` its speed divided by ours (1: as fast, 2: half as fast).
namespace cleave::bench {
namespace {

using namespace topology;  // NOLINT(google-build-using-namespace): it is what is measured

/// The Kuhn cube of cubes^3 cubes, 6 tetrahedra each, coherently oriented.
CellSoup<3> kuhn_cube(int cubes) {
  support::KuhnGrid<3> grid({cubes + 1, cubes + 1, cubes + 1});
  CellSoup<3> soup{std::move(grid.cells), grid.vertex_count, {}};
  soup.signs = std::get<std::vector<std::int8_t>>(orient(soup));
  return soup;
}

/// The same complex with its cells and vertices numbered at random.
CellSoup<3> shuffled(const CellSoup<3>& soup) {
  support::Rng rng(1);
  std::vector<std::uint32_t> vertex(soup.vertex_count), order(soup.cells.size());
  for (std::uint32_t v = 0; v < vertex.size(); ++v) vertex[v] = v;
  for (std::uint32_t c = 0; c < order.size(); ++c) order[c] = c;
  rng.shuffle(vertex);
  rng.shuffle(order);
  CellSoup<3> result{{}, soup.vertex_count, {}};
  for (const std::uint32_t c : order) {
    Cell<3> cell = soup.cells[c];
    for (VertexId& v : cell) v = {vertex[v.value]};
    result.cells.push_back(cell);
    result.signs.push_back(soup.signs[c]);
  }
  return result;
}

FlatMesh flat_mesh(std::span<const Cell<3>> cells, std::size_t vertex_count) {
  FlatMesh flat;
  for (const Cell<3>& cell : cells)
    flat.cells.push_back({cell[0].value, cell[1].value, cell[2].value, cell[3].value});
  flat.vertices = static_cast<std::uint32_t>(vertex_count);
  return flat;
}

/// Million tetrahedra per second. `held`: bytes per tetrahedron of the complex; `peak`: at the
/// worst moment of assemble, its input, which becomes part of the complex, included.
void assembly(benchmark::State& state) {
  CellSoup<3> soup = kuhn_cube(static_cast<int>(state.range(0)));
  if (state.range(1) != 0) soup = shuffled(soup);
  const auto tets = static_cast<double>(soup.cells.size());
  FlatMesh flat = flat_mesh(soup.cells, soup.vertex_count);
  std::vector<double> ours, yardstick;
  double held = 0, peak = 0;
  for (auto _ : state) {
    const std::size_t before = support::heap_bytes();
    CellSoup<3> input = soup;
    support::forget_heap_peak();
    Complex<3> k;
    ours.push_back(seconds([&] { k = assemble(std::move(input)); }));
    held = static_cast<double>(support::heap_bytes() - before);
    peak = static_cast<double>(support::heap_peak() - before);
    flat.mates = {};
    yardstick.push_back(seconds([&] { flat.match(); }));
    state.SetIterationTime(ours.back());
  }
  state.counters["Mtet/s"] = 1e-6 * tets / median(ours);
  state.counters["flat"] = 1e-6 * tets / median(yardstick);
  state.counters["ratio"] = median(ours) / median(yardstick);
  state.counters["held_B/tet"] = held / tets;
  state.counters["peak_B/tet"] = peak / tets;
}

/// A cube assembled once for all benchmarks on it; the one before is dropped.
struct Body {
  explicit Body(int n) : cubes(n), complex(assemble(kuhn_cube(n))) {
    flat = flat_mesh(complex.cells(), complex.vertex_count());
    flat.match();
  }
  int cubes;
  Complex<3> complex;
  FlatMesh flat;
};

const Body& body(int cubes) {
  static std::unique_ptr<Body> last;
  if (!last || last->cubes != cubes) {
    last.reset();
    last = std::make_unique<Body>(cubes);
  }
  return *last;
}

/// `count` facets in square patches with a rim inside, on parallel planes spread over the body.
std::vector<HalfFacetId> patches(const Body& body, int count) {
  const int largest = 2 * (body.cubes - 2) * (body.cubes - 2);
  const int planes = (count + largest - 1) / largest;
  int side = 1;
  while (2 * side * side * planes < count) ++side;
  const int low = (body.cubes - side) / 2;
  const auto vertex = [&](int x, int y, int z) {
    const int nodes = body.cubes + 1;
    return VertexId{static_cast<std::uint32_t>((x * nodes + y) * nodes + z)};
  };
  std::vector<Facet<3>> facets;
  for (int plane = 1; plane <= planes; ++plane) {
    const int x = plane * body.cubes / (planes + 1);
    for (int y = low; y < low + side; ++y)
      for (int z = low; z < low + side; ++z) {
        const VertexId from = vertex(x, y, z), to = vertex(x, y + 1, z + 1);
        facets.push_back({from, vertex(x, y + 1, z), to});
        facets.push_back({from, vertex(x, y, z + 1), to});
      }
  }
  facets.resize(static_cast<std::size_t>(count));
  std::vector<HalfFacetId> half_facets;
  for (const auto& found : locate_facets<3>(body.complex.cells(), facets))
    half_facets.push_back(found.value());
  return half_facets;
}

std::vector<std::uint32_t> numbers(std::span<const HalfFacetId> half_facets) {
  std::vector<std::uint32_t> values;
  for (const HalfFacetId h : half_facets) values.push_back(h.value);
  return values;
}

/// Nanoseconds per facet of the cut; `verified`: with Verify::touched, the default.
void unglue_patches(benchmark::State& state) {
  const Body& whole = body(static_cast<int>(state.range(0)));
  const auto count = static_cast<int>(state.range(1));
  const FacetSet cut = FacetSet::of(whole.complex, patches(whole, count));
  const auto flat_cut = numbers(cut.half_facets());
  std::vector<double> ours, verified, yardstick;
  Relabelling change;
  for (auto _ : state) {
    auto k = std::make_unique<Complex<3>>(whole.complex);
    ours.push_back(seconds([&] { change = unglue(*k, cut, Verify::none); }));
    k = std::make_unique<Complex<3>>(whole.complex);
    verified.push_back(seconds([&] { change = unglue(*k, cut); }));
    k.reset();
    FlatMesh flat = whole.flat;
    std::uint32_t added = 0;
    yardstick.push_back(seconds([&] { added = flat.unglue(flat_cut); }));
    if (added != change.splits.size()) throw std::logic_error("the yardstick disagrees");
    state.SetIterationTime(ours.back());
  }
  state.counters["ns/facet"] = 1e9 * median(ours) / count;
  state.counters["verified"] = 1e9 * median(verified) / count;
  state.counters["flat"] = 1e9 * median(yardstick) / count;
  state.counters["ratio"] = median(ours) / median(yardstick);
  state.counters["copies"] = static_cast<double>(change.splits.size());
}

/// Nanoseconds for one facet, given as a half-facet, another one each time; most are found shut.
void unglue_one_facet(benchmark::State& state) {
  const Body& whole = body(static_cast<int>(state.range(0)));
  Complex<3> k = whole.complex;
  FlatMesh flat = whole.flat;
  support::Rng rng(2);
  const auto interior = [&] {
    HalfFacetId h{};
    do h = {static_cast<std::uint32_t>(rng.below(k.half_facet_count()))};
    while (!k.is_interior(h) || flat.mates[h.value] == FlatMesh::kNone);
    return std::vector{h};
  };
  std::vector<double> ours, verified, yardstick;
  for (auto _ : state) {
    auto one = interior();
    ours.push_back(seconds([&] { unglue(k, FacetSet::of(k, one), Verify::none); }));
    one = interior();
    verified.push_back(seconds([&] { unglue(k, FacetSet::of(k, one)); }));
    const auto number = numbers(interior());
    yardstick.push_back(seconds([&] { flat.unglue(number); }));
    state.SetIterationTime(ours.back());
  }
  state.counters["ns/facet"] = 1e9 * median(ours);
  state.counters["verified"] = 1e9 * median(verified);
  state.counters["flat"] = 1e9 * median(yardstick);
  state.counters["ratio"] = median(ours) / median(yardstick);
}

/// Nanoseconds per facet of a stitch that takes a whole cut back, beside the cut it undoes: both as
/// steps of an incision, and the bare unglue. `half`: of taking every second facet back, per facet.
/// `ratio`: stitch to bare unglue, both without verification.
void stitch_patches(benchmark::State& state) {
  const Body& whole = body(static_cast<int>(state.range(0)));
  const auto count = static_cast<int>(state.range(1));
  const FacetSet cut = FacetSet::of(whole.complex, patches(whole, count));
  std::vector<HalfFacetId> every_second;
  for (std::size_t n = 0; n < cut.size(); n += 2) every_second.push_back(cut.half_facets()[n]);
  const FacetSet half = FacetSet::of_lesser(every_second);
  std::vector<double> bare, cuts, stitches, verified, halves;
  Incision<3> incision(whole.complex);
  std::size_t merges = 0;
  for (auto _ : state) {
    {
      const auto k = std::make_unique<Complex<3>>(whole.complex);
      bare.push_back(seconds([&] { unglue(*k, cut, Verify::none); }));
    }
    cuts.push_back(seconds([&] { incision.cut(cut, Verify::none); }));
    stitches.push_back(seconds([&] { merges = incision.stitch(cut, Verify::none).merges.size(); }));
    incision.cut(cut, Verify::none);
    verified.push_back(seconds([&] { incision.stitch(cut); }));
    incision.cut(cut, Verify::none);
    halves.push_back(seconds([&] { incision.stitch(half, Verify::none); }));
    incision.stitch(cut, Verify::none);
    incision.forget_steps();
    state.SetIterationTime(stitches.back());
  }
  state.counters["ns/facet"] = 1e9 * median(stitches) / count;
  state.counters["verified"] = 1e9 * median(verified) / count;
  state.counters["half"] = 1e9 * median(halves) / static_cast<double>(half.size());
  state.counters["cut"] = 1e9 * median(cuts) / count;
  state.counters["unglue"] = 1e9 * median(bare) / count;
  state.counters["ratio"] = median(stitches) / median(bare);
  state.counters["merges"] = static_cast<double>(merges);
}

void sizes_that_double(benchmark::internal::Benchmark* b) {
  for (const int shuffle : {0, 1})
    for (const int cubes : {10, 13, 16, 20, 25, 32, 40, 50, 63, 80, 100}) b->Args({cubes, shuffle});
}

BENCHMARK(assembly)
    ->Apply(sizes_that_double)
    ->ArgNames({"cubes", "shuffled"})
    ->Iterations(5)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

BENCHMARK(unglue_one_facet)
    ->Arg(40)
    ->Arg(100)
    ->ArgName("cubes")
    ->Iterations(1001)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);

BENCHMARK(stitch_patches)
    ->ArgsProduct({{40, 100}, {1000, 10000, 100000}})
    ->ArgNames({"cubes", "facets"})
    ->Iterations(11)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);

BENCHMARK(unglue_patches)
    ->ArgsProduct({{40, 100}, {1, 1000, 10000, 100000}})
    ->ArgNames({"cubes", "facets"})
    ->Iterations(11)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace cleave::bench
