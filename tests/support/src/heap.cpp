#include "cleave/support/heap.hpp"

#include <malloc.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <new>

namespace {

constexpr std::size_t kNoLimit = SIZE_MAX;

std::atomic<std::size_t> held{0}, peak{0}, calls{0}, allowed{kNoLimit};

bool is_allowed() {
  if (allowed == kNoLimit) return true;
  if (allowed == 0) return false;
  --allowed;
  return true;
}

}  // namespace

void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++calls;
  void* block = is_allowed() ? std::malloc(std::max<std::size_t>(size, 1)) : nullptr;
  const std::size_t now = held += malloc_usable_size(block);  // 0 for a null pointer
  if (now > peak) peak = now;
  return block;
}

void* operator new(std::size_t size) {
  void* block = operator new(size, std::nothrow);
  if (block == nullptr) throw std::bad_alloc();
  return block;
}

void operator delete(void* block) noexcept {
  held -= malloc_usable_size(block);
  std::free(block);
}

void operator delete(void* block, std::size_t) noexcept { operator delete(block); }

// Sanitizers bring arrays of their own, which would not be counted.
void* operator new[](std::size_t size) { return operator new(size); }
void operator delete[](void* block) noexcept { operator delete(block); }
void operator delete[](void* block, std::size_t) noexcept { operator delete(block); }

namespace cleave::support {

std::size_t heap_bytes() { return held; }
std::size_t allocations() { return calls; }
std::size_t heap_peak() { return peak; }
void forget_heap_peak() { peak = held.load(); }

MemoryLimit::MemoryLimit(std::size_t allocations) { allowed = allocations; }
MemoryLimit::~MemoryLimit() { allowed = kNoLimit; }

}  // namespace cleave::support
