#pragma once
#include <array>
#include <cleave/support/meshes.hpp>
#include <cleave/support/rng.hpp>
#include <vector>

#include "cleave/cutting/select.hpp"
#include "cleave/cutting/sweep.hpp"
#include "cleave/topology/complex.hpp"

/// Bodies and sweeps for the tests of cutting.
namespace cleave::cutting::bodies {

using support::Rng;

template <int D>
struct Body {
  topology::Complex<D> k;
  std::vector<Point<D>> points;
  double spacing = 1;
  std::array<int, static_cast<std::size_t>(D)> nodes{};
};

/// A Kuhn grid with its points `spacing` apart, each coordinate a product of two doubles, moved at
/// random by up to `jitter` spacings.
template <int D>
Body<D> kuhn(std::array<int, static_cast<std::size_t>(D)> nodes, double spacing);
template <int D>
Body<D> jittered(std::array<int, static_cast<std::size_t>(D)> nodes, double spacing, double jitter,
                 Rng& rng);

/// The cells of `body` whose `keep` is true.
template <int D>
Body<D> part(const Body<D>& body, const std::vector<bool>& keep);

/// Some of the cells of `body` are gone: holes, several pieces.
template <int D>
Body<D> thinned(const Body<D>& body, double share, Rng& rng);

/// A small body of any of these kinds.
template <int D>
Body<D> any_small(Rng& rng);

/// The dual points of all cells.
template <int D>
std::vector<Point<D>> duals(const Body<D>& body);

/// A plane (line) that is aligned with the grid: normal . x = offset * spacing, with small integers
/// as normal, as a few steps; it covers the body.
template <int D>
Sweep<D> aligned_plane(const Body<D>& body, std::array<int, static_cast<std::size_t>(D)> normal,
                       double offset);

/// The rim is outside, the surface waves through the body in a few steps.
template <int D>
Sweep<D> full_crossing(const Body<D>& body, Rng& rng);

/// A blade's path (a polyline) that may begin, turn and stop anywhere in or near the body.
template <int D>
Sweep<D> any_path(const Body<D>& body, Rng& rng);

/// As any_path, by a blade about as short as an edge, that stays near one place.
template <int D>
Sweep<D> short_path(const Body<D>& body, Rng& rng);

/// Simplices that have nothing to do with each other, with corners on the grid, on vertices, on
/// dual points, or anywhere; some are flat.
template <int D>
Sweep<D> scattered(const Body<D>& body, Rng& rng);

/// Any of the above, and aligned planes at full, half and other steps of the grid.
template <int D>
Sweep<D> any_sweep(const Body<D>& body, Rng& rng);

/// The same path, and back again.
template <int D>
Sweep<D> there_and_back(const Sweep<D>& sweep);

}  // namespace cleave::cutting::bodies
