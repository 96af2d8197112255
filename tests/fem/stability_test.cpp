// Stiff and extreme cases: each with the right typed outcome, and the right answer where it
// converges (against a sparse Cholesky factorisation).
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "bodies.hpp"
#include "cleave/fem/loads.hpp"
#include "cleave/fem/solve.hpp"

namespace cleave::fem {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// Solves by the energy estimate, in at most so many iterations, and compares with the direct
/// solution.
void expect_solved(const Scene& scene, const ElasticOperator& k_operator, std::size_t most) {
  SolveOptions options;
  options.tolerance = 1e-6;
  options.norm = Norm::energy;
  options.max_iterations = 20000;
  const auto result =
      solve(scene.body.k, scene.body.points, k_operator, scene.supports, scene.force, options);
  EXPECT_EQ(name(result.outcome), name(Outcome::converged));
  const Eigen::VectorXd expected = direct_solution(k_operator, scene.supports, scene.force);
  EXPECT_LE(energy_distance(k_operator, result.displacement, expected), 1e-6 * result.energy_norm);
  EXPECT_LE(result.iterations(), most);
  testing::Test::RecordProperty("iterations", std::to_string(result.iterations()));
}

struct Case {
  double poisson;
  std::size_t most_iterations;
};
class NearlyIncompressible : public testing::TestWithParam<Case> {};

TEST_P(NearlyIncompressible, IsSolved) {
  const Scene scene = under_its_weight(distorted_cube(6, 0.2));
  const auto k_operator = uniform_operator(scene.body, lame_of(1.0, GetParam().poisson));
  expect_solved(scene, k_operator, GetParam().most_iterations);
}

INSTANTIATE_TEST_SUITE_P(Stability, NearlyIncompressible,
                         testing::Values(Case{0.3, 120}, Case{0.49, 350}, Case{0.499, 850}));

TEST(Stability, StiffLayersAMillionTimesSofterOnesAreSolved) {
  const Scene scene = under_its_weight(distorted_cube(7, 0.2));
  const ElasticOperator k_operator(scene.body.k, scene.body.points,
                                   layered(scene.body, 6, lame_of(1.0, 0.3), lame_of(1e6, 0.3)));
  expect_solved(scene, k_operator, 1500);
}

TEST(Stability, AStiffInclusionAMillionTimesItsSurroundingsIsSolved) {
  const Scene scene = under_its_weight(distorted_cube(7, 0.2));
  Materials materials{{lame_of(1.0, 0.3), lame_of(1e6, 0.3)}, {}};
  for (topology::Index c = 0; c < scene.body.k.cell_count(); ++c) {
    const Point p = centroid(scene.body, {c});
    const double squared =
        (p[0] - 0.5) * (p[0] - 0.5) + (p[1] - 0.5) * (p[1] - 0.5) + (p[2] - 0.5) * (p[2] - 0.5);
    materials.of_cell.push_back(squared < 0.09);
  }
  const ElasticOperator k_operator(scene.body.k, scene.body.points, materials);
  expect_solved(scene, k_operator, 400);
}

/// The cube with one cell split in four by a vertex that sees its first facet at `degrees`.
Body with_sliver(int n, double degrees) {
  const Body whole = cube(n);
  const auto k_cells = whole.k.cells();
  std::vector<topology::Cell<3>> cells(k_cells.begin(), k_cells.end());
  std::vector<Point> points = whole.points;
  const std::size_t pierced = cells.size() / 2;
  const topology::Cell<3> cell = cells[pierced];
  std::array<Eigen::Vector3d, 4> x;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t axis = 0; axis < 3; ++axis)
      x[i][static_cast<Eigen::Index>(axis)] = points[cell[i].value][axis];
  // Above the incentre of the triangle (x1, x2, x3) all three dihedral angles are equal.
  const double a = (x[2] - x[3]).norm(), b = (x[3] - x[1]).norm(), c = (x[1] - x[2]).norm();
  const Eigen::Vector3d incentre = (a * x[1] + b * x[2] + c * x[3]) / (a + b + c);
  Eigen::Vector3d normal = (x[2] - x[1]).cross(x[3] - x[1]);
  const double radius = normal.norm() / (a + b + c);
  normal.normalize();
  if (normal.dot(x[0] - x[1]) < 0.0) normal = -normal;
  const double height = radius * std::tan(degrees * kPi / 180.0);
  const Eigen::Vector3d apex = incentre + height * normal;
  const VertexId added{static_cast<topology::Index>(points.size())};
  points.push_back({apex[0], apex[1], apex[2]});
  cells.erase(cells.begin() + static_cast<std::ptrdiff_t>(pierced));
  for (std::size_t i = 0; i < 4; ++i) {
    topology::Cell<3> part = cell;
    part[i] = added;
    cells.push_back(part);
  }
  return body_of(std::move(cells), std::move(points));
}

/// The least angle between two facets of a cell, in degrees.
double least_dihedral_angle(const Body& body, CellId cell) {
  std::array<Eigen::Vector3d, 4> x;
  for (std::size_t i = 0; i < 4; ++i)
    x[i] = Eigen::Vector3d(body.points[body.k.vertices(cell)[i].value].data());
  double least = kPi;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const std::size_t k = (i + 1) % 4 == j ? (i + 2) % 4 : (i + 1) % 4, l = 6 - i - j - k;
      const Eigen::Vector3d edge = x[j] - x[i];
      const Eigen::Vector3d one = edge.cross(x[k] - x[i]), other = edge.cross(x[l] - x[i]);
      least = std::min(least, std::atan2(one.cross(other).norm(), one.dot(other)));
    }
  return least * 180.0 / kPi;
}

TEST(Stability, ASliverOfATenthOfADegreeIsSolved) {
  const Scene scene = under_its_weight(with_sliver(5, 0.1));
  const auto k_operator = uniform_operator(scene.body, lame_of(1.0, 0.3));
  double least = 180.0;
  for (topology::Index c = 0; c < scene.body.k.cell_count(); ++c)
    least = std::min(least, least_dihedral_angle(scene.body, {c}));
  EXPECT_NEAR(least, 0.1, 1e-9);
  expect_solved(scene, k_operator, 110);
}

// Without its hinge line's rotation the body is solved; the load that would turn it is reported.
TEST(Stability, APieceHeldAtThreeCollinearVerticesKeepsOneRotation) {
  Scene scene = under_its_weight(distorted_cube(5, 0.2));
  scene.supports = clamped(vertices_where(scene.body, [](const Point& p) {
    return p[1] == 0.0 && p[2] == 0.0 && (p[0] == 0.0 || p[0] == 0.5 || p[0] == 1.0);
  }));
  const auto k_operator = uniform_operator(scene.body, lame_of(1.0, 0.3));
  SolveOptions options;
  const auto refused =
      solve(scene.body.k, scene.body.points, k_operator, scene.supports, scene.force, options);
  EXPECT_EQ(refused.outcome, Outcome::unsupported_piece);
  ASSERT_EQ(refused.findings.size(), 1u);
  EXPECT_EQ(refused.findings[0].unsupported.modes.cols(), 1);

  options.on_unsupported = OnUnsupported::solve_modulo;
  const auto result =
      solve(scene.body.k, scene.body.points, k_operator, scene.supports, scene.force, options);
  EXPECT_EQ(result.outcome, Outcome::converged);
  EXPECT_GT(result.findings.at(0).removed_moment.norm(), 0.1);
  for (const auto& [coordinate, value] : scene.supports.values())
    EXPECT_EQ(result.displacement[static_cast<Eigen::Index>(coordinate)], 0.0);
}

TEST(Stability, OneTwoAndNoHeldVerticesAreSolvedModuloWhatTheyLeaveFree) {
  Scene scene = under_its_weight(distorted_cube(5, 0.2));
  const auto k_operator = uniform_operator(scene.body, lame_of(1.0, 0.3));
  SolveOptions options;
  options.on_unsupported = OnUnsupported::solve_modulo;
  std::vector<VertexId> held;
  const auto corners = vertices_where(scene.body, [](const Point& p) {
    return (p[0] == 0.0 || p[0] == 1.0) && p[1] == 0.0 && p[2] == 0.0;
  });
  ASSERT_EQ(corners.size(), 2u);
  for (const Eigen::Index free : {6, 3, 1}) {
    const auto result =
        solve(scene.body.k, scene.body.points, k_operator, clamped(held), scene.force, options);
    EXPECT_EQ(name(result.outcome), name(Outcome::converged)) << free;
    EXPECT_EQ(result.findings.at(0).unsupported.modes.cols(), free);
    if (held.size() < 2) held.push_back(corners[held.size()]);
  }
}

// Units: a body of nanometres or of gigametres, soft or stiff, takes the same iterations.
TEST(Stability, UnitsDoNotMatter) {
  std::vector<std::size_t> iterations;
  for (const double length : {1e-9, 1.0, 1e9})
    for (const double young : {1e-6, 1.0, 1e12}) {
      Scene scene = under_its_weight(distorted_cube(5, 0.2));
      for (Point& p : scene.body.points)
        for (double& x : p) x *= length;
      const auto k_operator = uniform_operator(scene.body, lame_of(young, 0.3));
      const auto result =
          solve(scene.body.k, scene.body.points, k_operator, scene.supports, scene.force);
      EXPECT_EQ(name(result.outcome), name(Outcome::converged)) << length << ' ' << young;
      iterations.push_back(result.iterations());
    }
  EXPECT_LE(*std::max_element(iterations.begin(), iterations.end()),
            *std::min_element(iterations.begin(), iterations.end()) + 2);
}

}  // namespace
}  // namespace cleave::fem
