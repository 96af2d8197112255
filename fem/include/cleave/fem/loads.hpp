#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

#include "cleave/fem/body.hpp"
#include "cleave/topology/complex.hpp"
#include "cleave/topology/relabelling.hpp"

namespace cleave::fem {

/// A force on one vertex, in newtons.
struct NodalForce {
  topology::VertexId vertex;
  Eigen::Vector3d force;
};

/// A force per undeformed area on one boundary half-facet, in pascals; any direction.
struct Traction {
  topology::HalfFacetId half_facet;
  Eigen::Vector3d traction;
};

/// All loads of a body. Tractions and gravity belong to half-facets and cells, whose numbers never
/// change, so only nodal forces need to follow a cut.
struct Loads {
  std::vector<NodalForce> nodal;                      // forces on one vertex add up
  std::vector<Traction> tractions;                    // tractions on one half-facet add up
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();  // acceleration
  std::vector<double> density;  // mass per volume of each cell; may be empty if gravity is zero
};

/// `total` shared over the distinct vertices of `vertices` in proportion to the volumes of their
/// stars, as one force per vertex, ascending by vertex; the forces sum to `total`. Throws
/// std::invalid_argument if the set is empty, or names a vertex that does not exist or that no cell
/// uses. Time: linear in the stars.
std::vector<NodalForce> share_force(const topology::Complex<3>& k, Points points,
                                    std::span<const topology::VertexId> vertices,
                                    const Eigen::Vector3d& total);

/// The force vector of `loads`, 3 entries per vertex. A traction gives a third of area times
/// traction to each vertex of its half-facet, gravity a quarter of density times volume times
/// acceleration to each vertex of a cell (exact for linear tetrahedra). Throws
/// std::invalid_argument, naming the id, for a nodal force on a vertex that does not exist or that
/// no cell uses, a traction on a half-facet that is not boundary, and, with gravity, unless
/// `density` has one entry per cell, not negative and finite. A load that is not finite is passed
/// on as it is: the solver reports it. Time: linear.
Eigen::VectorXd force_vector(const topology::Complex<3>& k, Points points, const Loads& loads);

/// Follows a change of the complex: `k` and `points` are those after it. The nodal forces on a
/// vertex that split are shared by the star volumes of the vertex and its copies, their total is
/// kept; the forces on merged vertices add up. Time: the loads, and the stars of what split.
void carry_over(Loads& loads, const topology::Complex<3>& k, Points points,
                const topology::Relabelling& change);

}  // namespace cleave::fem
