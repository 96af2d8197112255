#pragma once
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "crew.hpp"
#include "large_array.hpp"
#include "two_least.hpp"

namespace cleave::topology::detail {

/// For each vertex, its corners in cells of which it is the least or the second least: every facet
/// of a cell has one of these two as its least vertex. 8 bytes per cell and 4 per vertex.
template <int D>
class CornerBuckets {
 public:
  /// None if a cell names a vertex that does not exist.
  static std::optional<CornerBuckets> of(std::span<const Cell<D>> cells, std::size_t vertex_count,
                                         Crew& crew) {
    // ends[w][v]: where the next corner that worker w finds goes in bucket v. The workers' blocks
    // of cells come one after the other, so that the buckets are the same for any number of them.
    std::vector<std::vector<Index>> ends(static_cast<std::size_t>(crew.size()));
    for (auto& end : ends) end.assign(vertex_count, 0);
    std::atomic<bool> sound = true;
    crew.on_blocks(cells.size(), 0, kCounted, [&](int worker, std::size_t begin, std::size_t end) {
      std::vector<Index>& count = ends[static_cast<std::size_t>(worker)];
      for (const Cell<D>& cell : cells.subspan(begin, end - begin)) {
        bool exist = true;
        for (const VertexId v : cell) exist &= v.value < vertex_count;
        if (!exist) {
          sound = false;
          return;
        }
        const auto [least, second] = two_least<D>(cell);
        ++count[vertex_of(least)];
        ++count[vertex_of(second)];
      }
    });
    if (!sound) return std::nullopt;
    Index next = 0;
    for (std::size_t v = 0; v < vertex_count; ++v)
      for (auto& end : ends) next += std::exchange(end[v], next);

    CornerBuckets buckets;
    buckets.corners_ = std::make_unique_for_overwrite<Index[]>(2 * cells.size() + kAhead);
    ask_for_large_pages(buckets.corners_.get(), 2 * cells.size() * sizeof(Index));
    std::fill_n(buckets.corners_.get() + 2 * cells.size(), kAhead, Index{0});
    Index* const corners = buckets.corners_.get();
    const auto fill = [&](int worker, std::size_t begin, std::size_t end) {
      std::vector<Index>& place = ends[static_cast<std::size_t>(worker)];
      auto first = static_cast<Index>((D + 1) * begin);
      for (const Cell<D>& cell : cells.subspan(begin, end - begin)) {
        const auto [least, second] = two_least<D>(cell);
        corners[place[vertex_of(least)]++] = first + place_of(least);
        corners[place[vertex_of(second)]++] = first + place_of(second);
        first += D + 1;
      }
    };
    crew.on_blocks(cells.size(), kCounted, kFilled, fill);
    buckets.end_ = std::move(ends.back());
    return buckets;
  }

  /// Bucket v is the places begin(v) .. begin(v + 1); kAhead more may be read after the last one.
  Index begin(std::size_t vertex) const { return vertex == 0 ? 0 : end_[vertex - 1]; }
  CornerId operator[](std::size_t place) const { return {corners_[place]}; }
  static constexpr std::size_t kAhead = 24;

  /// The fractions of matching's time that have passed when corners are counted, and in place.
  static constexpr double kCounted = 0.1, kFilled = 0.25;

 private:
  std::unique_ptr<Index[]> corners_;
  std::vector<Index> end_;
};

}  // namespace cleave::topology::detail
