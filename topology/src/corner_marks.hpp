#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "cleave/topology/ids.hpp"
#include "hash_bits.hpp"

namespace cleave::topology::detail {

/// Corners that walks around many neighbouring vertices have come past: 256 corners of neighbouring
/// cells share a slot of a hash table with open addressing, at most half full. For a single star,
/// whose corners share few slots, CornerSet is smaller.
class CornerMarks {
 public:
  /// Whether `corner` was not in the set; it is afterwards.
  bool insert(CornerId corner) {
    Slot& slot = slots_[slot_of(corner.value / kBlock)];
    std::uint64_t& word = slot.corners[corner.value % kBlock / 64];
    const std::uint64_t bit = std::uint64_t{1} << corner.value % 64;
    if ((word & bit) != 0) return false;
    word |= bit;
    if (slot.block == kFree) {
      slot.block = corner.value / kBlock;
      if (2 * ++used_ > used_slots()) grow();
    }
    return true;
  }

  bool contains(CornerId corner) const {
    const Slot& slot = slots_[slot_of(corner.value / kBlock)];  // a free one holds no bits
    return (slot.corners[corner.value % kBlock / 64] >> corner.value % 64 & 1u) != 0;
  }

  /// Keeps the memory. Time: linear in what was marked since the last time.
  void clear() {
    std::fill_n(slots_.begin(), used_slots(), Slot{});
    bits_ = kLeastBits;
    used_ = 0;
  }

 private:
  static constexpr Index kBlock = 256;
  static constexpr int kLeastBits = 5;
  static constexpr Index kFree = kNoIndex;

  struct Slot {
    Index block = kFree;
    std::array<std::uint64_t, kBlock / 64> corners{};  // a bit for each
  };

  /// Where `block` is, or the free slot where it belongs.
  std::size_t slot_of(Index block) const {
    std::size_t slot = hash_bits(block, bits_);
    while (slots_[slot].block != block && slots_[slot].block != kFree)
      slot = (slot + 1) & (used_slots() - 1);
    return slot;
  }
  void grow() {
    const std::size_t before = used_slots();
    if (spare_.size() < 2 * before) spare_.resize(2 * before);
    std::fill_n(spare_.begin(), 2 * before, Slot{});
    slots_.swap(spare_);
    ++bits_;
    for (std::size_t n = 0; n < before; ++n)
      if (spare_[n].block != kFree) slots_[slot_of(spare_[n].block)] = spare_[n];
  }
  std::size_t used_slots() const { return std::size_t{1} << bits_; }

  std::vector<Slot> slots_ = std::vector<Slot>(std::size_t{1} << kLeastBits);
  std::vector<Slot> spare_;  // the table before it grew
  int bits_ = kLeastBits;    // of the slots in use
  std::size_t used_ = 0;
};

}  // namespace cleave::topology::detail
