#pragma once
#include <cstddef>
#include <new>

/// What `new` hands out in this program. Linking cleave_test_heap replaces it.
namespace cleave::support {

/// Bytes held now.
std::size_t heap_bytes();

/// How often `new` has been called.
std::size_t allocations();

/// The most bytes held since the last call of forget_heap_peak.
std::size_t heap_peak();
void forget_heap_peak();

/// Lets `allocations` more calls of `new` succeed; every later one throws std::bad_alloc, until
/// this ends. One at a time.
class MemoryLimit {
 public:
  explicit MemoryLimit(std::size_t allocations);
  ~MemoryLimit();
  MemoryLimit(const MemoryLimit&) = delete;
  MemoryLimit& operator=(const MemoryLimit&) = delete;
};

/// Repeats `action` with memory for 0, 1, 2, .. allocations until that is enough; returns how many
/// that are. Calls `after_failure` whenever it was not, with memory again.
template <class Action, class AfterFailure>
std::size_t run_out_of_memory(Action action, AfterFailure after_failure) {
  for (std::size_t allocations = 0;; ++allocations) {
    try {
      const MemoryLimit limit(allocations);
      action();
      return allocations;
    } catch (const std::bad_alloc&) {
    }
    after_failure();
  }
}

}  // namespace cleave::support
