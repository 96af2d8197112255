#pragma once
#include <stdexcept>
#include <string>
#include <vector>

#include "cleave/topology/cell_soup.hpp"
#include "cleave/topology/violation.hpp"

namespace cleave::topology::detail {

/// Throws std::invalid_argument unless there are no signs, or one per cell, each +1 or -1.
template <int D>
void require_signs(const CellView<D>& soup) {
  if (soup.signs.empty()) return;
  if (soup.signs.size() != soup.cells.size())
    throw std::invalid_argument("there are " + std::to_string(soup.signs.size()) + " signs for " +
                                std::to_string(soup.cells.size()) + " cells");
  for (std::size_t c = 0; c < soup.signs.size(); ++c)
    if (soup.signs[c] != 1 && soup.signs[c] != -1)
      throw std::invalid_argument("the sign of cell " + std::to_string(c) + " is " +
                                  std::to_string(soup.signs[c]) + ", not +1 or -1");
}

/// Degenerate cells and vertices out of range, in order of cells.
template <int D>
std::vector<Violation> unsound_cells(const CellView<D>& soup) {
  std::vector<Violation> found;
  for (Index c = 0; c < soup.cells.size(); ++c) {
    const Cell<D>& cell = soup.cells[c];
    for (std::size_t i = 0; i < cell.size(); ++i) {
      if (cell[i].value >= soup.vertex_count) found.push_back(VertexOutOfRange{CellId{c}, cell[i]});
      for (std::size_t j = i + 1; j < cell.size(); ++j)
        if (cell[i] == cell[j]) found.push_back(DegenerateCell{CellId{c}, cell[i]});
    }
  }
  return found;
}

}  // namespace cleave::topology::detail
