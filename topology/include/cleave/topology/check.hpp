#pragma once
#include <cstdint>
#include <variant>
#include <vector>

#include "cleave/topology/cell_soup.hpp"
#include "cleave/topology/violation.hpp"

namespace cleave::topology {

/// All violations of `soup` up to `level`, and every orphan vertex, ordered by kind, then by id.
/// Later kinds are looked for only where they have a meaning: orientation and stars once cells are
/// sound (no degenerate cell, no vertex out of range), and no facet is in three cells.
/// At most one NonOrientable is reported per piece. Throws std::length_error (too many cells),
/// std::invalid_argument (signs that are not one per cell, each +1 or -1). Time: linear; for D = 4
/// edge_regular sorts the edges and triangles around each vertex, and so it is for D = 3 around
/// vertices that are in doubt. Memory beyond the soup, D = 3, where nothing is wrong and the cells
/// are in mesh order: 25 bytes per cell.
template <int D>
std::vector<Violation> check(const CellView<D>& soup, Level level = Level::manifold);
template <int D>
std::vector<Violation> check(const CellSoup<D>& soup, Level level = Level::manifold) {
  return check(CellView<D>(soup), level);
}

/// The highest level the violations leave standing; `violations` from check(soup, Level::manifold).
/// For D = 4 the manifold level is not decided, and edge_regular is the highest answer.
Level level_reached(int dimension, const std::vector<Violation>& violations);

/// Signs (one per cell, +1 or -1; those of `soup` do not matter) that make mates opposite; the
/// first cell of each piece gets +1. If there are none: a loop of cells that anyone can re-check.
/// Requires sound cells and no facet in three cells; throws InvalidComplex otherwise. Time: linear.
template <int D>
std::variant<std::vector<std::int8_t>, NonOrientable> orient(const CellView<D>& soup);
template <int D>
std::variant<std::vector<std::int8_t>, NonOrientable> orient(const CellSoup<D>& soup) {
  return orient(CellView<D>(soup));
}

}  // namespace cleave::topology
