#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "cleave/topology/ids.hpp"

namespace cleave::topology {

/// Anything a mesh file may hold: a list of cells and nothing promised about them.
/// `check` says what is wrong with it, `assemble` makes a Complex of it.
template <int D>
struct CellSoup {
  std::vector<Cell<D>> cells;

  /// Vertices are numbered 0 .. vertex_count-1; some may be used by no cell.
  std::size_t vertex_count = 0;

  /// Orientation of each cell relative to its tuple: +1 as written, -1 reversed. Empty: all +1.
  /// `orient` computes signs that make the cells coherent, so tuples never need to be reordered.
  std::vector<std::int8_t> signs;
};

/// A soup that somebody else holds, such as the arrays of a caller: nothing is copied. Valid as
/// long as what it shows.
template <int D>
class CellView {
 public:
  CellView(const CellSoup<D>& soup)  // NOLINT(google-explicit-constructor): a soup shows itself
      : cells(soup.cells), vertex_count(soup.vertex_count), signs(soup.signs) {}

  /// Of arrays: as the members of CellSoup.
  static CellView of(std::span<const Cell<D>> cells, std::size_t vertex_count,
                     std::span<const std::int8_t> signs = {}) {
    CellView view{CellSoup<D>{}};
    view.cells = cells;
    view.vertex_count = vertex_count;
    view.signs = signs;
    return view;
  }

  std::span<const Cell<D>> cells;
  std::size_t vertex_count;
  std::span<const std::int8_t> signs;
};

/// Throws std::length_error if `cells` cells of dimension `dimension`, or `vertices` vertices, do
/// not fit the ids (corners are numbered up to (dimension+1)*cells, in one bit less: it marks
/// half-facets without mate; of vertices the largest value is kept for "none"). Called by
/// everything that numbers corners.
void require_ids_suffice(int dimension, std::size_t cells, std::size_t vertices);

}  // namespace cleave::topology
