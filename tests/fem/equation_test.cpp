// Equation (1) of the paper: as printed, as mended, and as the operator applies it.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <functional>

#include "bodies.hpp"
#include "cleave/fem/stiffness.hpp"

namespace cleave::fem {
namespace {

const Lame kMaterial{1.3, 0.7};

/// One cell of no particular shape.
Body one_cell() {
  return body_of({{VertexId{0}, {1}, {2}, {3}}},
                 {{0.0, 0.0, 0.0}, {1.0, 0.2, 0.1}, {0.3, 0.9, -0.2}, {0.1, 0.4, 1.1}});
}

/// The forces (F1|F2|F3) of one cell as a function of E, the volume and X^-T.
using ForceLaw =
    std::function<Eigen::Matrix3d(const Eigen::Matrix3d&, double, const Eigen::Matrix3d&)>;

Eigen::Matrix3d printed(const Eigen::Matrix3d& e, double volume, const Eigen::Matrix3d& x_inv_t) {
  return volume * x_inv_t *
         (2.0 * kMaterial.mu * e + kMaterial.lambda * e.trace() * Eigen::Matrix3d::Identity());
}

Eigen::Matrix3d mended(const Eigen::Matrix3d& e, double volume, const Eigen::Matrix3d& x_inv_t) {
  const Eigen::Matrix3d strain = 0.5 * (e + e.transpose());
  return volume *
         (2.0 * kMaterial.mu * strain +
          kMaterial.lambda * strain.trace() * Eigen::Matrix3d::Identity()) *
         x_inv_t;
}

/// The 12 x 12 matrix that a force law gives for the cell, column by column, word for word.
CellStiffness matrix_of(const Body& cell, const ForceLaw& law) {
  Eigen::Matrix3d x;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i)
      x(i, j) = cell.points[static_cast<std::size_t>(j + 1)][static_cast<std::size_t>(i)] -
                cell.points[0][static_cast<std::size_t>(i)];
  CellStiffness k;
  for (int column = 0; column < 12; ++column) {
    Eigen::Matrix<double, 3, 4> u = Eigen::Matrix<double, 3, 4>::Zero();
    u(column % 3, column / 3) = 1.0;
    const Eigen::Matrix3d differences = u.rightCols<3>().colwise() - u.col(0);
    const Eigen::Matrix3d f =
        law(differences * x.inverse(), std::abs(x.determinant()) / 6.0, x.inverse().transpose());
    k.col(column) << -f.rowwise().sum(), f.col(0), f.col(1), f.col(2);
  }
  return k;
}

double asymmetry(const CellStiffness& k) { return (k - k.transpose()).norm() / k.norm(); }

/// |K r| / (|K| |r|) for a rotation r about a skew axis.
double rotation_force(const CellStiffness& k, const Body& cell) {
  const Eigen::Vector3d axis(0.3, -0.8, 0.5);
  const Eigen::VectorXd r = sample(cell, [&](const Point& p) -> Eigen::Vector3d {
    return axis.cross(Eigen::Vector3d(p[0], p[1], p[2]));
  });
  return (k * r).norm() / (k.norm() * r.norm());
}

TEST(Equation1, AsPrintedIsNotSymmetricAndARotationProducesForce) {
  const Body cell = one_cell();
  const CellStiffness k = matrix_of(cell, printed);
  RecordProperty("asymmetry", std::to_string(asymmetry(k)));
  RecordProperty("rotation_force", std::to_string(rotation_force(k, cell)));
  EXPECT_GT(asymmetry(k), 0.3);
  EXPECT_GT(rotation_force(k, cell), 0.1);
}

TEST(Equation1, MendedIsSymmetricAndARotationProducesNone) {
  const Body cell = one_cell();
  const CellStiffness k = matrix_of(cell, mended);
  EXPECT_LT(asymmetry(k), 1e-15);
  EXPECT_LT(rotation_force(k, cell), 1e-15);
}

TEST(Equation1, EachMisprintAloneIsRefuted) {
  const Body cell = one_cell();
  const auto order_mended =
      matrix_of(cell, [](const Eigen::Matrix3d& e, double volume, const Eigen::Matrix3d& x_inv_t) {
        return Eigen::Matrix3d(
            volume *
            (2.0 * kMaterial.mu * e + kMaterial.lambda * e.trace() * Eigen::Matrix3d::Identity()) *
            x_inv_t);
      });
  EXPECT_GT(rotation_force(order_mended, cell), 0.1);
  const auto strain_mended =
      matrix_of(cell, [](const Eigen::Matrix3d& e, double volume, const Eigen::Matrix3d& x_inv_t) {
        const Eigen::Matrix3d strain = 0.5 * (e + e.transpose());
        return printed(strain, volume, x_inv_t);
      });
  EXPECT_GT(asymmetry(strain_mended), 0.1);
}

TEST(Equation1, OperatorAppliesTheMendedForm) {
  const Body cell = one_cell();
  const auto k_operator = uniform_operator(cell, kMaterial);
  const CellStiffness expected = matrix_of(cell, mended);
  EXPECT_LT((k_operator.cell_stiffness({0}) - expected).norm(), 1e-15 * expected.norm());
  Eigen::VectorXd column;
  for (int i = 0; i < 12; ++i) {
    k_operator.apply(Eigen::VectorXd::Unit(12, i), column);
    EXPECT_LT((column - expected.col(i)).norm(), 1e-15 * expected.norm());
  }
}

/// The largest row sum of absolute values.
double infinity_norm(const Eigen::SparseMatrix<double, Eigen::RowMajor>& k) {
  return (k.cwiseAbs() * Eigen::VectorXd::Ones(k.cols())).maxCoeff();
}

/// A random body of two materials and its operator.
struct RandomCase {
  explicit RandomCase(std::uint64_t seed) : rng(seed), body(random_body(rng)) {
    Materials materials{{{1.0, 1.0}, {200.0, 3.0}}, {}};
    for (std::size_t c = 0; c < body.k.cell_count(); ++c)
      materials.of_cell.push_back(rng.chance(0.5) ? 1 : 0);
    k_operator.emplace(body.k, body.points, materials);
  }
  support::Rng rng;
  Body body;
  std::optional<ElasticOperator> k_operator;
};

RC_GTEST_PROP(ElasticOperatorProperty, AgreesWithTheAssembledMatrix, (std::uint64_t seed)) {
  RandomCase random(seed);
  const auto matrix = assemble_stiffness(*random.k_operator);
  const Eigen::VectorXd u = random_vector(random.k_operator->size(), random.rng);
  Eigen::VectorXd f;
  random.k_operator->apply(u, f);
  const double scale = infinity_norm(matrix) * u.lpNorm<Eigen::Infinity>();
  RC_ASSERT((f - matrix * u).lpNorm<Eigen::Infinity>() <= 1e-13 * scale);
  RC_ASSERT(std::abs(random.k_operator->energy(u) - 0.5 * u.dot(f)) <= 1e-13 * u.norm() * f.norm());
}

RC_GTEST_PROP(ElasticOperatorProperty, IsSymmetric, (std::uint64_t seed)) {
  RandomCase random(seed);
  const Eigen::VectorXd u = random_vector(random.k_operator->size(), random.rng);
  const Eigen::VectorXd v = random_vector(random.k_operator->size(), random.rng);
  Eigen::VectorXd ku, kv;
  random.k_operator->apply(u, ku);
  random.k_operator->apply(v, kv);
  RC_ASSERT(std::abs(u.dot(kv) - v.dot(ku)) <=
            1e-13 * (u.norm() * kv.norm() + v.norm() * ku.norm()));
}

RC_GTEST_PROP(ElasticOperatorProperty, GivesNoForceForRigidModes, (std::uint64_t seed)) {
  RandomCase random(seed);
  const double norm = infinity_norm(assemble_stiffness(*random.k_operator));
  const Eigen::MatrixXd modes = rigid_modes_of(random.body);
  Eigen::VectorXd f;
  for (const auto& mode : modes.colwise()) {
    random.k_operator->apply(mode, f);
    RC_ASSERT(f.lpNorm<Eigen::Infinity>() <= 1e-14 * norm * mode.lpNorm<Eigen::Infinity>());
  }
}

RC_GTEST_PROP(ElasticOperatorProperty, DiagonalBlocksAreThoseOfTheMatrix, (std::uint64_t seed)) {
  RandomCase random(seed);
  const Eigen::MatrixXd matrix = assemble_stiffness(*random.k_operator);
  for (topology::Index v = 0; v < random.body.k.vertex_count(); ++v) {
    const Eigen::Matrix3d block = matrix.block<3, 3>(3 * v, 3 * v);
    RC_ASSERT((random.k_operator->diagonal_block({v}) - block).norm() <= 1e-14 * block.norm());
  }
}

TEST(ElasticOperator, EnergyOfAUniformStretchIsTheClosedForm) {
  const Body body = distorted_cube(4, 0.2);
  const auto k_operator = uniform_operator(body, kMaterial);
  const Eigen::VectorXd u =
      sample(body, [](const Point& p) { return Eigen::Vector3d(0.01 * p[0], 0.0, 0.0); });
  const double expected = 0.5 * (kMaterial.lambda + 2.0 * kMaterial.mu) * 1e-4;
  EXPECT_NEAR(k_operator.energy(u), expected, 1e-14 * expected * 10);
}

TEST(ElasticOperator, RefusesVectorsOfTheWrongSize) {
  const auto k_operator = uniform_operator(one_cell(), kMaterial);
  Eigen::VectorXd f;
  EXPECT_THROW(k_operator.apply(Eigen::VectorXd::Zero(11), f), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(k_operator.energy(Eigen::VectorXd::Zero(13))),
               std::invalid_argument);
}

}  // namespace
}  // namespace cleave::fem
