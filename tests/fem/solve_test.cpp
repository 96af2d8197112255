// The whole solve: accuracy against closed forms, and what it says about pieces and bad input.
#include "cleave/fem/solve.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <limits>

#include "bodies.hpp"
#include "cleave/fem/loads.hpp"

namespace cleave::fem {
namespace {

SolveResult solve_uniform(const Body& body, const Dirichlet& supports, const Eigen::VectorXd& force,
                          const SolveOptions& options = {}, const Eigen::VectorXd& start = {}) {
  return solve(body.k, body.points, uniform_operator(body, {1.5, 0.8}), supports, force, options,
               start);
}

Eigen::VectorXd no_force(const Body& body) {
  return Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(body.points.size()));
}

/// The unit cube, clamped below and pulled by its own weight sideways.
struct Loaded {
  explicit Loaded(int n) : body(distorted_cube(n, 0.2)) {
    supports = clamped(vertices_where(body, [](const Point& p) { return p[2] == 0.0; }));
    loads.gravity = {0.3, 0.1, 1.0};
    loads.density.assign(body.k.cell_count(), 1.0);
    force = force_vector(body.k, body.points, loads);
  }
  Body body;
  Dirichlet supports;
  Loads loads;
  Eigen::VectorXd force;
};

// Patch test: a linear displacement prescribed on the boundary is met everywhere.
TEST(Solve, PassesThePatchTestOnDistortedMeshes) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const Body body = distorted_cube(6, 0.25, seed);
    const Eigen::VectorXd exact = sample(body, [](const Point& p) {
      return Eigen::Vector3d(0.3 + 0.1 * p[0] - 0.4 * p[1] + 0.2 * p[2],
                             -1.0 + 0.5 * p[0] + 0.3 * p[1], 0.7 * p[1] - 0.2 * p[2]);
    });
    Dirichlet supports;
    for (const VertexId v : boundary_vertices(body.k))
      supports.prescribe(v, exact.segment<3>(3 * v.value));
    SolveOptions options;
    options.tolerance = 1e-13;
    const auto result = solve_uniform(body, supports, no_force(body), options);
    EXPECT_EQ(result.outcome, Outcome::converged);
    EXPECT_LE((result.displacement - exact).lpNorm<Eigen::Infinity>(),
              1e-12 * exact.lpNorm<Eigen::Infinity>());
  }
}

/// A smooth displacement, and the body force that makes it a solution for these Lamé parameters.
struct Manufactured {
  static constexpr double kLambda = 1.5, kMu = 0.8;
  static Eigen::Vector3d displacement(const Point& p) {
    return {std::sin(p[0] + 2.0 * p[1]), std::cos(2.0 * p[1] - p[2]), std::sin(p[0] + 3.0 * p[2])};
  }
  /// -mu Laplace(u) - (lambda + mu) grad(div(u))
  static Eigen::Vector3d force(const Point& p) {
    const double s = std::sin(p[0] + 2.0 * p[1]), t = std::sin(p[0] + 3.0 * p[2]);
    const double c = std::cos(2.0 * p[1] - p[2]);
    const Eigen::Vector3d laplacian(-5.0 * s, -5.0 * c, -10.0 * t);
    const Eigen::Vector3d grad_div(-s - 3.0 * t, -2.0 * s - 4.0 * c, 2.0 * c - 9.0 * t);
    return -kMu * laplacian - (kLambda + kMu) * grad_div;
  }
};

/// The integral of a body force against the hat functions, the force being linear on each cell.
Eigen::VectorXd consistent_load(const Body& body, Eigen::Vector3d (*density)(const Point&)) {
  Eigen::VectorXd f = no_force(body);
  for (topology::Index c = 0; c < body.k.cell_count(); ++c) {
    const double share = cell_volume(body.k, body.points, {c}) / 20.0;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const VertexId v : body.k.vertices({c})) sum += density(body.points[v.value]);
    for (const VertexId v : body.k.vertices({c}))
      f.segment<3>(3 * v.value) += share * (sum + density(body.points[v.value]));
  }
  return f;
}

/// The L2 norm of u_h - u by the four-point rule of degree 2 on each cell.
double l2_error(const Body& body, const Eigen::VectorXd& u) {
  constexpr double kNear = 0.5854101966249685, kFar = 0.1381966011250105;
  double squared = 0.0;
  for (topology::Index c = 0; c < body.k.cell_count(); ++c) {
    const auto& cell = body.k.vertices({c});
    const double weight = cell_volume(body.k, body.points, {c}) / 4.0;
    for (std::size_t near = 0; near < 4; ++near) {
      Point place{};
      Eigen::Vector3d value = Eigen::Vector3d::Zero();
      for (std::size_t i = 0; i < 4; ++i) {
        const double share = i == near ? kNear : kFar;
        for (std::size_t axis = 0; axis < 3; ++axis)
          place[axis] += share * body.points[cell[i].value][axis];
        value += share * u.segment<3>(3 * cell[i].value);
      }
      squared += weight * (value - Manufactured::displacement(place)).squaredNorm();
    }
  }
  return std::sqrt(squared);
}

TEST(Solve, ConvergesWithSecondOrderInL2) {
  std::vector<double> errors;
  for (const int edges : {4, 8, 16}) {
    const Body body = distorted_cube(edges + 1, 0.15);
    const Eigen::VectorXd exact = sample(body, Manufactured::displacement);
    Dirichlet supports;
    for (const VertexId v : boundary_vertices(body.k))
      supports.prescribe(v, exact.segment<3>(3 * v.value));
    const auto result = solve_uniform(body, supports, consistent_load(body, Manufactured::force));
    ASSERT_EQ(result.outcome, Outcome::converged);
    errors.push_back(l2_error(body, result.displacement));
  }
  for (std::size_t i = 1; i < errors.size(); ++i) {
    const double order = std::log2(errors[i - 1] / errors[i]);
    RecordProperty("order_" + std::to_string(i), std::to_string(order));
    EXPECT_GT(order, i == 1 ? 1.8 : 1.9) << i;
    EXPECT_LT(order, 2.1) << i;
  }
}

TEST(Solve, AgreesWithADirectSolver) {
  const Loaded scene(6);
  const auto k_operator = uniform_operator(scene.body, {1.5, 0.8});
  const Eigen::VectorXd expected = direct_solution(k_operator, scene.supports, scene.force);
  for (const auto preconditioner : {Preconditioner::jacobi, Preconditioner::none})
    for (const Norm norm : {Norm::residual, Norm::energy}) {
      SolveOptions options;
      options.preconditioner = preconditioner;
      options.norm = norm;
      const auto result =
          solve(scene.body.k, scene.body.points, k_operator, scene.supports, scene.force, options);
      EXPECT_EQ(result.outcome, Outcome::converged);
      EXPECT_LT((result.displacement - expected).norm(), 1e-6 * expected.norm());
      EXPECT_NEAR(result.energy_norm, std::sqrt(2.0 * k_operator.energy(expected)),
                  1e-7 * result.energy_norm);
      EXPECT_TRUE(result.findings.empty());
      EXPECT_EQ(result.piece_count, 1u);
      if (norm == Norm::energy) {
        EXPECT_LE(energy_distance(k_operator, result.displacement, expected),
                  1e-8 * result.energy_norm);
      }
    }
}

TEST(Solve, WarmStartSavesIterations) {
  const Loaded scene(6);
  const auto cold = solve_uniform(scene.body, scene.supports, scene.force);
  const auto warm =
      solve_uniform(scene.body, scene.supports, 1.001 * scene.force, {}, cold.displacement);
  EXPECT_EQ(warm.outcome, Outcome::converged);
  EXPECT_LT(warm.iterations(), cold.iterations());
  EXPECT_LT((warm.displacement - 1.001 * cold.displacement).norm(),
            1e-5 * cold.displacement.norm());
}

TEST(Solve, SupportsMovedAlikeMoveTheBodyWithThem) {
  const Loaded scene(4);
  Dirichlet supports;
  for (const VertexId v : vertices_where(scene.body, [](const Point& p) { return p[2] == 0.0; }))
    supports.prescribe(v, {1.0, 2.0, 3.0});
  SolveOptions options;
  options.tolerance = 1e-12;
  const auto result = solve_uniform(scene.body, supports, no_force(scene.body), options);
  EXPECT_EQ(result.outcome, Outcome::converged);
  const Eigen::VectorXd expected =
      sample(scene.body, [](const Point&) { return Eigen::Vector3d(1.0, 2.0, 3.0); });
  EXPECT_LT((result.displacement - expected).lpNorm<Eigen::Infinity>(), 1e-10);
}

TEST(Solve, EverythingPrescribedNeedsNoIteration) {
  const Body body = cube(3);
  const auto result = solve_uniform(
      body, clamped(vertices_where(body, [](const Point&) { return true; })), no_force(body));
  EXPECT_EQ(result.outcome, Outcome::converged);
  EXPECT_EQ(result.iterations(), 0u);
  EXPECT_EQ(result.displacement, no_force(body));
}

/// `Loaded`, cut in two: the upper piece has no supports.
struct CutInTwo : Loaded {
  CutInTwo() : Loaded(5) {
    const auto change = cut(body, facets_between(body, [](const Point& p) { return p[2] < 0.5; }));
    supports.carry_over(change);
    force = force_vector(body.k, body.points, loads);
  }
};

TEST(Solve, RefusesAFloatingPieceAndNamesIt) {
  const CutInTwo scene;
  const auto result = solve_uniform(scene.body, scene.supports, scene.force);
  EXPECT_EQ(result.outcome, Outcome::unsupported_piece);
  EXPECT_EQ(result.displacement.size(), 0);
  EXPECT_EQ(result.iterations(), 0u);
  EXPECT_EQ(result.piece_count, 2u);
  ASSERT_EQ(result.findings.size(), 1u);
  EXPECT_EQ(result.findings[0].unsupported.modes.cols(), 6);
  EXPECT_GT(centroid(scene.body, result.findings[0].unsupported.a_cell)[2], 0.5);
}

TEST(Solve, SolvesModuloFreeModesAndReportsTheLoadRemoved) {
  const CutInTwo scene;
  Eigen::VectorXd force = scene.force;
  const VertexId corner = vertices_where(scene.body, [](const Point& p) {
                            return p == Point{1.0, 1.0, 1.0};
                          }).at(0);
  force.segment<3>(3 * corner.value) += Eigen::Vector3d(0.0, 0.0, 2.0);
  SolveOptions options;
  options.on_unsupported = OnUnsupported::solve_modulo;
  options.tolerance = 1e-10;
  const auto k_operator = uniform_operator(scene.body, {1.5, 0.8});
  const auto result =
      solve(scene.body.k, scene.body.points, k_operator, scene.supports, force, options);
  ASSERT_EQ(result.outcome, Outcome::converged);
  ASSERT_EQ(result.findings.size(), 1u);
  const PieceFinding& finding = result.findings[0];
  double volume = 0.0;
  for (topology::Index c = 0; c < scene.body.k.cell_count(); ++c)
    if (centroid(scene.body, {c})[2] > 0.5)
      volume += cell_volume(scene.body.k, scene.body.points, {c});
  const Eigen::Vector3d weight = volume * scene.loads.gravity;
  EXPECT_LT((finding.removed_force - weight - Eigen::Vector3d(0, 0, 2)).norm(), 1e-12);
  const Eigen::Vector3d arm = Eigen::Vector3d(1, 1, 1) - finding.unsupported.centre;
  EXPECT_GT(finding.removed_moment.norm(), 0.5 * arm.cross(Eigen::Vector3d(0, 0, 2)).norm());

  // In equilibrium with the load that is left: K u - f is the removed load, which is that of a
  // rigid acceleration, so it is orthogonal to every deformation that leaves no rigid motion.
  Eigen::VectorXd missing;
  k_operator.apply(result.displacement, missing);
  missing -= force;
  const auto volumes = star_volumes(scene.body.k, scene.body.points);
  Eigen::MatrixXd modes(3 * static_cast<Eigen::Index>(finding.unsupported.vertices.size()), 6);
  Eigen::VectorXd acceleration(modes.rows()), moved(modes.rows());
  for (std::size_t i = 0; i < finding.unsupported.vertices.size(); ++i) {
    const VertexId v = finding.unsupported.vertices[i];
    const auto at = 3 * static_cast<Eigen::Index>(i);
    acceleration.segment<3>(at) = missing.segment<3>(3 * v.value) / volumes[v.value];
    moved.segment<3>(at) = volumes[v.value] * result.displacement.segment<3>(3 * v.value);
    for (Eigen::Index m = 0; m < 6; ++m)
      modes.block<3, 1>(at, m) = finding.unsupported.move(m, scene.body.points[v.value]);
  }
  const Eigen::VectorXd amounts = modes.colPivHouseholderQr().solve(acceleration);
  EXPECT_LT((modes * amounts - acceleration).norm(), 1e-6 * acceleration.norm());
  EXPECT_LT((modes.transpose() * moved).norm(), 1e-10 * moved.norm() * modes.norm());
}

TEST(Solve, AFreeBodyThatOnlyFallsDoesNotDeform) {
  const Loaded scene(4);
  SolveOptions options;
  options.on_unsupported = OnUnsupported::solve_modulo;
  const auto result = solve_uniform(scene.body, {}, scene.force, options);
  EXPECT_EQ(result.outcome, Outcome::converged);
  EXPECT_LT(result.displacement.norm(), 1e-12);
  EXPECT_LT((result.findings.at(0).removed_force - scene.loads.gravity).norm(), 1e-12);
}

TEST(Solve, IsDeterministic) {
  const Loaded scene(5);
  const auto one = solve_uniform(scene.body, scene.supports, scene.force);
  const auto other = solve_uniform(scene.body, scene.supports, scene.force);
  EXPECT_EQ(one.displacement, other.displacement);
  EXPECT_EQ(one.iterations(), other.iterations());
}

TEST(Solve, VerticesThatNoCellUsesStayAndBearNoForce) {
  const Body body = body_of({{VertexId{0}, {1}, {2}, {3}}},
                            {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {9, 9, 9}});
  const Dirichlet supports = clamped({VertexId{0}, {1}, {2}});
  Eigen::VectorXd force = no_force(body);
  force[11] = 1.0;
  const auto result = solve_uniform(body, supports, force, {}, Eigen::VectorXd::Ones(force.size()));
  EXPECT_EQ(result.outcome, Outcome::converged);
  EXPECT_EQ(Eigen::Vector3d(result.displacement.tail<3>()), Eigen::Vector3d::Zero().eval());
  force[12] = 1.0;
  EXPECT_THROW(solve_uniform(body, supports, force), std::invalid_argument);
}

TEST(Solve, PassesOnWhatEndsTheIteration) {
  const Loaded scene(5);
  SolveOptions options;
  options.max_iterations = 3;
  EXPECT_EQ(solve_uniform(scene.body, scene.supports, scene.force, options).outcome,
            Outcome::iteration_limit);
  options = {};
  options.tolerance = 1e-30;
  const auto stagnated = solve_uniform(scene.body, scene.supports, scene.force, options);
  EXPECT_EQ(stagnated.outcome, Outcome::stagnated);
  EXPECT_LT(stagnated.residual, 1e-12);
  Eigen::VectorXd force = scene.force;
  force[100] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(solve_uniform(scene.body, scene.supports, force).outcome, Outcome::not_finite);
}

TEST(Solve, RefusesWhatDoesNotFit) {
  const Loaded scene(3);
  Body changed = scene.body;
  const auto k_operator = uniform_operator(scene.body, {1.0, 1.0});
  EXPECT_THROW(solve_uniform(scene.body, scene.supports, Eigen::VectorXd::Zero(6)),
               std::invalid_argument);
  EXPECT_THROW(solve_uniform(scene.body, scene.supports, scene.force, {}, Eigen::VectorXd::Zero(6)),
               std::invalid_argument);
  Dirichlet beyond;
  beyond.prescribe(VertexId{1000}, 0, 0.0);
  SolveOptions modulo;
  modulo.on_unsupported = OnUnsupported::solve_modulo;
  EXPECT_THROW(solve_uniform(scene.body, beyond, scene.force, modulo), std::invalid_argument);
  cut(changed, topology::FacetSet::all(changed.k));
  EXPECT_THROW(solve(changed.k, changed.points, k_operator, scene.supports, scene.force),
               std::invalid_argument);  // the operator was not told of the cut
}

}  // namespace
}  // namespace cleave::fem
