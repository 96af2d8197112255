#pragma once
#include <array>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "cleave/cutting/select.hpp"
#include "cleave/topology/ids.hpp"

/// What cutting decides, decided again by rational numbers (made integers by a common denominator),
/// and by series in e where the sweep is translated by (e, e^2, e^3). Slow and straight from the
/// definitions: no filter, no search, and crossings by intersection points where the library
/// compares signs of determinants.
namespace cleave::cutting::rational {

template <int D>
using Simplex = std::array<Point<D>, static_cast<std::size_t>(D)>;

/// The sign of the determinant of corners[i] - corners[0].
template <int D>
int orient(const std::array<Point<D>, static_cast<std::size_t>(D) + 1>& corners);

template <int D>
bool is_flat(const Simplex<D>& simplex);

/// The side of `p`, the simplex translated.
template <int D>
int side(const Simplex<D>& simplex, const Point<D>& p);

/// Whether pq crosses the translated simplex, which is not flat.
template <int D>
bool crosses(const Simplex<D>& simplex, const Point<D>& p, const Point<D>& q);

/// The sign of |height of p| - |height of q| over the simplex where it is.
template <int D>
int compare_heights(const Simplex<D>& simplex, const Point<D>& p, const Point<D>& q);

/// The interior facets (lesser half-facets, ascending) whose dual edges cross an odd number of
/// simplices: all facets against all simplices. `duals` has one point per cell.
template <int D>
std::vector<topology::HalfFacetId> dual_edge(std::span<const topology::Cell<D>> cells,
                                             const std::vector<Point<D>>& duals,
                                             std::span<const Simplex<D>> simplices);

/// Edges (lesser vertex first) that some simplex crosses, each with its end closest to a crossing.
using ClosestEnds =
    std::set<std::pair<std::pair<topology::VertexId, topology::VertexId>, topology::VertexId>>;

/// All edges against all simplices.
template <int D>
ClosestEnds closest_ends(std::span<const topology::Cell<D>> cells,
                         const std::vector<Point<D>>& points, std::span<const Simplex<D>> simplices,
                         Ties ties);

/// The interior facets that cells with exactly D of their vertices among the ends of their edges
/// select.
template <int D>
std::vector<topology::HalfFacetId> nearest_vertex(std::span<const topology::Cell<D>> cells,
                                                  const ClosestEnds& ends);

}  // namespace cleave::cutting::rational
