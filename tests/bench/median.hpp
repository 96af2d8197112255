#pragma once
#include <algorithm>
#include <ctime>
#include <vector>

namespace cleave::bench {

/// The processor time that `work` takes on this thread, in seconds: what else runs on the machine
/// counts only as far as it disturbs the caches.
template <class Work>
double seconds(Work work) {
  const auto now = [] {
    std::timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  };
  const double start = now();
  work();
  return now() - start;
}

/// The upper median. Requires at least one value.
inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace cleave::bench
