#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "cleave/topology/complex.hpp"

namespace cleave::topology {

/// The connected components of the dual graph: of_cell[c] in 0 .. count-1, numbered by least cell.
struct Pieces {
  std::size_t count = 0;
  std::vector<Index> of_cell;
};

/// In a cut-regular complex two cells that share a vertex are in one piece (T9), so a vertex is in
/// one piece as well. Time: linear.
template <int D>
Pieces pieces(const Complex<D>& k);

}  // namespace cleave::topology
