#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "cleave/topology/violation.hpp"
#include "complex_access.hpp"

namespace cleave::topology::detail {

/// Who shares a facet with whom.
struct FacetMatching {
  std::vector<HalfFacetId> mates;  // kNone: boundary, or in a crowded facet
  std::vector<std::vector<HalfFacetId>>
      crowded;  // half-facets of each facet in three cells or more
  std::vector<std::pair<CellId, CellId>> duplicates;  // cells with the same vertices
};

/// The vertices of half-facet `h` without its least one, which the bucket knows, ascending.
template <int D>
std::array<VertexId, static_cast<std::size_t>(D) - 1> facet_key(std::span<const Cell<D>> cells,
                                                                HalfFacetId h) {
  Facet<D> facet{};
  const Cell<D>& cell = cells[cell_of<D>(h).value];
  for (std::size_t from = 0, to = 0; from < cell.size(); ++from)
    if (static_cast<int>(from) != local_index<D>(h)) facet[to++] = cell[from];
  for (std::size_t end = facet.size();
       end-- > 1;)  // a network without branches: the order is random
    for (std::size_t i = 0; i < end; ++i) {
      const VertexId low = std::min(facet[i], facet[i + 1]);
      facet[i + 1] = std::max(facet[i], facet[i + 1]);
      facet[i] = low;
    }
  std::array<VertexId, static_cast<std::size_t>(D) - 1> key{};
  std::copy(facet.begin() + 1, facet.end(), key.begin());
  return key;
}

/// Calls visit(h, the least vertex of h) for all half-facets, ascending.
template <int D, class Visit>
void for_each_least_vertex(std::span<const Cell<D>> cells, Visit visit) {
  Index h = 0;
  for (const Cell<D>& cell : cells) {
    VertexId least = std::min(cell[0], cell[1]), second = std::max(cell[0], cell[1]);
    for (std::size_t i = 2; i < cell.size(); ++i) {
      second = std::min(second, std::max(least, cell[i]));
      least = std::min(least, cell[i]);
    }
    for (const VertexId apex : cell) visit(HalfFacetId{h++}, apex == least ? second : least);
  }
}

/// Matches half-facets with the same vertices. Requires sound cells: D+1 distinct vertices below
/// vertex_count. A counting sort by least vertex puts the half-facets of a facet into one bucket;
/// a bucket is searched by the other vertices. Time: linear, and n log n in a large bucket; memory:
/// 4 bytes per half-facet and per vertex.
template <int D>
FacetMatching match_facets(std::span<const Cell<D>> cells, std::size_t vertex_count) {
  const auto half_facets = static_cast<Index>(cells.size() * (D + 1));
  std::vector<Index> bucket_end(vertex_count + 1, 0);  // start until filled, then end
  for_each_least_vertex<D>(cells, [&](HalfFacetId, VertexId v) { ++bucket_end[v.value + 1]; });
  for (std::size_t v = 0; v < vertex_count; ++v) bucket_end[v + 1] += bucket_end[v];
  std::vector<HalfFacetId> sorted(half_facets);
  for_each_least_vertex<D>(cells,
                           [&](HalfFacetId h, VertexId v) { sorted[bucket_end[v.value]++] = h; });

  FacetMatching result;
  result.mates.assign(half_facets, HalfFacetId{kNone});
  struct Entry {
    std::array<VertexId, static_cast<std::size_t>(D) - 1> key;
    HalfFacetId half_facet;
    bool operator<(const Entry& other) const {
      return key != other.key ? key < other.key : half_facet < other.half_facet;
    }
  };
  const auto apex = [&](HalfFacetId h) {
    return cells[cell_of<D>(h).value][static_cast<std::size_t>(local_index<D>(h))];
  };
  // Same facet and same opposite vertex: same cell. Told once, at the greatest vertex.
  const auto is_duplicate = [&](HalfFacetId one, HalfFacetId other) {
    const Cell<D>& cell = cells[cell_of<D>(one).value];
    return apex(one) == apex(other) && apex(one) == *std::max_element(cell.begin(), cell.end());
  };
  /// Each later cell with the first one that it repeats.
  const auto tell_duplicates = [&](const std::vector<HalfFacetId>& crowd) {
    std::vector<std::pair<VertexId, HalfFacetId>> by_apex;
    for (const HalfFacetId h : crowd) by_apex.emplace_back(apex(h), h);
    std::sort(by_apex.begin(), by_apex.end());
    auto first = by_apex.begin();
    for (auto other = first + 1; other != by_apex.end(); ++other)
      if (is_duplicate(first->second, other->second))
        result.duplicates.emplace_back(cell_of<D>(first->second), cell_of<D>(other->second));
      else if (first->first != other->first)
        first = other;
  };
  // Nearly all buckets are small and hold facets of one cell or two: those are compared pair by
  // pair, which needs no branch that is hard to foresee. If there is more to a bucket, nothing is
  // matched.
  const auto match_plain = [&](const std::vector<Entry>& bucket) {
    constexpr std::size_t kSmall = 64;
    if (bucket.size() > kSmall) return false;
    bool plain = true;
    for (auto one = bucket.begin(); one != bucket.end(); ++one)
      for (auto other = one + 1; other != bucket.end(); ++other) {
        if (one->key != other->key) continue;
        HalfFacetId& mate = result.mates[one->half_facet.value];
        plain = plain && mate.value == kNone && !is_duplicate(one->half_facet, other->half_facet);
        mate = other->half_facet;
        result.mates[other->half_facet.value] = one->half_facet;
      }
    if (!plain)
      for (const Entry& entry : bucket) result.mates[entry.half_facet.value] = HalfFacetId{kNone};
    return plain;
  };
  std::vector<Entry> bucket;
  std::size_t begin = 0;
  for (std::size_t v = 0; v < vertex_count; ++v) {
    const std::size_t end = bucket_end[v];
    bucket.clear();
    for (std::size_t n = begin; n < end; ++n)
      bucket.push_back({facet_key<D>(cells, sorted[n]), sorted[n]});
    begin = end;
    if (match_plain(bucket)) continue;
    std::sort(bucket.begin(), bucket.end());
    for (auto first = bucket.begin(); first != bucket.end();) {
      auto last = first + 1;
      while (last != bucket.end() && last->key == first->key) ++last;
      if (last - first == 2) {
        const HalfFacetId one = first->half_facet, other = (first + 1)->half_facet;
        result.mates[one.value] = other;
        result.mates[other.value] = one;
        if (is_duplicate(one, other))
          result.duplicates.emplace_back(cell_of<D>(one), cell_of<D>(other));
      } else if (last - first > 2) {
        auto& crowd = result.crowded.emplace_back();
        for (auto entry = first; entry != last; ++entry) crowd.push_back(entry->half_facet);
        tell_duplicates(crowd);
      }
      first = last;
    }
  }
  std::sort(result.crowded.begin(), result.crowded.end());
  std::sort(result.duplicates.begin(), result.duplicates.end());
  return result;
}

/// Whether mates h and m induce opposite orientations on their facet when both their cells have the
/// orientation of their tuples.
template <int D>
bool opposite_as_written(std::span<const Cell<D>> cells, HalfFacetId h, HalfFacetId m) {
  Cell<D> one = cells[cell_of<D>(h).value];
  const Cell<D>& other = cells[cell_of<D>(m).value];
  const auto i = static_cast<std::size_t>(local_index<D>(h));
  const auto j = static_cast<std::size_t>(local_index<D>(m));
  // Put the other apex in the place of ours: the facet keeps its induced orientation relative to
  // the apex's place, so the cells are coherent iff `one` is now an odd permutation of `other`.
  one[i] = other[j];
  bool odd = false;
  for (std::size_t a = 0; a < one.size(); ++a) {
    if (one[a] == other[a]) continue;
    const auto b = static_cast<std::size_t>(
        std::find(one.begin() + static_cast<std::ptrdiff_t>(a), one.end(), other[a]) - one.begin());
    std::swap(one[a], one[b]);
    odd = !odd;
  }
  return odd;
}

}  // namespace cleave::topology::detail
