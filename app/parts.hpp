#pragma once
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cleave::app {

/// A part that a run built or brought up to date, and what that cost in all.
struct Part {
  std::string name;
  std::size_t times = 0;  // how often it was built or brought up to date
  double seconds = 0.0;
  std::int64_t bytes = 0;  // growth of the heap by it: what it holds, not what it used on the way
};

/// The record of the parts of a run, in the order in which they were first built. A part that is
/// not in it was never constructed.
class Parts {
 public:
  Parts();

  /// Calls `build` and books its cost under `name`; returns what it returns.
  template <class Build>
  auto build(std::string_view name, Build&& build) {
    const Booking booking(*this, name);
    return std::forward<Build>(build)();
  }

  const std::vector<Part>& all() const { return parts_; }

  /// Whether the allocator tells how much it has given out (glibc's does, a sanitizer's does not);
  /// if not, `bytes` means nothing.
  bool bytes_known() const { return bytes_known_; }

 private:
  struct Booking {
    Booking(Parts& parts, std::string_view name);
    ~Booking();
    Booking(const Booking&) = delete;
    Booking& operator=(const Booking&) = delete;
    Parts& parts;
    std::size_t place;
    std::int64_t bytes_before;
    std::chrono::steady_clock::time_point start;
  };

  std::vector<Part> parts_;
  bool bytes_known_;
};

}  // namespace cleave::app
