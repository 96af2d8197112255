#pragma once
#include <Eigen/Core>
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "cleave/fem/body.hpp"
#include "cleave/fem/dirichlet.hpp"
#include "cleave/fem/elastic_operator.hpp"
#include "cleave/support/rng.hpp"
#include "cleave/topology/complex.hpp"
#include "cleave/topology/facet_set.hpp"
#include "cleave/topology/relabelling.hpp"

/// Bodies, cuts and small helpers for the tests of this folder.
namespace cleave::fem {

using topology::CellId;
using topology::Complex;
using topology::HalfFacetId;
using topology::VertexId;
using Point = std::array<double, 3>;

/// A complex with its points and a label per cell.
struct Body {
  Complex<3> k;
  std::vector<Point> points;
  std::vector<std::uint32_t> labels;
};

/// The body of these cells; orients them and splits vertices that are not cut-regular.
Body body_of(std::vector<topology::Cell<3>> cells, std::vector<Point> points);

/// The unit cube in Kuhn's subdivision with `n` vertices along each axis.
Body cube(int n);

/// The unit cube with its inner vertices moved by up to `amount` of an edge, the same for every
/// run.
Body distorted_cube(int n, double amount, std::uint64_t seed = 1);

/// A random part of a distorted cube: holes, several pieces, vertices split where they were
/// pinched.
Body random_body(support::Rng& rng);

/// A body from a Medit file that holds vertices, triangles and tetrahedra, as the one in data/
/// does.
Body medit_body(const std::string& path);

/// `layers` layers of equal height across the unit cube: these two materials in turn.
Materials layered(const Body& body, int layers, const Lame& even, const Lame& odd);

/// A body clamped at z = 0 under its own weight, which pulls a little sideways too.
struct Scene {
  Body body;
  Dirichlet supports;
  Eigen::VectorXd force;
};
Scene under_its_weight(Body body);

/// The interior facets between cells whose centroids `chosen` tells apart.
topology::FacetSet facets_between(const Body& body,
                                  const std::function<bool(const Point&)>& chosen);

/// Each interior facet with one random probability.
topology::FacetSet random_cut(const Complex<3>& k, support::Rng& rng);

/// Cuts the body; its points follow.
topology::Relabelling cut(Body& body, const topology::FacetSet& facets);

/// The vertices whose point `chosen` chooses.
std::vector<VertexId> vertices_where(const Body& body,
                                     const std::function<bool(const Point&)>& chosen);

/// All three coordinates of these vertices, at rest.
Dirichlet clamped(const std::vector<VertexId>& vertices);

/// The vertices of boundary half-facets.
std::vector<VertexId> boundary_vertices(const Complex<3>& k);

Point centroid(const Body& body, CellId cell);

ElasticOperator uniform_operator(const Body& body, const Lame& material);

/// 3 entries per vertex: value(point) at each.
Eigen::VectorXd sample(const Body& body, const std::function<Eigen::Vector3d(const Point&)>& value);

/// Entries between -1 and 1.
Eigen::VectorXd random_vector(Eigen::Index size, support::Rng& rng);

/// The six rigid modes of a body about the middle of the unit cube, as columns.
Eigen::MatrixXd rigid_modes_of(const Body& body);

/// K u = force with supports, by a sparse Cholesky factorisation.
Eigen::VectorXd direct_solution(const ElasticOperator& k_operator, const Dirichlet& supports,
                                const Eigen::VectorXd& force);

}  // namespace cleave::fem
