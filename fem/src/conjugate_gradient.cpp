#include "cleave/fem/conjugate_gradient.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "energy_error_estimator.hpp"

namespace cleave::fem {

namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kNever = std::numeric_limits<double>::infinity();

/// How a scalar product that should be positive turned out.
enum class Sign { positive, rounding, negative, not_finite };

Sign sign_of_product(double product, double norm_a, double norm_b) {
  if (!std::isfinite(product)) return Sign::not_finite;
  if (product > 0.0) return Sign::positive;
  return product < -64.0 * kEpsilon * norm_a * norm_b ? Sign::negative : Sign::rounding;
}

Outcome outcome_of(Sign sign) {
  switch (sign) {
    case Sign::not_finite:
      return Outcome::not_finite;
    case Sign::negative:
      return Outcome::indefinite;
    default:
      return Outcome::stagnated;
  }
}

/// One run of CG. The right-hand side and the start are divided by the largest entry of the former,
/// so that no scalar product overflows or vanishes because of the unit of the load.
class Run {
 public:
  Run(const LinearMap& a, const LinearMap& preconditioner, const CgOptions& options)
      : a_(a), preconditioner_(preconditioner), options_(options) {}

  CgResult solve(const Eigen::VectorXd& b, Eigen::VectorXd x0) {
    if (!b.allFinite() || !x0.allFinite()) return finish(Outcome::not_finite, std::move(x0));
    scale_ = b.lpNorm<Eigen::Infinity>();
    if (scale_ == 0.0) {
      x_ = Eigen::VectorXd::Zero(b.size());
      scale_ = 1.0;
      record();
      result_.samples.back().energy_error = 0.0;
      result_.energy_error = 0.0;
      return finish(Outcome::converged, x_);
    }
    b_ = b / scale_;
    x_ = x0 / scale_;
    b_norm_ = b_.norm();
    return iterate();
  }

 private:
  CgResult iterate() {
    r_ = true_residual();
    r_norm_ = r_.norm();
    record();
    std::optional<Outcome> end;
    while (!end) {
      end = check();
      if (!end && iteration_ == options_.max_iterations) end = Outcome::iteration_limit;
      if (!end) end = choose_direction();
      if (!end) end = step();
    }
    return finish_at(*end);
  }

  Eigen::VectorXd true_residual() {
    a_(x_, q_);
    return b_ - q_;
  }

  /// The next p, conjugate to the last one but at the start and after a restart.
  std::optional<Outcome> choose_direction() {
    if (preconditioner_)
      preconditioner_(r_, z_);
    else
      z_ = r_;
    const double rho = r_.dot(z_);
    const Sign sign = sign_of_product(rho, r_norm_, z_.norm());
    if (sign != Sign::positive) return outcome_of(sign);
    if (rho_ == 0.0)
      p_ = z_;
    else
      p_ = z_ + (rho / rho_) * p_;
    rho_ = rho;
    return std::nullopt;
  }

  std::optional<Outcome> step() {
    a_(p_, q_);
    const double p_norm = p_.norm(), q_norm = q_.norm();
    const double curvature = p_.dot(q_);
    const Sign sign = sign_of_product(curvature, p_norm, q_norm);
    // No curvature, yet A p is not zero: that happens to no semidefinite matrix.
    if (sign == Sign::rounding && q_norm > 1e-6 * largest_stretch_ * p_norm)
      return Outcome::indefinite;
    if (sign != Sign::positive) return outcome_of(sign);
    const double alpha = rho_ / curvature;
    x_ += alpha * p_;
    r_ -= alpha * q_;
    r_norm_ = r_.norm();
    ++iteration_;
    largest_stretch_ = std::max(largest_stretch_, q_norm / p_norm);
    record();
    if (!std::isfinite(r_norm_)) return Outcome::not_finite;
    take_estimates(alpha * rho_);
    return std::nullopt;
  }

  /// Whether it is over. Computes the residual anew where the one of the recurrence meets the
  /// tolerance, or is so small that rounding may have parted the two.
  std::optional<Outcome> check() {
    const bool by_residual = options_.norm == Norm::residual;
    if (!by_residual && energy_tolerance_met_) return Outcome::converged;
    const double goal = by_residual ? options_.tolerance * b_norm_ : 0.0;
    if (r_norm_ > std::min(std::max(goal, rounding_level()), next_check_)) return std::nullopt;
    if (!by_residual && !restart_estimated_ && r_norm_ > 0.0) return std::nullopt;

    Eigen::VectorXd anew = true_residual();
    const double norm = anew.norm();
    if (by_residual ? norm <= goal : norm == 0.0) {
      r_ = std::move(anew);
      r_norm_ = norm;
      return Outcome::converged;
    }
    const bool recurrence_holds = (anew - r_).norm() <= 0.5 * r_norm_;
    if (recurrence_holds) {
      next_check_ = r_norm_ > goal ? std::max(0.5 * r_norm_, goal) : 0.5 * r_norm_;
      trusted_residual_ = 0.5 * r_norm_;
      return std::nullopt;
    }
    return restart(std::move(anew), norm, goal);
  }

  std::optional<Outcome> restart(Eigen::VectorXd residual, double norm, double goal) {
    r_ = std::move(residual);
    r_norm_ = norm;
    if (norm > 0.5 * last_restart_norm_) return Outcome::stagnated;
    last_restart_norm_ = norm;
    last_restart_ = iteration_;
    restart_estimated_ = false;
    next_check_ = std::max(0.5 * norm, goal);
    result_.samples.back().residual = norm / b_norm_;
    rho_ = 0.0;
    return std::nullopt;
  }

  void take_estimates(double decrease) {
    for (const auto& estimate : estimator_.add(decrease)) {
      Sample& sample = result_.samples[estimate.iterate];
      sample.energy_error = std::sqrt(estimate.squared);  // made relative at the end
      const bool is_restart = estimate.iterate == last_restart_;
      restart_estimated_ = restart_estimated_ || is_restart;
      if (options_.norm != Norm::energy || energy_tolerance_met_) continue;
      const bool trusted =
          is_restart || sample.residual * b_norm_ > std::min(rounding_level(), trusted_residual_);
      energy_tolerance_met_ = trusted && *sample.energy_error <= options_.tolerance * energy_norm();
    }
  }

  /// Roughly the rounding errors of b - A x: below it the recurrence goes on falling by itself.
  double rounding_level() const { return kEpsilon * (largest_stretch_ * x_.norm() + b_norm_); }

  /// |x*|_A from below: |x*|^2 - |x* - x|^2 = x.(b + r).
  double energy_norm() const { return std::sqrt(std::max(0.0, x_.dot(b_ + r_))); }

  void record() {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
    const double residual = b_norm_ > 0.0 ? r_norm_ / b_norm_ : 0.0;
    result_.samples.push_back({iteration_, elapsed.count(), residual, std::nullopt});
    if (options_.on_iterate) options_.on_iterate(iteration_, scale_ * x_);
  }

  CgResult finish_at(Outcome outcome) {
    double norm = 0.0;
    if (outcome != Outcome::not_finite) {
      r_ = true_residual();
      r_norm_ = r_.norm();
      result_.samples.back().residual = r_norm_ / b_norm_;
      norm = energy_norm();
    }
    result_.energy_norm = scale_ * norm;
    for (Sample& sample : result_.samples) {
      if (!sample.energy_error) continue;
      if (norm > 0.0)
        result_.energy_error = *sample.energy_error /= norm;
      else
        sample.energy_error.reset();
    }
    return finish(outcome, scale_ * x_);
  }

  CgResult finish(Outcome outcome, Eigen::VectorXd x) {
    result_.outcome = outcome;
    result_.x = std::move(x);
    result_.residual = outcome == Outcome::not_finite ? std::numeric_limits<double>::quiet_NaN()
                                                      : result_.samples.back().residual;
    return std::move(result_);
  }

  const LinearMap& a_;
  const LinearMap& preconditioner_;
  const CgOptions& options_;
  const std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();

  double scale_ = 1.0;
  Eigen::VectorXd b_, x_, r_, z_, p_, q_;
  double b_norm_ = 0.0, r_norm_ = 0.0;
  double rho_ = 0.0;  // r.z of the last step; 0: no step to be conjugate to
  std::size_t iteration_ = 0;
  CgResult result_;

  double largest_stretch_ = 0.0;       // of |A p|/|p|: |A| from below
  double next_check_ = kNever;         // no new look at the true residual above this
  double trusted_residual_ = kNever;   // the recurrence was seen to hold down to here
  double last_restart_norm_ = kNever;  // |b - A x| at the last restart
  std::size_t last_restart_ = 0;       // iterate whose residual was computed, not updated
  bool restart_estimated_ = false;     // whether that iterate has an estimate
  bool energy_tolerance_met_ = false;
  EnergyErrorEstimator estimator_;
};

}  // namespace

std::string_view name(Outcome outcome) {
  switch (outcome) {
    case Outcome::converged:
      return "converged";
    case Outcome::iteration_limit:
      return "iteration_limit";
    case Outcome::stagnated:
      return "stagnated";
    case Outcome::indefinite:
      return "indefinite";
    case Outcome::not_finite:
      return "not_finite";
    case Outcome::unsupported_piece:
      return "unsupported_piece";
  }
  return "";
}

CgResult conjugate_gradient(const LinearMap& a, const Eigen::VectorXd& b,
                            const LinearMap& preconditioner, Eigen::VectorXd x0,
                            const CgOptions& options) {
  if (!(options.tolerance > 0.0))
    throw std::invalid_argument("the tolerance of a solve must be positive, it is " +
                                std::to_string(options.tolerance));
  if (x0.size() == 0) x0 = Eigen::VectorXd::Zero(b.size());
  if (x0.size() != b.size())
    throw std::invalid_argument("the start has " + std::to_string(x0.size()) +
                                " entries, the right-hand side " + std::to_string(b.size()));
  return Run(a, preconditioner, options).solve(b, std::move(x0));
}

}  // namespace cleave::fem
