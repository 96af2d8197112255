// Every outcome of CG is reached, and says what happened.
#include "cleave/fem/conjugate_gradient.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Dense>
#include <limits>

#include "bodies.hpp"

namespace cleave::fem {
namespace {

LinearMap map_of(const Eigen::MatrixXd& matrix) {
  return [matrix](const Eigen::VectorXd& in, Eigen::VectorXd& out) { out = matrix * in; };
}

LinearMap jacobi_of(const Eigen::MatrixXd& matrix) {
  const Eigen::VectorXd inverse = matrix.diagonal().cwiseInverse();
  return [inverse](const Eigen::VectorXd& in, Eigen::VectorXd& out) {
    out = inverse.cwiseProduct(in);
  };
}

/// Symmetric, with eigenvalues spread evenly in their logarithm from 1 to `condition`.
Eigen::MatrixXd random_spd(Eigen::Index size, double condition, support::Rng& rng) {
  Eigen::MatrixXd m(size, size);
  for (double& entry : m.reshaped()) entry = 2.0 * rng.unit() - 1.0;
  const Eigen::MatrixXd q = Eigen::HouseholderQR<Eigen::MatrixXd>(m).householderQ();
  const Eigen::VectorXd values = (Eigen::ArrayXd::LinSpaced(size, 0.0, std::log(condition))).exp();
  return q * values.asDiagonal() * q.transpose();
}

RC_GTEST_PROP(ConjugateGradientProperty, SolvesToTheTrueResidual, (std::uint64_t seed)) {
  support::Rng rng(seed);
  const auto size = static_cast<Eigen::Index>(rng.between(1, 40));
  const Eigen::MatrixXd a = random_spd(size, 1e4, rng);
  const Eigen::VectorXd b = random_vector(size, rng);
  const auto result = conjugate_gradient(map_of(a), b, jacobi_of(a));
  RC_ASSERT(result.outcome == Outcome::converged);
  RC_ASSERT((b - a * result.x).norm() <= 1.0001e-8 * b.norm());
  // Two ways to sum b - A x differ by their rounding (Higham 2002, section 3.5).
  const double rounding = 2.0 * static_cast<double>(size + 1) *
                          std::numeric_limits<double>::epsilon() *
                          (a.norm() * result.x.norm() / b.norm() + 1.0);
  RC_ASSERT(std::abs(result.residual - (b - a * result.x).norm() / b.norm()) <= rounding);
  RC_ASSERT(result.samples.size() == result.iterations() + 1);
  RC_ASSERT(std::abs(result.samples.back().residual - result.residual) <= 1e-10);
  for (std::size_t i = 0; i < result.samples.size(); ++i) {
    RC_ASSERT(result.samples[i].iteration == i);
    RC_ASSERT(result.samples[i].seconds >= (i == 0 ? 0.0 : result.samples[i - 1].seconds));
  }
}

// The unit of the load changes nothing but the unit of the answer (powers of two: not even
// rounding).
TEST(ConjugateGradient, IsBlindToTheScaleOfTheLoad) {
  support::Rng rng(1);
  const Eigen::MatrixXd a = random_spd(30, 1e3, rng);
  const Eigen::VectorXd b = random_vector(30, rng);
  const auto expected = conjugate_gradient(map_of(a), b);
  ASSERT_EQ(expected.outcome, Outcome::converged);
  for (const double scale : {0x1p-1000, 0x1p-10, 0x1p530, 0x1p1000}) {
    const auto result = conjugate_gradient(map_of(a), scale * b);
    EXPECT_EQ(result.outcome, Outcome::converged) << scale;
    EXPECT_EQ(result.iterations(), expected.iterations()) << scale;
    EXPECT_EQ(result.x / scale, expected.x) << scale;
  }
}

TEST(ConjugateGradient, WarmStartAtTheSolutionNeedsNoIteration) {
  support::Rng rng(2);
  const Eigen::MatrixXd a = random_spd(30, 1e3, rng);
  const Eigen::VectorXd x = random_vector(30, rng);
  EXPECT_EQ(conjugate_gradient(map_of(a), a * x, {}, x).iterations(), 0u);
  const auto by_energy =
      conjugate_gradient(map_of(a), a * x, {}, x, {1e-8, Norm::energy, 1000, {}});
  EXPECT_EQ(by_energy.outcome, Outcome::converged);
  EXPECT_LT((by_energy.x - x).norm(), 1e-10 * x.norm());
}

TEST(ConjugateGradient, ZeroLoadGivesZero) {
  const auto result = conjugate_gradient(map_of(Eigen::MatrixXd::Identity(3, 3)),
                                         Eigen::VectorXd::Zero(3), {}, Eigen::VectorXd::Ones(3));
  EXPECT_EQ(result.outcome, Outcome::converged);
  EXPECT_EQ(result.x, Eigen::VectorXd::Zero(3));
  EXPECT_EQ(result.energy_error, 0.0);
}

TEST(ConjugateGradient, ReportsTheIterationLimit) {
  support::Rng rng(3);
  const Eigen::MatrixXd a = random_spd(50, 1e6, rng);
  const Eigen::VectorXd b = random_vector(50, rng);
  const auto result = conjugate_gradient(map_of(a), b, {}, {}, {1e-8, Norm::residual, 7, {}});
  EXPECT_EQ(result.outcome, Outcome::iteration_limit);
  EXPECT_EQ(result.iterations(), 7u);
  EXPECT_GT(result.residual, 1e-8);
}

// And one for the residual of the start, one for that of the end, and one where the tolerance seems
// to be met, to make sure of it.
TEST(ConjugateGradient, MultipliesOnceInEachIteration) {
  support::Rng rng(8);
  const Eigen::MatrixXd a = random_spd(50, 1e3, rng);
  const Eigen::VectorXd b = random_vector(50, rng);
  std::size_t products = 0;
  const LinearMap counted = [&](const Eigen::VectorXd& in, Eigen::VectorXd& out) {
    out = a * in;
    ++products;
  };
  for (const std::size_t limit : {0U, 5U, 20U}) {
    products = 0;
    const auto cut_short =
        conjugate_gradient(counted, b, {}, {}, {1e-8, Norm::residual, limit, {}});
    EXPECT_EQ(cut_short.iterations(), limit);
    EXPECT_EQ(products, limit + 2);
  }
  products = 0;
  const auto result = conjugate_gradient(counted, b);
  EXPECT_EQ(result.outcome, Outcome::converged);
  EXPECT_EQ(products, result.iterations() + 3);
}

TEST(ConjugateGradient, StagnatesWhereRoundingStopsIt) {
  support::Rng rng(4);
  const Eigen::MatrixXd a = random_spd(60, 1e5, rng);
  const Eigen::VectorXd b = random_vector(60, rng);
  for (const Norm norm : {Norm::residual, Norm::energy}) {
    const auto result =
        conjugate_gradient(map_of(a), b, jacobi_of(a), {}, {1e-30, norm, 100000, {}});
    EXPECT_EQ(result.outcome, Outcome::stagnated);
    EXPECT_LT(result.residual, 1e-9);
    EXPECT_GT(result.residual, 1e-30);
    EXPECT_LT(result.iterations(), 2000u);
  }
}

// A tolerance that is hard but can be met is met: rounding is noticed, and not mistaken for the
// end.
TEST(ConjugateGradient, MeetsATightToleranceOnAStiffMatrix) {
  support::Rng rng(5);
  const Eigen::MatrixXd a = random_spd(60, 1e10, rng);
  const Eigen::VectorXd b = a * random_vector(60, rng);
  const auto result = conjugate_gradient(map_of(a), b, {}, {}, {1e-13, Norm::residual, 100000, {}});
  EXPECT_EQ(result.outcome, Outcome::converged);
  EXPECT_LE((b - a * result.x).norm(), 1e-12 * b.norm());
}

TEST(ConjugateGradient, ReportsAnIndefiniteMatrix) {
  for (const double second : {-2.0, -1.0}) {  // with -1 the curvature is exactly zero
    const Eigen::MatrixXd a = Eigen::Vector2d(1.0, second).asDiagonal();
    const auto result = conjugate_gradient(map_of(a), Eigen::Vector2d(1.0, 1.0));
    EXPECT_EQ(result.outcome, Outcome::indefinite) << second;
  }
  support::Rng rng(6);
  Eigen::MatrixXd a = random_spd(40, 1e3, rng);
  a -= 2.0 * Eigen::MatrixXd::Identity(40, 40);
  EXPECT_EQ(conjugate_gradient(map_of(a), random_vector(40, rng)).outcome, Outcome::indefinite);
}

TEST(ConjugateGradient, ReportsAnIndefinitePreconditioner) {
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(2, 2);
  const auto result =
      conjugate_gradient(map_of(identity), Eigen::Vector2d(1.0, 2.0), map_of(-identity));
  EXPECT_EQ(result.outcome, Outcome::indefinite);
}

TEST(ConjugateGradient, ReportsWhatIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(2, 2);
  const auto outcome = [&](const Eigen::MatrixXd& a, double load, double start) {
    return conjugate_gradient(map_of(a), Eigen::Vector2d(1.0, load), {},
                              Eigen::Vector2d(0.0, start))
        .outcome;
  };
  EXPECT_EQ(outcome(identity, nan, 0.0), Outcome::not_finite);
  EXPECT_EQ(outcome(identity, infinity, 0.0), Outcome::not_finite);
  EXPECT_EQ(outcome(identity, 1.0, nan), Outcome::not_finite);
  EXPECT_EQ(outcome(nan * identity, 1.0, 0.0), Outcome::not_finite);
  EXPECT_EQ(outcome(identity, 1.0, 0.0), Outcome::converged);
}

TEST(ConjugateGradient, RefusesSizesAndTolerancesThatMeanNothing) {
  const LinearMap identity = map_of(Eigen::MatrixXd::Identity(2, 2));
  const Eigen::Vector2d b(1.0, 2.0);
  EXPECT_THROW(conjugate_gradient(identity, b, {}, Eigen::VectorXd::Zero(3)),
               std::invalid_argument);
  for (const double tolerance : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(conjugate_gradient(identity, b, {}, {}, {tolerance, Norm::residual, 10, {}}),
                 std::invalid_argument);
}

// With an exact reference. How far the estimate, a lower bound, may fall short has no theorem: on
// these dense matrices, whose spectra are nothing like elasticity's, a rare iterate has 0.29 of the
// truth. So the bound here is ten; factor 3 is asserted where it is promised, on elastic bodies.
RC_GTEST_PROP(EnergyErrorProperty, EstimateIsOfTheRightSize, (std::uint64_t seed)) {
  support::Rng rng(seed);
  const auto size = static_cast<Eigen::Index>(rng.between(20, 120));
  const Eigen::MatrixXd a = random_spd(size, 1e4, rng);
  const Eigen::VectorXd x = random_vector(size, rng);
  const double x_norm = std::sqrt(x.dot(a * x));
  std::vector<double> truths;
  CgOptions options{1e-7, Norm::energy, 10000, {}};
  options.on_iterate = [&](std::size_t, const Eigen::VectorXd& iterate) {
    truths.push_back(std::sqrt((x - iterate).dot(a * (x - iterate))) / x_norm);
  };
  const auto result = conjugate_gradient(map_of(a), a * x, jacobi_of(a), {}, options);
  RC_ASSERT(result.outcome == Outcome::converged);
  RC_ASSERT(truths.back() <= 1e-6);
  RC_ASSERT(std::abs(result.energy_norm - x_norm) <= 1e-6 * x_norm);
  std::size_t estimated = 0;
  for (const Sample& sample : result.samples) {
    if (!sample.energy_error) continue;
    ++estimated;
    if (sample.iteration < 5) continue;
    const double factor = *sample.energy_error / truths[sample.iteration];
    RC_ASSERT(factor < 1.5);
    RC_ASSERT(factor > 0.1);
  }
  RC_ASSERT(estimated > 0u);
}

TEST(Outcomes, HaveTheNamesOfTheReports) {
  EXPECT_EQ(name(Outcome::converged), "converged");
  EXPECT_EQ(name(Outcome::iteration_limit), "iteration_limit");
  EXPECT_EQ(name(Outcome::stagnated), "stagnated");
  EXPECT_EQ(name(Outcome::indefinite), "indefinite");
  EXPECT_EQ(name(Outcome::not_finite), "not_finite");
  EXPECT_EQ(name(Outcome::unsupported_piece), "unsupported_piece");
}

}  // namespace
}  // namespace cleave::fem
