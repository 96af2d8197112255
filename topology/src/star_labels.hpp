#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "complex_access.hpp"
#include "large_array.hpp"

namespace cleave::topology::detail {

/// Finds the facet-connected parts of all stars in one pass over the cells, as the components of an
/// image are found in one pass over its pixels (Rosenfeld and Pfaltz 1966). A corner takes its
/// label from the cells before its own that share a facet with it and its vertex, or a new one if
/// there is none; where two labels of a vertex meet, they are united. A star is one part iff all
/// its labels are united in the end.
/// In mesh order most cells have two neighbours or more before them, and all labels there are 0:
/// then all its corners have a neighbour before them, and their labels are 0. Neither the cell nor
/// its vertices are looked at. No star is ever gathered, so that the order matters little.
template <int D>
class StarLabels {
 public:
  StarLabels(std::span<const Cell<D>> cells, const std::vector<HalfFacetId>& mates,
             std::size_t vertex_count)
      : cells_(cells),
        mates_(mates),
        a_corner_(vertex_count, CornerId{kNone}),
        labels_(large_array<Packed>(cells.size())),
        roots_(large_array<Roots>(vertex_count)) {
    for (Roots& roots : roots_) roots.fill(kUnused);
  }

  void label_all() {
    for (Index c = 0; c < cells_.size(); ++c)
      if (!all_zero(c)) label(c);
  }

  /// Vertices whose stars are several parts, and the few with too many labels to tell, ascending.
  std::vector<VertexId> suspects() const {
    std::vector<VertexId> found = crowded_;
    if (parts_ != vertices_)
      for (Index v = 0; v < roots_.size(); ++v)
        if (a_corner_[v].value != kNone &&
            std::any_of(roots_[v].begin(), roots_[v].end(),
                        [](std::uint8_t root) { return root != 0 && root != kUnused; }))
          found.push_back(VertexId{v});
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  /// The least corner at each vertex; kNone: no cell uses it.
  std::vector<CornerId> take_a_corner() { return std::move(a_corner_); }

 private:
  // A star of n cells has n/(D+1) labels if they are numbered at random: enough for 60 and 300.
  static constexpr int kBits = D <= 3 ? 4 : 6;
  static constexpr std::size_t kLabels = std::size_t{1} << kBits;
  static constexpr std::uint8_t kUnused = 0xff;
  static constexpr std::uint32_t kNoLabel = kLabels;
  static constexpr Index kAhead = 24;  // cells between asking for memory and using it

  /// The labels of the corners of a cell, kBits each.
  using Packed = std::conditional_t<D <= 3, std::uint16_t, std::uint32_t>;
  /// For each label of a star the least that it is united with.
  using Roots = std::array<std::uint8_t, kLabels>;

  /// Whether `cell` has several neighbours before it, and these have no label but 0.
  bool all_zero(Index cell) const {
    const HalfFacetId* mates = &mates_[half_facet<D>(CellId{cell}, 0).value];
    const Index first = half_facet<D>(CellId{cell}, 0).value;
    std::uint32_t before = 0;
    Packed any = 0;
    for (int i = 0; i <= D; ++i) {
      const bool is_before = mates[i].value < first;
      before += is_before ? 1 : 0;
      any = static_cast<Packed>(any | labels_[is_before ? cell_of<D>(mates[i]).value : cell]);
    }
    return before >= 2 && any == 0;
  }

  void label(Index c) {
    if (c + 2 * kAhead < cells_.size()) fetch(c + kAhead, c + 2 * kAhead);
    const Cell<D>& cell = cells_[c];
    std::array<std::uint32_t, static_cast<std::size_t>(D) + 1> labels;
    labels.fill(kNoLabel);
    const Index first = half_facet<D>(CellId{c}, 0).value;
    std::array<std::size_t, static_cast<std::size_t>(D) + 1> met_before;  // facets
    std::size_t count = 0;
    for (std::size_t i = 0; i < cell.size(); ++i) {
      met_before[count] = i;
      count += mates_[first + i].value < first ? 1 : 0;
    }
    for (std::size_t n = 0; n < count; ++n) {
      const std::size_t i = met_before[n];
      const Index across = cell_of<D>(mates_[first + i]).value;
      const Cell<D> there = cells_[across];
      const std::uint32_t packed_there = labels_[across];
      for (std::size_t j = 0; j < cell.size(); ++j) {
        if (j == i) continue;
        int shift = 0;
        for (std::size_t k = 1; k < cell.size(); ++k)
          shift += there[k] == cell[j] ? static_cast<int>(k) * kBits : 0;
        const std::uint32_t label = roots_[cell[j].value][packed_there >> shift & (kLabels - 1)];
        labels[j] =
            labels[j] == kNoLabel || labels[j] == label ? label : united(cell[j], labels[j], label);
      }
    }
    std::uint32_t packed = 0;
    for (std::size_t j = 0; j < cell.size(); ++j) {
      if (labels[j] == kNoLabel)
        labels[j] = new_label(cell[j], CornerId{first + static_cast<Index>(j)});
      packed |= labels[j] << static_cast<int>(j) * kBits;
    }
    labels_[c] = static_cast<Packed>(packed);
  }

  /// Asks for what will be read of cell `near`, and of `far`, which is further ahead.
  [[gnu::always_inline]] void fetch(Index near, Index far) const {
    for (const VertexId v : cells_[near]) {
      __builtin_prefetch(&roots_[v.value]);
    }
    for (int i = 0; i <= D; ++i) {
      const HalfFacetId mate = mates_[half_facet<D>(CellId{far}, i).value];
      const bool is_before = mate.value < half_facet<D>(CellId{far}, 0).value;
      const Index across = is_before ? cell_of<D>(mate).value : far;
      __builtin_prefetch(&labels_[across]);
      __builtin_prefetch(&cells_[across]);
    }
  }

  /// Unites two labels of a vertex; returns their root.
  std::uint32_t united(VertexId vertex, std::uint32_t one, std::uint32_t other) {
    Roots& roots = roots_[vertex.value];
    const std::uint8_t low = std::min(roots[one], roots[other]);
    const std::uint8_t high = std::max(roots[one], roots[other]);
    for (std::uint8_t& root : roots) root = root == high ? low : root;
    parts_ -= low != high ? 1 : 0;
    return low;
  }

  std::uint32_t new_label(VertexId vertex, CornerId corner) {
    Roots& roots = roots_[vertex.value];
    std::size_t label = 0;
    if (roots[0] == kUnused) {
      a_corner_[vertex.value] = corner;
      ++vertices_;
    } else {
      while (label < kLabels && roots[label] != kUnused) ++label;
      if (label == kLabels) {
        crowded_.push_back(vertex);
        return 0;
      }
    }
    ++parts_;
    return roots[label] = static_cast<std::uint8_t>(label);
  }

  std::span<const Cell<D>> cells_;
  const std::vector<HalfFacetId>& mates_;
  std::vector<CornerId> a_corner_;
  std::vector<Packed> labels_;            // of the corners of each cell
  std::vector<Roots> roots_;              // of each vertex with a corner
  std::vector<VertexId> crowded_;         // vertices that got too few labels
  std::size_t vertices_ = 0, parts_ = 0;  // so far: met, and of their stars
};

}  // namespace cleave::topology::detail
