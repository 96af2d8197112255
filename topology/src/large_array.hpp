#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>
#ifdef __linux__
#include <sys/mman.h>
#endif

namespace cleave::topology::detail {

/// Asks for large pages behind memory that nobody has written to yet; where there are none, nothing
/// happens. A page of 2 MiB comes with one fault instead of 512, and random accesses to it need one
/// entry of the processor's table of pages.
inline void ask_for_large_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  constexpr std::size_t kPage = std::size_t{1} << 21;
  const std::size_t before = (kPage - reinterpret_cast<std::uintptr_t>(memory) % kPage) % kPage;
  if (bytes < before + kPage) return;
  madvise(static_cast<char*>(memory) + before, (bytes - before) / kPage * kPage, MADV_HUGEPAGE);
#endif
}

/// `size` values, of the kind that a T without arguments has, on large pages if there are any.
template <class T>
std::vector<T> large_array(std::size_t size) {
  std::vector<T> values;
  values.reserve(size);
  ask_for_large_pages(values.data(), size * sizeof(T));
  values.resize(size);
  return values;
}

}  // namespace cleave::topology::detail
