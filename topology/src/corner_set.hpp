#pragma once
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "cleave/topology/ids.hpp"
#include "hash_bits.hpp"

namespace cleave::topology::detail {

/// The corners that a walk around vertices has seen: 32 corners of neighbouring cells share a slot
/// of a hash table with open addressing, at most half full.
class CornerSet {
 public:
  /// Whether `corner` was not in the set; it is afterwards.
  bool insert(CornerId corner) {
    Slot& slot = slots_[slot_of(block(corner))];
    if ((slot.corners & bit(corner)) != 0) return false;
    slot.corners |= bit(corner);
    if (slot.block == kFree) {
      slot.block = block(corner);
      if (2 * ++used_ > slots_.size()) grow();
    }
    return true;
  }

  /// Time: constant, however many corners there were.
  void clear() {
    slots_.assign(kLeast, Slot{});
    bits_ = kLeastBits;
    used_ = 0;
  }

 private:
  static constexpr int kLeastBits = 6;
  static constexpr std::size_t kLeast = std::size_t{1} << kLeastBits;  // holds most stars
  static constexpr Index kFree = kNoIndex;

  struct Slot {
    Index block = kFree;
    std::uint32_t corners = 0;  // a bit for each corner of the block
  };

  static Index block(CornerId corner) { return corner.value / 32; }
  static std::uint32_t bit(CornerId corner) { return 1u << corner.value % 32; }

  /// Where `block` is, or the free slot where it belongs.
  std::size_t slot_of(Index block) const {
    std::size_t slot = hash_bits(block, bits_);
    while (slots_[slot].block != block && slots_[slot].block != kFree)
      slot = (slot + 1) & (slots_.size() - 1);
    return slot;
  }
  void grow() {
    const std::vector<Slot> before = std::exchange(slots_, std::vector<Slot>(2 * slots_.size()));
    ++bits_;
    for (const Slot& slot : before)
      if (slot.block != kFree) slots_[slot_of(slot.block)] = slot;
  }

  std::vector<Slot> slots_ = std::vector<Slot>(kLeast);
  int bits_ = kLeastBits;
  std::size_t used_ = 0;
};

}  // namespace cleave::topology::detail
