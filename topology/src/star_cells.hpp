#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

#include "cleave/topology/ids.hpp"
#include "hash_bits.hpp"

namespace cleave::topology::detail {

/// The corners of one star, found by their cells: a hash table with open addressing, at most half
/// full, of a quarter of a kilobyte for most stars.
template <int D>
class StarCells {
 public:
  explicit StarCells(std::vector<Index>& slots) : slots_(slots) {}

  /// Forgets the star before. Keeps the memory.
  void begin() {
    if (slots_.size() < kLeast) slots_.resize(kLeast);
    bits_ = kLeastBits;
    std::fill_n(slots_.data(), kLeast, kNoIndex);
  }

  /// The corner of `cell` in the star; or kNoIndex, in the place where the corner belongs. Good
  /// until the next one is added.
  Index& at(CellId cell) {
    Index* const slots = slots_.data();
    const Index first = half_facet<D>(cell, 0).value;
    std::size_t slot = hash_bits(cell.value, bits_);
    while (slots[slot] - first > static_cast<Index>(D) && slots[slot] != kNoIndex)
      slot = (slot + 1) & (used_slots() - 1);
    return slots[slot];
  }

  /// `place` is what `at` gave for the cell of `corner`, which is the last of the star.
  template <class Star>
  void add(Index& place, CornerId corner, const Star& star) {
    place = corner.value;
    if (2 * star.size() > used_slots()) grow(star);
  }

 private:
  static constexpr int kLeastBits = 6;
  static constexpr std::size_t kLeast = std::size_t{1} << kLeastBits;

  std::size_t used_slots() const { return std::size_t{1} << bits_; }

  template <class Star>
  [[gnu::noinline]] void grow(const Star& star) {
    ++bits_;
    if (slots_.size() < used_slots()) slots_.resize(used_slots());
    std::fill_n(slots_.data(), used_slots(), kNoIndex);
    for (const auto& there : star) at(cell_of<D>(there.corner)) = there.corner.value;
  }

  std::vector<Index>& slots_;
  int bits_ = kLeastBits;  // of the slots in use
};

}  // namespace cleave::topology::detail
