#include <benchmark/benchmark.h>

#include <stdexcept>
#include <utility>
#include <vector>

#include "bodies.hpp"
#include "cleave/topology/incision.hpp"
#include "figure.hpp"
#include "patches.hpp"

/// Taking back: nanoseconds per facet of a stitch that takes a whole cut back, beside the cut it
/// undoes, both as steps of an incision.
namespace cleave::bench {
namespace {

using namespace topology;  // NOLINT(google-build-using-namespace): it is what is measured

/// Cuts and takes back in flat arrays.
struct FlatIncision {
  FlatIncision(const Body<3>& whole, const FacetSet& facets)
      : flat(whole.flat), original(flat.vertices), cut(numbers(facets.half_facets())) {
    for (const std::uint32_t h : cut) pairs.emplace_back(h, flat.mates[h]);
  }

  double seconds_to_cut() {
    flat.vertices = original;
    return seconds([&] { flat.unglue(cut); });
  }

  /// The vertices that copies copy are told before, as an incision knows them.
  double seconds_to_stitch(const FlatMesh<3>& whole) {
    std::vector<std::uint32_t> parent(flat.vertices - original);
    for (const auto& [one, other] : pairs)
      for (const std::uint32_t h : {one, other})
        for (std::uint32_t corner = h & ~3U; corner < (h & ~3U) + 4; ++corner)
          if (const std::uint32_t v = flat.vertex(corner); v >= original)
            parent[v - original] = whole.cells[corner / 4][corner % 4];
    return seconds([&] { flat.stitch(pairs, parent, original); });
  }

  FlatMesh<3> flat;
  std::uint32_t original;
  std::vector<std::uint32_t> cut;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
};

/// `half`: of taking every second facet back, per facet. `cut`: of the step that is taken back, and
/// `per_cut` the one by the other; all without verification but `verified`.
void stitch_patches(benchmark::State& state) {
  const Body<3>& whole = body<3>(static_cast<int>(state.range(0)));
  const auto count = static_cast<std::size_t>(state.range(1));
  const FacetSet cut = patches(whole, count);
  std::vector<HalfFacetId> every_second;
  for (std::size_t n = 0; n < cut.size(); n += 2) every_second.push_back(cut.half_facets()[n]);
  const FacetSet half = FacetSet::of_lesser(every_second);
  Incision<3> incision(whole.complex);
  FlatIncision flat(whole, cut);
  Turns cuts, stitches, verified;
  std::vector<double> halves;
  std::size_t merges = 0;
  for (auto _ : state) {
    cuts.ours.push_back(seconds([&] { incision.cut(cut, Verify::none); }));
    stitches.ours.push_back(
        seconds([&] { merges = incision.stitch(cut, Verify::none).merges.size(); }));
    cuts.flat.push_back(flat.seconds_to_cut());
    stitches.flat.push_back(flat.seconds_to_stitch(whole.flat));
    incision.cut(cut, Verify::none);
    verified.ours.push_back(seconds([&] { incision.stitch(cut); }));
    incision.cut(cut, Verify::none);
    halves.push_back(seconds([&] { incision.stitch(half, Verify::none); }));
    incision.stitch(cut, Verify::none);
    incision.forget_steps();
    state.SetIterationTime(stitches.ours.back());
  }
  if (flat.flat.cells != whole.flat.cells || flat.flat.mates != whole.flat.mates)
    throw std::logic_error("the yardstick does not come back");
  const auto facets = static_cast<double>(count);
  report_ns(state, "ns/facet", stitches, facets);
  report_ns(state, "cut", cuts, facets, "cut_");
  state.counters["per_cut"] = Turns{stitches.ours, cuts.ours}.ratio();
  state.counters["verified"] = 1e9 * median(verified.ours) / facets;
  state.counters["half"] = 1e9 * median(halves) / static_cast<double>(half.size());
  state.counters["merges"] = static_cast<double>(merges);
}

BENCHMARK(stitch_patches)
    ->ArgsProduct({{40, 100}, {1000, 10000, 100000}})
    ->ArgNames({"cubes", "facets"})
    ->Iterations(11)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace cleave::bench
