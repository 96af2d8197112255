#pragma once
#include "cut_output.hpp"

namespace cleave::app {

/// Adds to output.mesh one cohesive element between the two sides of each facet of output.sides, in
/// the order of these, in the group NAME_cohesive of its name; numbers follow the largest number of
/// an element. Its first D vertices are on the minus side; the thickness goes from there to the
/// plus side, and the volume is positive when the sides move apart: see CohesiveElements. Vertices
/// that both sides share, at the tip of the cut, are in the element twice. Time: linear.
template <int D>
void add_cohesive(const Body<D>& body, CutOutput& output);

/// Throws InputError, with the reason, if no cohesive elements can be made in `mesh`: its cells are
/// edges, or of second order.
void require_cohesive(const Mesh& mesh);

}  // namespace cleave::app
