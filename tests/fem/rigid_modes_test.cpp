#include "cleave/fem/rigid_modes.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Eigenvalues>

#include "bodies.hpp"
#include "cleave/fem/stiffness.hpp"

namespace cleave::fem {
namespace {

std::vector<UnsupportedPiece> analyse(const Body& body, const Dirichlet& supports) {
  return unsupported_pieces(body.k, body.points, topology::pieces(body.k), supports);
}

/// The number of free modes of a body in one piece, held at these vertices.
Eigen::Index free_modes(const Body& body, const std::vector<VertexId>& held) {
  const auto found = analyse(body, clamped(held));
  return found.empty() ? 0 : found.at(0).modes.cols();
}

VertexId at(const Body& body, const Point& place) {
  return vertices_where(body, [&](const Point& p) { return p == place; }).at(0);
}

TEST(FreeRigidModes, OfABodyHeldAtFewVertices) {
  const Body body = cube(3);
  const VertexId a = at(body, {0, 0, 0}), b = at(body, {1, 0, 0}), c = at(body, {0, 1, 0});
  const VertexId middle = at(body, {0.5, 0, 0});
  EXPECT_EQ(free_modes(body, {}), 6);
  EXPECT_EQ(free_modes(body, {a}), 3);
  EXPECT_EQ(free_modes(body, {a, b}), 1);
  EXPECT_EQ(free_modes(body, {a, middle, b}), 1);  // collinear: five of six are held
  EXPECT_EQ(free_modes(body, {a, b, c}), 0);
}

TEST(FreeRigidModes, OfSingleCoordinates) {
  const Body body = cube(3);
  Dirichlet supports;  // rollers on three faces: nothing moves
  for (topology::Index v = 0; v < body.points.size(); ++v)
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (body.points[v][axis] == 0.0) supports.prescribe({v}, static_cast<int>(axis), 0.0);
  EXPECT_TRUE(analyse(body, supports).empty());

  Dirichlet floor;  // a roller floor: slides along x and y, and turns about z
  for (const VertexId v : vertices_where(body, [](const Point& p) { return p[2] == 0.0; }))
    floor.prescribe(v, 2, 0.0);
  const auto found = analyse(body, floor);
  ASSERT_EQ(found.size(), 1u);
  ASSERT_EQ(found[0].modes.cols(), 3);
  for (Eigen::Index m = 0; m < 3; ++m)
    EXPECT_NEAR(found[0].move(m, {0.3, 0.8, 0.0})[2], 0.0, 1e-14);
}

// The last mode of a body held on a line is the rotation about it.
TEST(FreeRigidModes, NamesTheRotationAboutALine) {
  const Body body = cube(3);
  const auto found =
      analyse(body, clamped({at(body, {0, 0, 0}), at(body, {0.5, 0, 0}), at(body, {1, 0, 0})}));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_LT(found[0].move(0, {0.7, 0.0, 0.0}).norm(), 1e-12);
  const Eigen::Vector3d moved = found[0].move(0, {0.7, 1.0, 0.0});
  EXPECT_GT(std::abs(moved[2]), 0.1);
  EXPECT_LT(moved.head<2>().norm(), 1e-12);
  EXPECT_EQ(describe(found[0]),
            "piece 0 (cell 0 and the cells connected to it): 1 of its 6 rigid motions are free");
}

// Where the body lies and how large it is does not matter.
TEST(FreeRigidModes, AreFoundFarFromTheOriginAndInAnyUnit) {
  const double root = std::sqrt(0.5);
  for (const double scale : {1e-6, 1.0, 1e6})
    for (const double shift : {0.0, 1000.0}) {
      Body body = cube(3);
      const std::vector<VertexId> line{at(body, {0, 0, 0}), at(body, {0.5, 0.5, 0}),
                                       at(body, {1, 1, 0})};
      for (Point& p : body.points)
        p = {scale * (root * (p[0] - p[2]) + shift), scale * (p[1] + shift),
             scale * (root * (p[0] + p[2]))};
      EXPECT_EQ(free_modes(body, line), 1) << scale << ' ' << shift;
    }
}

TEST(FreeRigidModes, AreFoundPerPiece) {
  Body body = cube(4);
  Dirichlet supports = clamped(vertices_where(body, [](const Point& p) { return p[0] == 0.0; }));
  EXPECT_TRUE(analyse(body, supports).empty());
  supports.carry_over(
      cut(body, facets_between(body, [](const Point& p) { return p[0] < 1.0 / 3.0; })));
  const auto found = analyse(body, supports);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].modes.cols(), 6);
  EXPECT_EQ(found[0].vertices.size(), 48u);
  EXPECT_GT(centroid(body, found[0].a_cell)[0], 1.0 / 3.0);
}

// T9 in numbers: the free modes counted are the zero eigenvalues of K on the free coordinates.
RC_GTEST_PROP(FreeRigidModesProperty, AreTheNullSpaceOfK, (std::uint64_t seed)) {
  support::Rng rng(seed);
  const int n = rng.between(2, 3);
  Body body = distorted_cube(n, 0.15, rng.next());
  cut(body, random_cut(body.k, rng));
  Dirichlet supports;
  const double density = 0.2 * rng.unit();
  for (const VertexId v : vertices_where(body, [](const Point&) { return true; }))
    for (int axis = 0; axis < 3; ++axis)
      if (rng.chance(density)) supports.prescribe(v, axis, 0.0);
  Eigen::Index counted = 0;
  for (const auto& piece : analyse(body, supports)) counted += piece.modes.cols();

  Eigen::MatrixXd k = assemble_stiffness(uniform_operator(body, {1.0, 1.0}));
  for (const auto& [coordinate, value] : supports.values()) {
    const auto i = static_cast<Eigen::Index>(coordinate);
    k.row(i).setZero();
    k.col(i).setZero();
    k(i, i) = 1.0;
  }
  const Eigen::VectorXd values =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(k, Eigen::EigenvaluesOnly).eigenvalues();
  RC_ASSERT((values.array() < 1e-11 * values.maxCoeff()).count() == counted);
  RC_CLASSIFY(counted == 0, "all held");
}

}  // namespace
}  // namespace cleave::fem
