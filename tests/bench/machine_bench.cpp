#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <vector>

#include "cleave/support/rng.hpp"
#include "figure.hpp"

/// What the memory of this machine gives, to read every other table against: bytes per second of a
/// stream, nanoseconds of a load at a random place. `MiB` is the size of what is read; vectors as
/// everybody allocates them, so that pages are what the system makes of them.
namespace cleave::bench {
namespace {

std::size_t words(const benchmark::State& state) {
  return static_cast<std::size_t>(state.range(0)) << 17U;
}

void report_bytes(benchmark::State& state, const std::vector<double>& times, std::size_t bytes) {
  state.counters["GB/s"] = 1e-9 * static_cast<double>(bytes) / median(times);
}

void memory_read(benchmark::State& state) {
  const std::vector<std::uint64_t> from(words(state), 1);
  std::vector<double> times;
  for (auto _ : state) {
    times.push_back(seconds([&] {
      benchmark::DoNotOptimize(std::accumulate(from.begin(), from.end(), std::uint64_t{0}));
    }));
    state.SetIterationTime(times.back());
  }
  report_bytes(state, times, 8 * from.size());
}

/// Bytes read and written.
void memory_copy(benchmark::State& state) {
  const std::vector<std::uint64_t> from(words(state), 1);
  std::vector<std::uint64_t> to(from);
  std::vector<double> times;
  for (auto _ : state) {
    times.push_back(seconds([&] {
      std::memcpy(to.data(), from.data(), 8 * from.size());
      benchmark::ClobberMemory();
    }));
    state.SetIterationTime(times.back());
  }
  report_bytes(state, times, 16 * from.size());
}

constexpr std::size_t kLoads = 2'000'000;

/// Places that are known in advance: many loads are under way at once.
void memory_random_load(benchmark::State& state) {
  const std::vector<std::uint64_t> from(words(state), 1);
  std::vector<double> times;
  support::Rng rng(1);
  for (auto _ : state) {
    times.push_back(seconds([&] {
      std::uint64_t sum = 0;
      for (std::size_t n = 0; n < kLoads; ++n) sum += from[rng.next() & (from.size() - 1)];
      benchmark::DoNotOptimize(sum);
    }));
    state.SetIterationTime(times.back());
  }
  state.counters["ns/load"] = 1e9 * median(times) / kLoads;
}

/// Each load tells the place of the next: one at a time.
void memory_dependent_load(benchmark::State& state) {
  std::vector<std::uint64_t> next(words(state));
  support::Rng rng(1);
  std::iota(next.begin(), next.end(), std::uint64_t{0});
  for (std::size_t i = next.size(); i > 1; --i) std::swap(next[i - 1], next[rng.below(i - 1)]);
  std::vector<double> times;  // the exchange above makes one cycle of all places
  for (auto _ : state) {
    times.push_back(seconds([&] {
      std::uint64_t at = 0;
      for (std::size_t n = 0; n < kLoads; ++n) at = next[at];
      benchmark::DoNotOptimize(at);
    }));
    state.SetIterationTime(times.back());
  }
  state.counters["ns/load"] = 1e9 * median(times) / kLoads;
}

void large(benchmark::internal::Benchmark* b) {
  b->Arg(512)->ArgName("MiB")->Iterations(5)->UseManualTime()->Unit(benchmark::kMillisecond);
}

void of_each_cache(benchmark::internal::Benchmark* b) {
  b->Arg(1)->Arg(16)->Arg(512)->ArgName("MiB")->Iterations(5)->UseManualTime()->Unit(
      benchmark::kMillisecond);
}

BENCHMARK(memory_read)->Apply(large);
BENCHMARK(memory_copy)->Apply(large);
BENCHMARK(memory_random_load)->Apply(of_each_cache);
BENCHMARK(memory_dependent_load)->Apply(of_each_cache);

}  // namespace
}  // namespace cleave::bench
