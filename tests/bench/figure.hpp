#pragma once
#include <benchmark/benchmark.h>

#include <cstddef>
#include <string>
#include <vector>

#include "median.hpp"

/// How every benchmark here reports. A counter named `ratio`, or ending in `_ratio`, is a time of
/// ours divided by one of the yardstick, run in turn in the same run (1: as fast, 2: takes twice as
/// long); one ending in `B/cell` is memory. Those two do not depend on how busy the machine is, and
/// `./dev bench --compare` compares them with tests/bench/baseline.json.
namespace cleave::bench {

/// Times of the same work, measured in turn: ours and the yardstick's, in seconds.
struct Turns {
  std::vector<double> ours, flat;

  /// The median over the turns, so that a slow moment of the machine, which slows both, does not
  /// count.
  double ratio() const {
    std::vector<double> ratios;
    for (std::size_t n = 0; n < ours.size(); ++n) ratios.push_back(ours[n] / flat[n]);
    return median(ratios);
  }
};

/// Sets `name` to the time of ours per item, in nanoseconds, `flat` to the yardstick's, and
/// `ratio`; the latter two after a `prefix`.
inline void report_ns(benchmark::State& state, const std::string& name, const Turns& turns,
                      double items, const std::string& prefix = "") {
  state.counters[name] = 1e9 * median(turns.ours) / items;
  state.counters[prefix + "flat"] = 1e9 * median(turns.flat) / items;
  state.counters[prefix + "ratio"] = turns.ratio();
}

/// The same as a speed, in millions of items per second.
inline void report_millions(benchmark::State& state, const std::string& name, const Turns& turns,
                            double items) {
  state.counters[name] = 1e-6 * items / median(turns.ours);
  state.counters["flat"] = 1e-6 * items / median(turns.flat);
  state.counters["ratio"] = turns.ratio();
}

}  // namespace cleave::bench
