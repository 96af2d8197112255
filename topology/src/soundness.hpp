#pragma once
#include <vector>

#include "cleave/topology/cell_soup.hpp"
#include "cleave/topology/violation.hpp"

namespace cleave::topology::detail {

/// Degenerate cells and vertices out of range, in order of cells.
template <int D>
std::vector<Violation> unsound_cells(const CellSoup<D>& soup) {
  std::vector<Violation> found;
  for (std::uint32_t c = 0; c < soup.cells.size(); ++c) {
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
