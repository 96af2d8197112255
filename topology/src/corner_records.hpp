#pragma once
#include <algorithm>
#include <atomic>
#include <bit>
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

/// A corner with the cell that it is in.
template <int D>
struct CornerRecord {
  Cell<D> cell;
  CornerId corner;
};

/// The vertices begin .. end.
struct VertexRange {
  std::size_t begin = 0, end = 0;
};

/// For cells without order: the corners that CornerBuckets holds, but with their cells, so that no
/// cell is looked up. The cells are streamed; their records go to blocks of 2^k vertices, small
/// enough for the nearer caches. In rounds, each for a range of the blocks, to save memory.
template <int D>
class CornerRecords {
 public:
  /// Counts the records of each block and brings the stage to the fraction `until`. None if a cell
  /// names a vertex that does not exist, or if a block has more than an eighth as many records as
  /// there are cells.
  static std::optional<CornerRecords> counted(std::span<const Cell<D>> cells,
                                              std::size_t vertex_count, Crew& crew, double until) {
    CornerRecords records(cells, vertex_count, crew);
    if (!records.count(until)) return std::nullopt;
    for (std::size_t b = 0; b < records.blocks(); ++b)
      if (records.size(b) > records.most_per_block()) return std::nullopt;
    return records;
  }

  std::size_t blocks() const { return counts_[0].size(); }

  VertexRange vertices(std::size_t block) const {
    return {block << block_bits_, std::min((block + 1) << block_bits_, vertex_count_)};
  }

  /// The end of the blocks of the round that begins with `first`.
  std::size_t round_end(std::size_t first) const {
    std::size_t end = first;
    for (std::size_t sum = 0; end < blocks(); ++end) {
      sum += size(end);
      if (sum > most_per_round()) break;
    }
    return end;
  }

  /// Puts down the records of the blocks first .. last, in place of those that are there. Brings
  /// the stage from one fraction to another. For any number of workers they are the same.
  void fill(std::size_t first, std::size_t last, double from, double to) {
    // Records of other blocks are written, too, to a place that stays: there is no branch to miss.
    std::vector<std::vector<Place>> places;
    for (std::size_t w = 0; w < counts_.size(); ++w)
      places.emplace_back(blocks(), Place{memory() + most_per_round() + w * kUnused, 0});
    first_block_ = first;
    starts_.assign(1, 0);
    for (std::size_t b = first; b < last; ++b) {
      std::size_t next = starts_.back();
      for (std::size_t w = 0; w < counts_.size(); ++w) {
        places[w][b] = {memory() + next, 1};
        next += counts_[w][b];
      }
      starts_.push_back(next);
    }
    crew_->on_blocks(cells_.size(), from, to, [&](int worker, std::size_t begin, std::size_t end) {
      Place* const place = places[static_cast<std::size_t>(worker)].data();
      auto corner = static_cast<Index>((D + 1) * begin);
      for (const Cell<D>& cell : cells_.subspan(begin, end - begin)) {
        for (const PlacedVertex v : two_least<D>(cell)) {
          auto& [next, step] = place[vertex_of(v) >> block_bits_];
          *next = {cell, CornerId{corner + place_of(v)}};
          next += step;
          __builtin_prefetch(reinterpret_cast<const std::byte*>(next) + kBytesAhead, 1);
        }
        corner += D + 1;
      }
    });
  }

  /// The records of a block of the last round filled.
  std::span<const CornerRecord<D>> operator[](std::size_t block) const {
    const std::size_t n = block - first_block_;
    return {memory() + starts_[n], starts_[n + 1] - starts_[n]};
  }

 private:
  static constexpr std::size_t kBlockBytes = std::size_t{1}
                                             << 15;  // a block has one to two times that
  static constexpr std::size_t kMostBlocks = 4096, kFewRecords = 1024;
  static constexpr std::size_t kBytesAhead = 128;
  static constexpr std::size_t kUnused = 8;  // records for each worker, not to share cache lines

  /// Where the next record of a block goes, and how far that moves.
  struct Place {
    CornerRecord<D>* next;
    std::size_t step;
  };

  CornerRecords(std::span<const Cell<D>> cells, std::size_t vertex_count, Crew& crew)
      : cells_(cells), vertex_count_(vertex_count), crew_(&crew) {
    const std::size_t per_block =
        kBlockBytes / sizeof(CornerRecord<D>) * vertex_count / (2 * cells.size() + 1);
    block_bits_ = static_cast<int>(std::bit_width(std::max(per_block, vertex_count / kMostBlocks)));
    counts_.resize(static_cast<std::size_t>(crew.size()));
    for (auto& counts : counts_) counts.assign((vertex_count >> block_bits_) + 1, 0);
  }

  bool count(double until) {
    std::atomic<bool> sound = true;
    crew_->on_blocks(cells_.size(), 0, until, [&](int worker, std::size_t begin, std::size_t end) {
      std::vector<std::size_t>& counts = counts_[static_cast<std::size_t>(worker)];
      for (const Cell<D>& cell : cells_.subspan(begin, end - begin)) {
        bool exist = true;
        for (const VertexId v : cell) exist &= v.value < vertex_count_;
        if (!exist) {
          sound = false;
          return;
        }
        for (const PlacedVertex v : two_least<D>(cell)) ++counts[vertex_of(v) >> block_bits_];
      }
    });
    return sound;
  }

  std::size_t size(std::size_t block) const {
    std::size_t sum = 0;
    for (const auto& counts : counts_) sum += counts[block];
    return sum;
  }
  std::size_t most_per_block() const { return cells_.size() / 8 + kFewRecords; }
  std::size_t most_per_round() const { return cells_.size() + most_per_block(); }

  /// Room for the records of a round. They are not constructed: that would write to all of it
  /// before large pages are asked for.
  CornerRecord<D>* memory() {
    if (!memory_) {
      const std::size_t size = most_per_round() + kUnused * counts_.size();
      memory_ = std::make_unique_for_overwrite<std::byte[]>(size * sizeof(CornerRecord<D>));
      ask_for_large_pages(memory_.get(), size * sizeof(CornerRecord<D>));
    }
    return reinterpret_cast<CornerRecord<D>*>(memory_.get());
  }
  const CornerRecord<D>* memory() const {
    return reinterpret_cast<const CornerRecord<D>*>(memory_.get());
  }

  std::span<const Cell<D>> cells_;
  std::size_t vertex_count_;
  Crew* crew_;
  int block_bits_ = 0;
  std::vector<std::vector<std::size_t>> counts_;  // of the records of each worker and block
  std::unique_ptr<std::byte[]> memory_;
  std::size_t first_block_ = 0;
  std::vector<std::size_t> starts_;  // of the blocks of this round, and the end
};

}  // namespace cleave::topology::detail
