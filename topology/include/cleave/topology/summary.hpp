#pragma once
#include <cstddef>
#include <cstdint>

#include "cleave/topology/cell_soup.hpp"

namespace cleave::topology {

/// Numbers that say what a body looks like.
struct Summary {
  std::size_t pieces = 0;
  std::size_t boundary_components = 0;
  std::int64_t euler_characteristic = 0;
  std::size_t simplices = 0;
};

/// Of any soup, valid or not. Simplices are sets of vertices: one that is named twice counts once.
/// pieces: cells connected through common facets, in however many cells these are.
/// boundary_components: the facets that are in exactly one cell, connected through common ridges;
/// for D = 1 facets are single vertices, and each is a component. euler_characteristic: the number
/// of 0-simplices minus that of 1-simplices plus .. of all distinct non-empty subsets of cells;
/// vertices that no cell uses do not count. simplices: the number of these subsets. Throws
/// std::length_error (too many cells). Time: linear in cells that are sound, different and at most
/// two at a facet, but for sorting boundary facets; O(n log n) in others.
template <int D>
Summary summarize(const CellView<D>& soup);
template <int D>
Summary summarize(const CellSoup<D>& soup) {
  return summarize(CellView<D>(soup));
}

}  // namespace cleave::topology
