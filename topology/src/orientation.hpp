#pragma once
#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "cleave/topology/violation.hpp"
#include "facet_matching.hpp"
#include "odd_loop.hpp"

namespace cleave::topology::detail {

/// Signs that make mates opposite wherever that can be, and one loop per piece where it cannot.
struct Orientation {
  std::vector<std::int8_t> signs;
  std::vector<Index> piece_of_cell;
  std::vector<NonOrientable> loops;  // one per non-orientable piece
  std::vector<bool> orientable;      // per piece
};

/// The loop that half-facet `h` closes in the tree of `entered_by`: down from the common ancestor
/// of both cells to the cell of h, through h, and back up from the mate's cell.
template <int D>
NonOrientable closed_loop(const std::vector<HalfFacetId>& mates,
                          const std::vector<HalfFacetId>& entered_by, HalfFacetId h) {
  // entered_by[c]: the half-facet, in the cell visited before c, through which c was reached.
  const auto path_to_root = [&](CellId cell) {
    std::vector<HalfFacetId> path;
    while (entered_by[cell.value].value != kNone) {
      path.push_back(entered_by[cell.value]);
      cell = cell_of<D>(path.back());
    }
    return path;
  };
  std::vector<HalfFacetId> down = path_to_root(cell_of<D>(h));
  std::vector<HalfFacetId> up = path_to_root(cell_of<D>(mates[h.value]));
  while (!down.empty() && !up.empty() && down.back() == up.back()) {
    down.pop_back();
    up.pop_back();
  }
  NonOrientable found;
  found.loop.assign(down.rbegin(), down.rend());
  found.loop.push_back(h);
  for (const HalfFacetId step : up) found.loop.push_back(mates[step.value]);
  return found;
}

/// How many sides of cells may be visited to shorten loops, per cell of the mesh and at least.
constexpr std::size_t kStepsPerCell = 32, kLeastSteps = 1'000'000;

/// Breadth first over each piece from its least cell. Every loop that no orientation is coherent
/// along crosses a facet whose cells' signs do not fit, so that a shortest one of the piece is a
/// shortest one through a cell at such a facet; these are searched as long as `kStepsPerCell`
/// lasts. Time: linear.
template <int D>
Orientation orientation(std::span<const Cell<D>> cells, const std::vector<HalfFacetId>& mates) {
  Orientation result;
  result.signs.assign(cells.size(), 0);
  result.piece_of_cell.assign(cells.size(), 0);
  std::vector<HalfFacetId> entered_by(cells.size(), HalfFacetId{kNone});
  std::vector<CellId> queue, at_conflicts;
  std::optional<OddLoops<D>> odd_loops;
  std::size_t steps = std::max(kLeastSteps, kStepsPerCell * cells.size());
  for (Index root = 0; root < cells.size(); ++root) {
    if (result.signs[root] != 0) continue;
    const auto piece = static_cast<Index>(result.orientable.size());
    result.orientable.push_back(true);
    result.signs[root] = 1;
    queue.assign(1, CellId{root});
    for (std::size_t next = 0; next < queue.size(); ++next) {
      const CellId cell = queue[next];
      result.piece_of_cell[cell.value] = piece;
      for (int i = 0; i <= D; ++i) {
        const HalfFacetId h = half_facet<D>(cell, i);
        const HalfFacetId mate = mates[h.value];
        if (mate.value == kNone) continue;
        const CellId across = cell_of<D>(mate);
        const bool same = opposite_as_written<D>(cells, h, mate);
        const auto wanted =
            static_cast<std::int8_t>(same ? result.signs[cell.value] : -result.signs[cell.value]);
        if (result.signs[across.value] == 0) {
          result.signs[across.value] = wanted;
          entered_by[across.value] = h;
          queue.push_back(across);
        } else if (result.signs[across.value] != wanted) {
          if (result.orientable[piece])
            result.loops.push_back(closed_loop<D>(mates, entered_by, h));
          result.orientable[piece] = false;
          at_conflicts.push_back(cell);  // and later the cell across
        }
      }
    }
    if (at_conflicts.empty()) continue;
    if (!odd_loops) odd_loops.emplace(cells, mates);
    for (const CellId cell : at_conflicts) odd_loops->shorten(cell, result.loops.back(), steps);
    at_conflicts.clear();
  }
  return result;
}

}  // namespace cleave::topology::detail
