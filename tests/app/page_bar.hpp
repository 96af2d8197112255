#pragma once
#include "page.hpp"

namespace cleave::app {

/// A bar of 16 x 4 x 4 cubes of 10 mm, six cells each (1536 cells), cut across its middle: at rest;
/// cut from the top to the middle; the same under a load that opens the cut; cut through, with two
/// pieces apart. The half cut scores one facet near the bottom as well, which stays shut.
PageData bar_cut_in_two();

/// The bar at rest alone: no cut, material, displacement, finding or solve.
PageData bar_at_rest();

/// Numbers of what the states of the bar should show.
inline constexpr std::size_t kBarCells = 1536, kBarSkin = 2 * (2 * 4 * 4 + 4 * 4 * 16),
                             kBarHalfCut = 16, kBarFullCut = 32;

}  // namespace cleave::app
