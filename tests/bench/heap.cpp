#include "heap.hpp"

#include <malloc.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::size_t> held{0}, peak{0};

}  // namespace

void* operator new(std::size_t size) {
  void* block = std::malloc(std::max<std::size_t>(size, 1));
  if (block == nullptr) throw std::bad_alloc();
  const std::size_t now = held += malloc_usable_size(block);
  if (now > peak) peak = now;
  return block;
}

void operator delete(void* block) noexcept {
  held -= malloc_usable_size(block);  // 0 for a null pointer
  std::free(block);
}

void operator delete(void* block, std::size_t) noexcept { operator delete(block); }

namespace cleave::bench {

std::size_t heap_bytes() { return held; }
std::size_t heap_peak() { return peak; }
void forget_heap_peak() { peak = held.load(); }

}  // namespace cleave::bench
