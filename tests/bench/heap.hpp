#pragma once
#include <cstddef>

/// What `new` has handed out in this program: linking heap.cpp counts it.
namespace cleave::bench {

/// Bytes held now.
std::size_t heap_bytes();

/// The most bytes held since the last call of forget_heap_peak.
std::size_t heap_peak();
void forget_heap_peak();

}  // namespace cleave::bench
