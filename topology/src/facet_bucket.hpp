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

/// A vertex and its place in the tuple of a cell, in one number that is ordered by the vertex.
using PlacedVertex = std::int64_t;
inline constexpr int kPlaceBits = 3;
inline PlacedVertex placed(VertexId vertex, std::size_t place) {
  return static_cast<PlacedVertex>(std::uint64_t{vertex.value} << kPlaceBits | place);
}
inline Index vertex_of(PlacedVertex v) { return static_cast<Index>(v >> kPlaceBits); }
inline Index place_of(PlacedVertex v) { return static_cast<Index>(v & ((1 << kPlaceBits) - 1)); }

/// Puts two vertices in order; all ones if they were not, else 0. Without a branch: which of two
/// comes first is the toss of a coin, and a processor that foresees half of them wrongly loses more
/// than all else here takes. (Compilers make branches of std::min and std::max.)
inline PlacedVertex put_in_order(PlacedVertex& a, PlacedVertex& b) {
  const PlacedVertex difference = b - a, swap = difference >> 63;
  a += difference & swap;
  b -= difference & swap;
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

  /// Adds the facets of a cell with the bucket's least vertex, which is at `corner`: all but one if
  /// it is the least vertex of the cell, one if it is the second least.
  void add(CornerId corner, const Cell<D>& cell, bool reversed) {
    static_assert(D < 1 << kPlaceBits);
    const auto place = static_cast<std::size_t>(local_index<D>(corner));
    std::array<PlacedVertex, D + 1> v;
    for (std::size_t i = 0; i <= D; ++i) v[i] = placed(cell[i], i);
    v[place] = v[0];  // v[1] .. v[D]: the other vertices; with ours before them one swap away
    PlacedVertex odd = -static_cast<PlacedVertex>(reversed != (place != 0));
    for (std::size_t end = D; end > 1; --end)
      for (std::size_t i = 1; i < end; ++i) odd ^= put_in_order(v[i], v[i + 1]);
    for (std::size_t i = 1; i < D; ++i) least_difference_ |= (v[i] ^ v[i + 1]) - (1 << kPlaceBits);

    // Our vertex and the others but v[p], ascending, are the facet opposite v[p]; its induced
    // orientation is odd * (-1)^p. If ours is the second least, only the first of them is here.
    const Index first = corner.value - static_cast<Index>(place);
    Entry* const entries = &entries_[size_] - 1;
    for (std::size_t p = 1; p <= D; ++p) {
      const auto orientation = static_cast<std::uint64_t>(p % 2 == 0 ? odd : ~odd) & kOrientation;
      Entry& entry = entries[p];
      entry.apex = static_cast<std::uint64_t>(v[p]) | orientation;
      entry.half_facet = first + place_of(v[p]);
      entry.mate = kNone;
      entry.key = {};
      for (std::size_t i = 1, n = 0; i <= D; ++i)
        if (i != p) {
          std::uint64_t& word = entry.key[n++ / kPerWord];
          word = word << (64 / kPerWord % 64) | vertex_of(v[i]);
        }
    }
    size_ += 1 + (D - 1) * static_cast<std::size_t>(vertex_of(v[1]) > least_);
  }

  /// Matches the facets and writes their mates, kNone for those that are alone. Whether all is
  /// plain: no vertex twice in a cell, no facet in three cells, no cell twice, mates opposite.
  bool match(std::vector<HalfFacetId>& mates) {
    const int bits = static_cast<int>(std::bit_width(size_)) + 1;
    const std::size_t mask = (std::size_t{1} << bits) - 1;
    if (slots_.size() <= mask) slots_.resize(mask + 1);
    Index* const slots = slots_.data();
    std::fill_n(slots, mask + 1, Index{0});
    Entry* const entries = entries_.data();
    const auto size = static_cast<Index>(size_);
    bool faulty = least_difference_ < 0;
    std::size_t patience = kPatience + size;  // with facets that meet in a slot
    for (Index n = 1; n < size; ++n) {
      Entry& entry = entries[n];
      std::size_t slot = hash(entry.key, bits);
      Index found = slots[slot];  // 0: nothing, or an entry with the same key
      while (found != 0 && !same(entries[found].key, entry.key)) {
        if (patience-- == 0) return match_sorted(mates);
        slot = (slot + 1) & mask;
        found = slots[slot];
      }
      Entry& other = entries[found];
      faulty |= (found != 0) & (!fit(entry, other) | (other.mate != kNone));
      entry.mate = other.half_facet;  // kNone in entry 0, whose own mate means nothing
      other.mate = entry.half_facet;
      slots[slot] = found | (n & (Index{0} - static_cast<Index>(found == 0)));
    }
    if (faulty) return false;
    HalfFacetId* const to = mates.data();
    for (Index n = 1; n < size; ++n) to[entries[n].half_facet].value = entries[n].mate;
    return true;
  }

 private:
  /// The same by sorting, where many facets meet in the hash table: around an edge with thousands
  /// of cells whose vertices are numbered in steps.
  bool match_sorted(std::vector<HalfFacetId>& mates) {
    const auto begin = entries_.begin() + 1;
    const auto end = entries_.begin() + static_cast<std::ptrdiff_t>(size_);
    std::sort(begin, end, [](const Entry& a, const Entry& b) {
      return a.key != b.key ? a.key < b.key : a.half_facet < b.half_facet;
    });
    if (least_difference_ < 0) return false;
    for (auto first = begin; first != end;) {
      auto last = first + 1;
      while (last != end && last->key == first->key) ++last;
      if (last - first > 2 || (last - first == 2 && !fit(*first, *(first + 1)))) return false;
      mates[first->half_facet].value = last - first == 2 ? (first + 1)->half_facet : kNone;
      if (last - first == 2) mates[(first + 1)->half_facet].value = first->half_facet;
      first = last;
    }
    return true;
  }

  static constexpr std::size_t kPerWord = sizeof(std::uint64_t) / sizeof(Index);
  static constexpr std::size_t kWords = D == 1 ? 1 : (D - 1 + kPerWord - 1) / kPerWord;
  static constexpr std::size_t kPatience = 64;
  static constexpr std::uint64_t kOrientation = std::uint64_t{1} << 63;
  using Key = std::array<std::uint64_t, kWords>;  // the vertices but the least, ascending

  struct Entry {
    Key key;
    std::uint64_t apex = 0;  // a PlacedVertex; the first bit is the induced orientation
    Index half_facet = kNone;
    Index mate = kNone;
  };

  /// Whether the facets have opposite orientations and different vertices opposite them.
  static bool fit(const Entry& one, const Entry& other) {
    return (one.apex ^ other.apex) >= kOrientation + (1 << kPlaceBits);
  }

  static bool same(const Key& one, const Key& other) {  // operator== may call memcmp
    std::uint64_t unlike = 0;
    for (std::size_t w = 0; w < kWords; ++w) unlike |= one[w] ^ other[w];
    return unlike == 0;
  }

  static std::size_t hash(const Key& key, int bits) {
    std::uint64_t mixed = key[0];
    for (std::size_t w = 1; w < kWords; ++w) mixed = mixed * 0xD6E8FEB86659FD93u + key[w];
    return hash_bits(mixed, bits);
  }

  std::vector<Entry> entries_;  // the first stands for no entry
  std::vector<Index> slots_;
  std::size_t size_ = 1;
  Index least_ = 0;
  PlacedVertex least_difference_ = 0;  // negative: a cell repeats a vertex
};

}  // namespace cleave::topology::detail
