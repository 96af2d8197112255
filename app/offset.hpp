#pragma once
#include "cleave/topology/incision.hpp"
#include "cut_output.hpp"

namespace cleave::app {

/// Moves the points of the two sides of every opened facet apart, so that a picture shows the cut:
/// a vertex goes by distance / 2 along the mean of the unit normals, pointing into their cells, of
/// the opened half-facets that have it. A vertex that both sides of such a facet share, at the tip
/// of the cut, stays. Nodes of second order go with the middle of their edge. Fills output.moved;
/// nothing but output.mesh.points changes. A cell that is turned inside out by that (D = 3, or D =
/// 2 in a plane z = constant; exact) gives a warning, which says how far one may go.
/// `distance` is in units of the mesh, finite, not negative. Time: linear in the cells.
template <int D>
void move_sides(const Body<D>& body, const topology::Incision<D>& incision, double distance,
                CutOutput& output);

}  // namespace cleave::app
