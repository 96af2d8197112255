#pragma once
#include <cstddef>

/// What `new` hands out in this program. Linking cleave_test_heap replaces it.
namespace cleave::support {

/// Bytes held now.
std::size_t heap_bytes();

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

}  // namespace cleave::support
