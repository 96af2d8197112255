#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "pinched_simplices.hpp"

namespace cleave::topology::detail {

/// The number of different simplices of `Size` vertices, 1 < Size < D.
template <std::size_t Size, int D>
std::size_t count_simplices(std::span<const Cell<D>> cells, const std::vector<HalfFacetId>& mates,
                            std::size_t vertex_count) {
  struct Others : Simplex<Size - 1> {  // the vertices but the least
    Others() = default;
    Others(const Simplex<Size>& simplex, CellId) {
      std::copy(simplex.begin() + 1, simplex.end(), this->begin());
    }
  };
  std::size_t count = 0;
  for_each_bucket_of_first_met<Size, Others, D>(
      cells, mates, vertex_count, [](const auto&) { return true; },
      [&](VertexId, std::span<Others> bucket) {
        std::sort(bucket.begin(), bucket.end());
        count +=
            static_cast<std::size_t>(std::unique(bucket.begin(), bucket.end()) - bucket.begin());
      });
  return count;
}

/// The numbers of different simplices by dimension, of cells that are sound, different and at most
/// two at a facet. Time: linear, and sorting those that have the least vertex in common; memory,
/// D = 3, in mesh order: about 6 bytes per cell.
template <int D>
std::array<std::size_t, D + 1> simplex_counts(std::span<const Cell<D>> cells,
                                              const std::vector<HalfFacetId>& mates,
                                              std::size_t vertex_count) {
  std::array<std::size_t, D + 1> counts{};
  std::vector<bool> used(vertex_count, false);
  for (const Cell<D>& cell : cells)
    for (const VertexId v : cell) used[v.value] = true;
  counts[0] = static_cast<std::size_t>(std::count(used.begin(), used.end(), true));
  if constexpr (D >= 3) counts[1] = count_simplices<2, D>(cells, mates, vertex_count);
  if constexpr (D >= 4) counts[2] = count_simplices<3, D>(cells, mates, vertex_count);
  static_assert(D <= 4);
  const auto alone =
      static_cast<std::size_t>(std::count(mates.begin(), mates.end(), HalfFacetId{kNone}));
  if constexpr (D >= 2) counts[D - 1] = (mates.size() + alone) / 2;
  counts[D] = cells.size();
  return counts;
}

}  // namespace cleave::topology::detail
