#include "cleave/topology/pieces.hpp"

namespace cleave::topology {

template <int D>
Pieces pieces(const Complex<D>& k) {
  constexpr Index kUnreached = kNoIndex;
  Pieces found;
  found.of_cell.assign(k.cell_count(), kUnreached);
  std::vector<CellId> open;  // reached cells whose neighbours were not looked at yet
  for (Index first = 0; first < k.cell_count(); ++first) {
    if (found.of_cell[first] != kUnreached) continue;
    const auto piece = static_cast<Index>(found.count++);
    found.of_cell[first] = piece;
    open.push_back({first});
    while (!open.empty()) {
      const CellId cell = open.back();
      open.pop_back();
      for (int i = 0; i <= D; ++i) {
        const auto mate = k.mate(half_facet<D>(cell, i));
        if (!mate) continue;
        const CellId neighbour = cell_of<D>(*mate);
        if (found.of_cell[neighbour.value] != kUnreached) continue;
        found.of_cell[neighbour.value] = piece;
        open.push_back(neighbour);
      }
    }
  }
  return found;
}

template Pieces pieces(const Complex<1>&);
template Pieces pieces(const Complex<2>&);
template Pieces pieces(const Complex<3>&);
template Pieces pieces(const Complex<4>&);

}  // namespace cleave::topology
