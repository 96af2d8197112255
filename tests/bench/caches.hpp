#pragma once
#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// What is in the caches when a measurement begins.
namespace cleave::bench {

/// Fills the caches with something else: twice the 32 MiB that the largest one holds.
inline void empty_caches() {
  static std::vector<std::uint64_t> other(64U << 17U);
  for (std::uint64_t& word : other) ++word;
  benchmark::DoNotOptimize(other.data());
  benchmark::ClobberMemory();
}

/// Reads all bytes of the range.
template <class T>
void read(std::span<const T> range) {
  const auto bytes = std::as_bytes(range);
  std::size_t sum = 0;
  for (std::size_t n = 0; n < bytes.size(); n += 64) sum += static_cast<std::size_t>(bytes[n]);
  benchmark::DoNotOptimize(sum);
}

}  // namespace cleave::bench
