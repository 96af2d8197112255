#pragma once
#include <vector>

#include "finding.hpp"

namespace cleave::app {

/// Vertices of `mesh` that have the same coordinates, or are joined by steps of at most `distance`,
/// one finding (rule coincident-vertices) per place, by the least vertex. Only vertices of cells
/// count, nodes of second order too, if their coordinates are finite.
/// Such vertices are a note instead of a warning where the file shows that a cut made them: all are
/// on facets of groups NAME_minus and NAME_plus, or ends of cohesive elements, or have the same
/// value of the point field `parent`, or the same origin in the record that `cleave cut` leaves
/// beside its output. Time: O(n log n); of a distance much larger than the spacing of the vertices
/// O(n) more per neighbour.
std::vector<Finding> check_coincident(const Mesh& mesh, double distance);

}  // namespace cleave::app
