#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "cleave/topology/cell_soup.hpp"

namespace cleave::topology {

/// How much work a computation of Betti numbers may be. Both are counts, not times, so that the
/// answer is the same on every machine.
struct BettiLimits {
  std::size_t simplices = SIZE_MAX;  // of all dimensions, each counted once
  std::uint64_t steps = UINT64_MAX;  // along gradient paths and in the matrices that remain
};

/// The ranks b_0 .. b_D of the homology groups over the field with two elements: b_0 connected
/// parts (through vertices), b_1 independent loops that bound no surface, b_2 voids (of a solid:
/// its cavities), .. Of any soup, valid or not; simplices are sets of vertices as in `summarize`,
/// and the alternating sum b_0 - b_1 + b_2 - .. is its Euler characteristic.
/// Nothing, if it would take more than `limits` allow. Throws std::length_error (too many cells).
/// Time: O(n log n) in the cells for what sorts them; then one step per simplex on the gradient
/// paths of the simplices that no collapse removes, of which a mesh with few holes has few. Memory:
/// about 40 bytes a simplex. Method: discrete Morse theory (Forman 1998): faces that are free are
/// collapsed, a simplex that blocks them all is kept as critical; the boundaries of the critical
/// simplices, followed along the gradient paths, have the homology of the whole.
template <int D>
std::optional<std::array<std::size_t, static_cast<std::size_t>(D) + 1>> betti_numbers(
    const CellSoup<D>& soup, BettiLimits limits = {});

}  // namespace cleave::topology
