#pragma once
#include "choices.hpp"
#include "cleave/topology/cell_soup.hpp"

namespace cleave::fuzz {

/// A small soup (some 30 cells, 50 for D = 4) that `choices` decide: tuples of arbitrary numbers
/// (degenerate, out of range, repeated, crowded), or some of the cells of a grid, a torus or a cone
/// over a grid, their tuples in any order, with some vertices made one. Signs, if any, are
/// arbitrary.
template <int D>
topology::CellSoup<D> soup_of(Choices& choices);

}  // namespace cleave::fuzz
