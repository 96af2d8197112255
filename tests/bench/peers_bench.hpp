#pragma once
#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <vector>

#include "median.hpp"

namespace cleave::bench {

/// The library's and the peers' benchmarks are one per mesh: all programs do the work in turns.
void register_peer_assembly();
void register_peer_cuts();

/// Seconds that each program took, `ours` and `flat`, the yardstick, among them.
using TimesOf = std::map<std::string, std::vector<double>>;

/// Sets NAME to what `value` makes of the program's median time, NAME_x to how many times as long
/// as the library it took: above 1 the library is faster. `ratio` is ours by the yardstick's, as in
/// all benchmarks here.
template <class Value>
void report(benchmark::State& state, const TimesOf& times, Value value) {
  const double ours = median(times.at("ours"));
  for (const auto& [name, all] : times) {
    state.counters[name] = value(median(all));
    if (name == "flat")
      state.counters["ratio"] = ours / median(all);
    else if (name != "ours")
      state.counters[name + "_x"] = median(all) / ours;
  }
}

}  // namespace cleave::bench
