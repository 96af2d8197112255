#pragma once
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "corner_buckets.hpp"
#include "corner_records.hpp"
#include "crew.hpp"
#include "facet_bucket.hpp"
#include "large_array.hpp"

namespace cleave::topology::detail {

/// plain_mates for cells in an order that keeps neighbours near each other.
/// Memory beyond the result, D = 3: 8 bytes per cell, 4 per vertex and worker.
template <int D, class Reversed>
std::optional<std::vector<HalfFacetId>> mates_by_buckets(std::span<const Cell<D>> cells,
                                                         std::size_t vertex_count,
                                                         Reversed reversed, Crew& crew) {
  const auto buckets = CornerBuckets<D>::of(cells, vertex_count, crew);
  if (!buckets) return std::nullopt;
  auto mates = large_array<HalfFacetId>(cells.size() * (D + 1));
  std::atomic<bool> plain = true;
  std::vector<FacetBucket<D>> facets(static_cast<std::size_t>(crew.size()));
  constexpr double kFilled = CornerBuckets<D>::kFilled;
  crew.share(vertex_count, kFilled, 1, [&](int worker, std::size_t begin, std::size_t end) {
    FacetBucket<D>& bucket = facets[static_cast<std::size_t>(worker)];
    for (std::size_t v = begin; v < end && plain; ++v) {
      const std::size_t first = buckets->begin(v), last = buckets->begin(v + 1);
      bucket.begin(VertexId{static_cast<Index>(v)}, last - first);
      for (std::size_t n = first; n < last; ++n) {
        const CornerId later = (*buckets)[n + CornerBuckets<D>::kAhead], corner = (*buckets)[n];
        __builtin_prefetch(&cells[cell_of<D>(later).value]);
        __builtin_prefetch(&mates[later.value], 1);
        const CellId cell = cell_of<D>(corner);
        bucket.add(corner, cells[cell.value], reversed(cell));
      }
      if (!bucket.match(mates)) plain = false;
    }
  });
  if (!plain) return std::nullopt;
  return mates;
}

/// Matches the facets of blocks of corner records.
template <int D>
class BlockMatcher {
 public:
  /// Writes the mates of the facets that have their least vertex in the block. Whether all is
  /// plain.
  template <class Reversed>
  bool match(std::span<const CornerRecord<D>> records, VertexRange vertices, Reversed reversed,
             std::vector<HalfFacetId>& mates) {
    sort(records, vertices);
    std::size_t n = 0;
    for (std::size_t v = vertices.begin; v < vertices.end; ++v) {
      const std::size_t last = ends_[v - vertices.begin];
      bucket_.begin(VertexId{static_cast<Index>(v)}, last - n);
      for (; n < last; ++n) {
        __builtin_prefetch(&mates[records[order_[n + kAhead]].corner.value], 1);
        const CornerRecord<D>& record = records[order_[n]];
        bucket_.add(record.corner, record.cell, reversed(cell_of<D>(record.corner)));
      }
      if (!bucket_.match(mates)) return false;
    }
    return true;
  }

 private:
  static constexpr std::size_t kAhead = 24;

  /// Puts the numbers of the records in the order of their vertices.
  void sort(std::span<const CornerRecord<D>> records, VertexRange vertices) {
    const auto place = [&](const CornerRecord<D>& record) -> Index& {
      const auto at = static_cast<std::size_t>(local_index<D>(record.corner));
      return ends_[record.cell[at].value - vertices.begin];
    };
    ends_.assign(vertices.end - vertices.begin, 0);
    for (const CornerRecord<D>& record : records) ++place(record);
    std::exclusive_scan(ends_.begin(), ends_.end(), ends_.begin(), Index{0});
    order_.assign(records.size() + kAhead, 0);
    for (Index n = 0; n < records.size(); ++n) order_[place(records[n])++] = n;
  }

  std::vector<Index> ends_, order_;  // ends_: where the records of each vertex end in order_
  FacetBucket<D> bucket_;
};

/// plain_mates for cells without order. None, too, if there are vertices in very many cells.
/// Memory beyond the result, D = 3: 23 bytes per cell, 0.5 more per worker in the worst case.
template <int D, class Reversed>
std::optional<std::vector<HalfFacetId>> mates_by_records(std::span<const Cell<D>> cells,
                                                         std::size_t vertex_count,
                                                         Reversed reversed, Crew& crew) {
  constexpr double kCounted = 0.05, kFilled = 0.15;  // fractions of the whole, and of a round
  auto records = CornerRecords<D>::counted(cells, vertex_count, crew, kCounted);
  if (!records) return std::nullopt;
  auto mates = large_array<HalfFacetId>(cells.size() * (D + 1));
  std::atomic<bool> plain = true;
  std::vector<BlockMatcher<D>> matchers(static_cast<std::size_t>(crew.size()));
  const auto progress = [&](std::size_t block) {
    const auto blocks = static_cast<double>(records->blocks());
    return kCounted + (1 - kCounted) * static_cast<double>(block) / blocks;
  };
  for (std::size_t first = 0, last = 0; first < records->blocks() && plain; first = last) {
    last = records->round_end(first);
    const double begun = progress(first), done = progress(last);
    const double filled = begun + kFilled * (done - begun);
    records->fill(first, last, begun, filled);
    crew.share(
        last - first, filled, done,
        [&](int worker, std::size_t begin, std::size_t end) {
          BlockMatcher<D>& matcher = matchers[static_cast<std::size_t>(worker)];
          for (std::size_t b = first + begin; b < first + end && plain; ++b)
            if (!matcher.match((*records)[b], records->vertices(b), reversed, mates)) plain = false;
        },
        1);
  }
  if (!plain) return std::nullopt;
  return mates;
}

/// Whether the numbers of cells and vertices say little about where they are: most of some hundred
/// cells have little to do with the cells shortly after them.
template <int D>
bool without_order(std::span<const Cell<D>> cells, std::size_t vertex_count) {
  constexpr std::size_t kSamples = 256, kApart = 64, kLeastCells = std::size_t{1} << 18;
  if (cells.size() < kLeastCells) return false;  // they stay in the caches
  std::size_t far = 0;
  for (std::size_t n = 0; n < kSamples; ++n) {
    const std::size_t c = (cells.size() - kApart) / kSamples * n;
    const auto [low, high] = std::minmax(cells[c][0].value, cells[c + kApart][0].value);
    far += high - low > vertex_count / 64 ? 1 : 0;
  }
  return far > kSamples / 2;
}

/// The mates of all half-facets (kNone on the boundary) of a mesh that is plain: its cells are
/// sound, none is there twice, no facet is in three cells, and mates have opposite orientations.
/// None if it is not; match_facets and `check` say why. `reversed(c)`: whether cell number c has
/// the reverse of its tuple's orientation. Time: linear.
template <int D, class Reversed>
std::optional<std::vector<HalfFacetId>> plain_mates(std::span<const Cell<D>> cells,
                                                    std::size_t vertex_count, Reversed reversed,
                                                    Crew& crew) {
  if (without_order<D>(cells, vertex_count))
    if (auto mates = mates_by_records<D>(cells, vertex_count, reversed, crew)) return mates;
  return mates_by_buckets<D>(cells, vertex_count, reversed, crew);
}

}  // namespace cleave::topology::detail
