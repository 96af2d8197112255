#pragma once
#include <Eigen/Core>

#include "cleave/fem/body.hpp"
#include "cleave/topology/complex.hpp"
#include "cleave/topology/relabelling.hpp"

namespace cleave::fem {

/// Makes a displacement, 3 entries per vertex in the unit of the points, follow a change of the
/// complex: `k` and `points` are those after it. A copy is displaced as its parent was; vertices
/// that are merged take the mean of their displacements, weighted by the volumes of their stars
/// before. Throws std::invalid_argument unless `u` has 3 change.vertices_before entries and there
/// is one point per vertex. Time: the length of `u` if it changes, the renamed corners, and the
/// stars of the vertices that others are merged into.
void carry_over(Eigen::VectorXd& u, const topology::Complex<3>& k, Points points,
                const topology::Relabelling& change);

}  // namespace cleave::fem
