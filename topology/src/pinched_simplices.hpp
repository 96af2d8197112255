#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "cleave/topology/violation.hpp"
#include "corner_set.hpp"
#include "flood.hpp"

namespace cleave::topology::detail {

/// The local indices i of which the facet opposite i leads to a cell before `cell`.
template <int D>
std::uint32_t earlier_neighbours(const std::vector<HalfFacetId>& mates, CellId cell) {
  const Index first = half_facet<D>(cell, 0).value;
  std::uint32_t mask = 0;
  for (std::uint32_t i = 0; i <= D; ++i) mask |= (mates[first + i].value < first ? 1u : 0u) << i;
  return mask;
}

/// The vertices of a simplex, ascending.
template <std::size_t Size>
using Simplex = std::array<VertexId, Size>;

/// The faces of `Size` vertices of any cell, by their local indices.
template <int D, std::size_t Size>
constexpr auto local_faces() {
  struct LocalFace {
    std::array<std::size_t, Size> indices{};
    std::uint32_t mask = 0;
  };
  constexpr auto kCount = [] {
    std::size_t count = 0;
    for (std::uint32_t mask = 0; mask < 1u << (D + 1); ++mask)
      count += std::popcount(mask) == static_cast<int>(Size) ? 1 : 0;
    return count;
  }();
  std::array<LocalFace, kCount> faces{};
  auto face = faces.begin();
  for (std::uint32_t mask = 0; mask < 1u << (D + 1); ++mask) {
    if (std::popcount(mask) != static_cast<int>(Size)) continue;
    face->mask = mask;
    for (std::size_t i = 0, to = 0; i <= static_cast<std::size_t>(D); ++i)
      if (mask >> i & 1u) face->indices[to++] = i;
    ++face;
  }
  return faces;
}

template <std::size_t Size>
void put_in_order(Simplex<Size>& simplex) {
  for (std::size_t end = Size; end-- > 1;)  // a network without branches
    for (std::size_t i = 0; i < end; ++i) {
      const VertexId low = std::min(simplex[i], simplex[i + 1]);
      simplex[i + 1] = std::max(simplex[i], simplex[i + 1]);
      simplex[i] = low;
    }
}

/// Calls visit(simplex, cell) for the simplices of `Size` vertices and the cells in which they are
/// met first: no cell before `cell` shares a facet with it that contains the simplex, so that the
/// facets to the neighbours before `cell` are opposite vertices of the simplex. The least cell of
/// each part of the cells around a simplex is among these, and in mesh order hardly another.
template <std::size_t Size, int D, class Visit>
void for_each_first_met(std::span<const Cell<D>> cells, const std::vector<HalfFacetId>& mates,
                        Visit visit) {
  constexpr auto kFaces = local_faces<D, Size>();
  for (Index c = 0; c < cells.size(); ++c) {
    const std::uint32_t earlier = earlier_neighbours<D>(mates, CellId{c});
    if (static_cast<std::size_t>(std::popcount(earlier)) > Size) continue;
    for (const auto& face : kFaces) {
      if ((earlier & ~face.mask) != 0) continue;
      Simplex<Size> simplex;
      for (std::size_t n = 0; n < Size; ++n) simplex[n] = cells[c][face.indices[n]];
      put_in_order(simplex);
      visit(simplex, CellId{c});
    }
  }
}

/// Finds the facet-connected parts of the cells around one simplex after another.
template <int D>
class PartsAround {
 public:
  PartsAround(std::span<const Cell<D>> cells, const std::vector<HalfFacetId>& mates)
      : cells_(cells), mates_(mates) {}

  /// The first cell of each part, of `firsts`: cells around the simplex, of each part the least one
  /// before others of it.
  template <std::size_t Size>
  const std::vector<CellId>& of(const Simplex<Size>& simplex, std::span<const CellId> firsts) {
    seen_.clear();
    parts_.clear();
    for (const CellId first : firsts) {
      if (!seen_.insert(half_facet<D>(first, 0))) continue;
      parts_.push_back(first);
      queue_.assign(1, first);
      for (std::size_t next = 0; next < queue_.size(); ++next)
        for (std::size_t i = 0; i <= static_cast<std::size_t>(D); ++i) {
          const CellId cell = queue_[next];
          const VertexId opposite = cells_[cell.value][i];
          if (std::find(simplex.begin(), simplex.end(), opposite) != simplex.end()) continue;
          const HalfFacetId mate = mates_[half_facet<D>(cell, static_cast<int>(i)).value];
          if (is_mate(mate) && seen_.insert(half_facet<D>(cell_of<D>(mate), 0)))
            queue_.push_back(cell_of<D>(mate));
        }
    }
    return parts_;
  }

 private:
  std::span<const Cell<D>> cells_;
  const std::vector<HalfFacetId>& mates_;
  CornerSet seen_;  // the first corners of the cells
  std::vector<CellId> queue_, parts_;
};

/// What for_each_first_met visits, by least vertices: visit(v, entries) for each vertex v that is
/// the least of a simplex, with an Entry(simplex, cell) of each that asked(simplex) holds for. A
/// counting sort.
template <std::size_t Size, class Entry, int D, class Asked, class Visit>
void for_each_bucket_of_first_met(std::span<const Cell<D>> cells,
                                  const std::vector<HalfFacetId>& mates, std::size_t vertex_count,
                                  Asked asked, Visit visit) {
  std::vector<Index> end(vertex_count + 1, 0);  // begin until filled
  for_each_first_met<Size, D>(cells, mates, [&](const Simplex<Size>& simplex, CellId) {
    if (asked(simplex)) ++end[simplex[0].value + 1];
  });
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<Entry> all(end.back());
  for_each_first_met<Size, D>(cells, mates, [&](const Simplex<Size>& simplex, CellId cell) {
    if (asked(simplex)) all[end[simplex[0].value]++] = Entry(simplex, cell);
  });
  for (Index v = 0, begin = 0; v < vertex_count; begin = end[v++])
    if (begin != end[v]) visit(VertexId{v}, std::span(all).subspan(begin, end[v] - begin));
}

/// Those of `Size` vertices, of which asked(vertex) holds. See find_pinched_simplices.
template <std::size_t Size, int D, class Asked>
void find_pinched_of_size(std::span<const Cell<D>> cells, const std::vector<HalfFacetId>& mates,
                          std::size_t vertex_count, Asked asked, std::vector<Violation>& found,
                          std::vector<VertexId>& vertices) {
  struct FirstMet {
    FirstMet() = default;
    FirstMet(const Simplex<Size>& simplex, CellId in) : cell(in) {
      std::copy(simplex.begin() + 1, simplex.end(), others.begin());
    }
    std::array<VertexId, Size - 1> others{};  // the vertices of the simplex but the least
    CellId cell{};
  };
  const auto all_asked = [&](const Simplex<Size>& simplex) {
    return std::all_of(simplex.begin(), simplex.end(), asked);
  };
  PartsAround<D> around(cells, mates);
  std::vector<CellId> firsts;
  const auto look_at = [&](VertexId least, std::span<FirstMet> bucket) {
    std::sort(bucket.begin(), bucket.end(), [](const FirstMet& a, const FirstMet& b) {
      for (std::size_t n = 0; n + 1 < Size; ++n)
        if (a.others[n] != b.others[n]) return a.others[n] < b.others[n];
      return a.cell < b.cell;
    });
    for (auto first = bucket.begin(), last = first; first != bucket.end(); first = last) {
      while (last != bucket.end() && last->others == first->others) ++last;
      if (last - first == 1) continue;
      firsts.clear();
      for (auto entry = first; entry != last; ++entry) firsts.push_back(entry->cell);
      Simplex<Size> simplex{least};
      std::copy(first->others.begin(), first->others.end(), simplex.begin() + 1);
      const std::vector<CellId>& parts = around.of(simplex, firsts);
      if (parts.size() == 1) continue;
      found.push_back(
          PinchedSimplex{{simplex.begin(), simplex.end()}, parts[0], parts[1], parts.size()});
      vertices.insert(vertices.end(), simplex.begin(), simplex.end());
    }
  };
  for_each_bucket_of_first_met<Size, FirstMet, D>(cells, mates, vertex_count, all_asked, look_at);
}

/// Simplices of dimension 1 .. D-2 whose cells fall into several facet-connected parts, by
/// dimension, then lexicographically; only those of whose vertices asked(vertex) holds. Returns
/// their vertices, with repetitions. Time: linear, and sorting those that have the least vertex in
/// common; memory, D = 4, in mesh order: about 40 bytes per cell.
template <int D, class Asked>
std::vector<VertexId> find_pinched_simplices(std::span<const Cell<D>> cells,
                                             const std::vector<HalfFacetId>& mates,
                                             std::size_t vertex_count, Asked asked,
                                             std::vector<Violation>& found) {
  std::vector<VertexId> vertices;
  if constexpr (D >= 3)
    find_pinched_of_size<2, D>(cells, mates, vertex_count, asked, found, vertices);
  if constexpr (D >= 4)
    find_pinched_of_size<3, D>(cells, mates, vertex_count, asked, found, vertices);
  static_assert(D <= 4);
  return vertices;
}

}  // namespace cleave::topology::detail
