#pragma once
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "cleave/topology/run_options.hpp"

namespace cleave::topology::detail {

/// The threads that share the work on a whole mesh, and the progress that they report. The work is
/// done in stages, one after the other; what a worker throws ends the stage and comes out of it.
class Crew {
 public:
  /// The calling thread alone, which reports to nobody.
  Crew() = default;
  explicit Crew(const RunOptions& options)
      : size_(std::max(options.threads, 1)), progress_(options.progress) {}

  int size() const { return size_; }

  /// The next stages bring the whole work to the fraction `until`.
  void next_stage(double until) {
    from_ = until_;
    until_ = until;
  }

  /// Tells that this stage is done.
  void end_stage() const { report(1, 1, 1, 1); }

  /// Calls work(worker) on each worker 0 .. size()-1; the calling thread is 0.
  template <class Work>
  void on_each(Work work) {
    std::exception_ptr thrown;
    std::mutex guard;
    const auto run = [&](int worker) {
      try {
        work(worker);
      } catch (...) {
        stop_ = true;
        const std::lock_guard lock(guard);
        if (!thrown) thrown = std::current_exception();
      }
    };
    {
      std::vector<std::jthread> others;
      others.reserve(static_cast<std::size_t>(size_ - 1));
      try {
        for (int worker = 1; worker < size_; ++worker) others.emplace_back(run, worker);
      } catch (...) {  // no further thread can be had
        stop_ = true;
        throw;
      }
      run(0);
    }
    stop_ = false;
    if (thrown) std::rethrow_exception(thrown);
  }

  /// Calls work(worker, begin, end) for consecutive ranges that make up 0 .. count, each on the
  /// worker that is free next. Brings the stage from one fraction to another.
  template <class Work>
  void share(std::size_t count, double from, double to, Work work,
             std::size_t least_step = kLeastStep) {
    const std::size_t step = std::max(least_step, count / kMostReports + 1);
    std::atomic<std::size_t> next = 0;
    on_each([&](int worker) {
      while (!stop_) {
        const std::size_t begin = next.fetch_add(step);
        if (begin >= count) return;
        const std::size_t end = std::min(begin + step, count);
        work(worker, begin, end);
        if (worker == 0) report(from, to, end, count);
      }
    });
  }

  /// The same, but each worker has a block of its own, and the blocks come in the order of workers.
  /// Brings the stage from one fraction to another.
  template <class Work>
  void on_blocks(std::size_t count, double from, double to, Work work) {
    on_each([&](int worker) {
      const auto edge = [&](int n) {
        return count / static_cast<std::size_t>(size_) * static_cast<std::size_t>(n);
      };
      const std::size_t first = edge(worker), last = worker + 1 == size_ ? count : edge(worker + 1);
      const std::size_t step = std::max(kLeastStep, (last - first) / kMostReports + 1);
      for (std::size_t begin = first; begin < last && !stop_; begin += step) {
        const std::size_t end = std::min(begin + step, last);
        work(worker, begin, end);
        if (worker == 0) report(from, to, end - first, last - first);
      }
    });
  }

 private:
  static constexpr std::size_t kLeastStep = 1024, kMostReports = 50;

  /// Tells that `done` of `all` between two fractions of this stage are done. Only on the calling
  /// thread.
  void report(double from, double to, std::size_t done, std::size_t all) const {
    if (!progress_) return;
    const double share = from + (to - from) * static_cast<double>(done) / static_cast<double>(all);
    progress_(from_ + share * (until_ - from_));
  }

  int size_ = 1;
  std::function<void(double)> progress_;
  double from_ = 0, until_ = 0;
  std::atomic<bool> stop_ = false;
};

}  // namespace cleave::topology::detail
