#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "cleave/topology/violation.hpp"
#include "facet_matching.hpp"

namespace cleave::topology::detail {

/// Looks for short loops of cells along which no orientation is coherent: paths in the orientation
/// double cover (each cell twice, its two sides joined to those of its neighbours as their tuples
/// agree) from one side of a cell to the other.
template <int D>
class OddLoops {
 public:
  OddLoops(std::span<const Cell<D>> cells, const std::vector<HalfFacetId>& mates)
      : cells_(cells),
        mates_(mates),
        seen_(2 * cells.size(), 0),
        depth_(2 * cells.size()),
        entered_by_(2 * cells.size()) {}

  /// Replaces `best` by a shortest loop through `start` if that is shorter. Takes one from `steps`
  /// per side of a cell it visits; stops when there are none left.
  void shorten(CellId start, NonOrientable& best, std::size_t& steps) {
    ++round_;
    const Index from = 2 * start.value;
    queue_.assign(1, from);
    seen_[from] = round_;
    depth_[from] = 0;
    Index meeting = kNone;  // a side of the cell where the two halves of a loop meet
    std::size_t length = best.loop.size();
    for (std::size_t next = 0; next < queue_.size() && steps > 0; ++next, --steps) {
      const Index side = queue_[next];
      if (2 * std::size_t{depth_[side]} + 1 >= length) break;  // the halves differ by one at most
      for (int i = 0; i <= D; ++i) {
        const HalfFacetId h = half_facet<D>(CellId{side / 2}, i);
        const HalfFacetId mate = mates_[h.value];
        if (mate.value == kNone) continue;
        const bool agree = opposite_as_written<D>(cells_, h, mate);
        const Index across = 2 * cell_of<D>(mate).value + (side % 2 ^ (agree ? 0u : 1u));
        if (seen_[across] == round_) continue;
        seen_[across] = round_;
        depth_[across] = depth_[side] + 1;
        entered_by_[across] = h;
        queue_.push_back(across);
        const Index other = across ^ 1u;
        if (seen_[other] != round_ || depth_[across] + std::size_t{depth_[other]} >= length)
          continue;
        length = depth_[across] + std::size_t{depth_[other]};
        meeting = across;
      }
    }
    if (meeting != kNone) best.loop = loop_through(meeting);
  }

 private:
  /// The half-facets passed on the way from the start to this side of a cell.
  std::vector<HalfFacetId> path_to(Index side) const {
    std::vector<HalfFacetId> path;
    while (depth_[side] > 0) {
      const HalfFacetId h = entered_by_[side];
      path.push_back(h);
      const bool agree = opposite_as_written<D>(cells_, h, mates_[h.value]);
      side = 2 * cell_of<D>(h).value + (side % 2 ^ (agree ? 0u : 1u));
    }
    std::reverse(path.begin(), path.end());
    return path;
  }

  std::vector<HalfFacetId> loop_through(Index meeting) const {
    std::vector<HalfFacetId> loop = path_to(meeting);
    const std::vector<HalfFacetId> other = path_to(meeting ^ 1u);
    for (auto h = other.rbegin(); h != other.rend(); ++h) loop.push_back(mates_[h->value]);
    return loop;
  }

  std::span<const Cell<D>> cells_;
  const std::vector<HalfFacetId>& mates_;
  std::vector<Index> seen_, depth_;      // per side: the last round that met it, and how far
  std::vector<HalfFacetId> entered_by_;  // per side: through which half-facet, of the cell before
  std::vector<Index> queue_;
  Index round_ = 0;
};

}  // namespace cleave::topology::detail
