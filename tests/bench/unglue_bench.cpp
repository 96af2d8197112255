#include <benchmark/benchmark.h>

#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

#include "bodies.hpp"
#include "caches.hpp"
#include "cleave/topology/unglue.hpp"
#include "figure.hpp"
#include "patches.hpp"

/// Cutting: nanoseconds per facet of the cut.
namespace cleave::bench {
namespace {

using namespace topology;  // NOLINT(google-build-using-namespace): it is what is measured

enum class Caches { warm, cold };

/// Brings what the cut will look at into the caches, as far as it fits, or all of it out of them.
void prepare(Caches caches, const Complex<3>& k, const FacetSet& cut) {
  if (caches == Caches::cold) return empty_caches();
  for (const HalfFacetId h : cut.half_facets())
    for (const VertexId v : k.facet(h)) benchmark::DoNotOptimize(star(k, v));
}

void prepare(Caches caches, FlatMesh<3>& flat, const std::vector<std::uint32_t>& cut) {
  if (caches == Caches::cold) return empty_caches();
  std::vector<std::uint32_t> part;
  for (const std::uint32_t h : cut)
    for (std::uint32_t corner = h & ~3U; corner < (h & ~3U) + 4; ++corner) {
      if (corner == h) continue;
      const std::uint32_t v = flat.vertex(corner);
      flat.flood(corner, v, flat.vertices, part);  // there and back: nothing has changed
      flat.flood(corner, flat.vertices, v, part);
    }
}

/// `verified`: with Verify::touched, the default. `growth`: beside the smallest body that the same
/// cut was measured on in this run.
void unglue_patches(benchmark::State& state) {
  const Body<3>& whole = body<3>(static_cast<int>(state.range(0)));
  const auto count = static_cast<std::size_t>(state.range(1));
  const Caches caches = state.range(2) == 0 ? Caches::warm : Caches::cold;
  const FacetSet cut = patches(whole, count);
  const auto flat_cut = numbers(cut.half_facets());
  Turns turns, verified;
  Relabelling change;
  Complex<3> k;
  FlatMesh<3> flat;
  for (auto _ : state) {
    k = whole.complex;
    prepare(caches, k, cut);
    turns.ours.push_back(seconds([&] { change = unglue(k, cut, Verify::none); }));
    flat = whole.flat;
    prepare(caches, flat, flat_cut);
    std::uint32_t added = 0;
    turns.flat.push_back(seconds([&] { added = flat.unglue(flat_cut); }));
    if (added != change.splits.size()) throw std::logic_error("the yardstick disagrees");
    k = whole.complex;
    prepare(caches, k, cut);
    verified.ours.push_back(seconds([&] { change = unglue(k, cut); }));
    state.SetIterationTime(turns.ours.back());
  }
  verified.flat = turns.flat;
  report_ns(state, "ns/facet", turns, static_cast<double>(count));
  state.counters["verified"] = 1e9 * median(verified.ours) / static_cast<double>(count);
  state.counters["verified_ratio"] = verified.ratio();
  state.counters["copies"] = static_cast<double>(change.splits.size());

  static std::map<std::pair<std::size_t, Caches>, double> on_smallest_body;
  const double time = median(turns.ours);
  const double least = on_smallest_body.try_emplace({count, caches}, time).first->second;
  state.counters["growth"] = time / least;
}

/// One facet, given as a half-facet, another one each time, somewhere in the body.
void unglue_one_facet(benchmark::State& state) {
  const Body<3>& whole = body<3>(static_cast<int>(state.range(0)));
  Complex<3> k = whole.complex;
  FlatMesh<3> flat = whole.flat;
  support::Rng rng(2);
  const auto interior = [&] {
    HalfFacetId h{};
    do h = {static_cast<Index>(rng.below(k.half_facet_count()))};
    while (!k.is_interior(h) || flat.mates[h.value] == FlatMesh<3>::kNone);
    return std::vector{h};
  };
  Turns turns, verified;
  for (auto _ : state) {
    auto one = interior();
    turns.ours.push_back(seconds([&] { unglue(k, FacetSet::of(k, one), Verify::none); }));
    one = interior();
    verified.ours.push_back(seconds([&] { unglue(k, FacetSet::of(k, one)); }));
    const auto number = numbers(interior());
    turns.flat.push_back(seconds([&] { flat.unglue(number); }));
    state.SetIterationTime(turns.ours.back());
  }
  // Not ratio(): the facets of a turn are different ones.
  state.counters["ns/facet"] = 1e9 * median(turns.ours);
  state.counters["verified"] = 1e9 * median(verified.ours);
  state.counters["flat"] = 1e9 * median(turns.flat);
  state.counters["ratio"] = median(turns.ours) / median(turns.flat);
}

void cuts(benchmark::internal::Benchmark* b) {
  for (const int cubes : {40, 100, 159})
    for (const int facets : {1, 1000, 10000, 100000, 600000})
      for (const int cold : {0, 1})
        if (cubes > 40 || facets < 600000) b->Args({cubes, facets, cold});
}

BENCHMARK(unglue_one_facet)
    ->Arg(40)
    ->Arg(100)
    ->Arg(159)
    ->ArgName("cubes")
    ->Iterations(1001)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);

BENCHMARK(unglue_patches)
    ->Apply(cuts)
    ->ArgNames({"cubes", "facets", "cold"})
    ->Iterations(5)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace cleave::bench
