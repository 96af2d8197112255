#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "cleave/topology/ids.hpp"
#include "complex_access.hpp"
#include "hash_bits.hpp"

namespace cleave::topology::detail {

/// Puts two numbers in order and tells whether they were not. Without a branch: which of two
/// vertices comes first is a coin's toss, and a processor that foresees it wrongly half the time
/// loses more than all else here takes. (Compilers turn std::min and std::max back into branches.)
template <class Number>
Number put_in_order(Number& a, Number& b) {
  const Number swap = b < a;
  const Number difference = (a ^ b) & (Number{0} - swap);
  a ^= difference;
  b ^= difference;
  return swap;
}

/// The facets with one least vertex, to be matched with each other: about 24 in a mesh of
/// tetrahedra, which stay in the nearest cache. Nothing here branches on the data but where facets
/// meet in a slot of the hash table.
template <int D>
class FacetBucket {
 public:
  /// Begins with the facets whose least vertex is `least`, of at most `most_cells` cells.
  void begin(VertexId least, std::size_t most_cells) {
    least_ = least.value;
    size_ = 1;
    if (entries_.size() < 1 + D * (most_cells + 1)) entries_.resize(1 + D * (most_cells + 1));
    entries_[0] = {};
  }

  /// Adds the facets of `cell` with the bucket's least vertex: all but one if that is the least
  /// vertex of the cell, one if it is the second least.
  void add(CellId id, const Cell<D>& cell, bool reversed) {
    constexpr int kLocalBits = 3;  // beside a vertex, its place in the tuple
    static_assert(D < 1 << kLocalBits);
    std::array<std::uint64_t, D + 1> v;
    for (std::size_t i = 0; i <= D; ++i)
      v[i] = static_cast<std::uint64_t>(cell[i].value) << kLocalBits | i;
    std::uint64_t odd = reversed ? 1 : 0;
    for (std::size_t end = D; end > 0; --end)
      for (std::size_t i = 0; i < end; ++i) odd ^= put_in_order(v[i], v[i + 1]);

    // The facet opposite place p of the ascending tuple has the orientation odd * (-1)^p. The first
    // facet here is the one without the first two places, but for the bucket's own vertex.
    const std::uint64_t second = (v[1] >> kLocalBits) == least_ ? 1 : 0;
    const std::uint64_t first_apex = v[1] ^ ((v[0] ^ v[1]) & (std::uint64_t{0} - second));
    const auto set = [&](std::size_t p, std::uint64_t apex, std::uint64_t orientation) {
      Entry& entry = entries_[size_ + p - 1];
      entry.apex = (apex >> kLocalBits) << 1 | orientation;
      entry.half_facet = half_facet<D>(id, static_cast<int>(apex & ((1 << kLocalBits) - 1))).value;
      entry.mate = kNone;
      entry.key.fill(0);
      for (std::size_t i = 1, n = 0; i <= D; ++i)
        if (i != p) {
          entry.key[n / kPerWord] =
              entry.key[n / kPerWord] << (64 / kPerWord % 64) | v[i] >> kLocalBits;
          ++n;
        }
    };
    set(1, first_apex, odd ^ 1 ^ second);
    for (std::size_t p = 2; p <= D; ++p) set(p, v[p], odd ^ (p & 1));
    for (std::size_t i = 0; i < D; ++i) faulty_ |= v[i] >> kLocalBits == v[i + 1] >> kLocalBits;
    size_ += D - (D - 1) * static_cast<std::size_t>(second);
  }

  /// Matches the facets and writes their mates, kNone for those that are alone. Whether all is
  /// plain: no vertex twice in a cell, no facet in three cells, no cell twice, mates opposite.
  bool match(std::vector<HalfFacetId>& mates) {
    const int bits = static_cast<int>(std::bit_width(size_)) + 1;
    const std::size_t slots = std::size_t{1} << bits;
    if (slots_.size() < slots) slots_.resize(slots);
    std::fill_n(slots_.begin(), slots, Index{0});
    std::size_t patience = kPatience + size_;  // with facets that meet in a slot
    for (Index n = 1; n < size_; ++n) {
      Entry& entry = entries_[n];
      std::size_t slot = hash(entry.key, bits);
      Index found = slots_[slot];  // 0: nothing, or an entry with the same key
      while (found != 0 && entries_[found].key != entry.key) {
        if (patience-- == 0) return false;
        slot = (slot + 1) & (slots - 1);
        found = slots_[slot];
      }
      Entry& other = entries_[found];
      const std::uint64_t unlike = entry.apex ^ other.apex;
      const bool fits = ((unlike & 1) != 0) & (unlike != 1) & (other.mate == kNone);
      faulty_ |= !fits & (found != 0);
      entry.mate = other.half_facet;  // kNone in entry 0, whose own mate means nothing
      other.mate = entry.half_facet;
      slots_[slot] = found | (n & (Index{0} - static_cast<Index>(found == 0)));
    }
    if (faulty_) return false;
    for (std::size_t n = 1; n < size_; ++n) mates[entries_[n].half_facet].value = entries_[n].mate;
    return true;
  }

 private:
  static constexpr std::size_t kPerWord = sizeof(std::uint64_t) / sizeof(Index);
  static constexpr std::size_t kWords = D == 1 ? 1 : (D - 1 + kPerWord - 1) / kPerWord;
  static constexpr std::size_t kPatience = 64;
  using Key = std::array<std::uint64_t, kWords>;  // the vertices but the least, ascending

  struct Entry {
    Key key;
    std::uint64_t apex = 0;  // the opposite vertex; the last bit is the induced orientation
    Index half_facet = kNone;
    Index mate = kNone;
  };

  static std::size_t hash(const Key& key, int bits) {
    std::uint64_t mixed = key[0];
    for (std::size_t w = 1; w < kWords; ++w) mixed = mixed * 0xD6E8FEB86659FD93u + key[w];
    return hash_bits(mixed, bits);
  }

  std::vector<Entry> entries_;  // the first stands for no entry
  std::vector<Index> slots_;
  std::size_t size_ = 1;
  std::uint64_t least_ = 0;
  bool faulty_ = false;
};

}  // namespace cleave::topology::detail
