#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

/// From a blade's path to a set of facets.
namespace cleave::cutting {

/// D coordinates, in the unit of the mesh (metres by convention).
template <int D>
using Point = std::array<double, static_cast<std::size_t>(D)>;

/// The surface a blade covered (D = 3: triangles) or the line a point covered (D = 2: segments), in
/// steps: what is swept between two positions of the blade. Rest coordinates of the mesh.
template <int D>
struct Sweep {
  std::vector<std::array<Point<D>, static_cast<std::size_t>(D)>> simplices;
  std::vector<std::uint32_t> step_of;  // step of each simplex, ascending; a number may be left out

  /// One more than the last step's number; 0 for an empty sweep.
  std::size_t step_count() const { return step_of.empty() ? 0 : step_of.back() + std::size_t{1}; }

  /// The simplices of step `k`, as [first, last) into `simplices`; empty where a number was left
  /// out. Time: logarithmic.
  std::pair<std::size_t, std::size_t> step(std::size_t k) const;
};

/// Throws std::invalid_argument unless each simplex has a step, steps ascend, and all coordinates
/// are finite; the message names the simplex. Time: linear.
template <int D>
void require_valid(const Sweep<D>& sweep);

/// A blade's successive positions, each its two ends: consecutive pairs (p0,q0), (p1,q1) span the
/// triangles (p0,q0,p1) and (q0,q1,p1), one step per pair. Fewer than two positions sweep nothing.
Sweep<3> sweep_of_blade(std::span<const std::array<Point<3>, 2>> positions);

/// A polyline in the plane, one step per segment. Fewer than two points sweep nothing.
Sweep<2> sweep_of_polyline(std::span<const Point<2>> points);

}  // namespace cleave::cutting
