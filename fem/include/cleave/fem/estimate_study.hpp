#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "cleave/fem/solve.hpp"

namespace cleave::fem {

/// An iterate with its estimated and its true energy error, both relative as in Sample.
struct EstimatedIterate {
  std::size_t iteration;
  double estimate, truth;
};

struct EstimateStudy {
  Outcome reference_outcome;  // converged or stagnated: the reference is as good as doubles allow
  std::vector<EstimatedIterate> iterates;  // those that have an estimate, ascending

  /// The largest factor between estimate and truth over the iterates from `first` on whose true
  /// error is above `floor`; 1 if there are none.
  double worst_factor(std::size_t first, double floor) const;
};

/// Solves twice: to a relative residual of 1e-14 for a reference, then again with `options`, and
/// measures the true energy error of every iterate that has an estimate. For tests and reports.
/// Arguments as `solve`. Time: two solves, and one more product with K per iterate.
EstimateStudy study_estimate(const topology::Complex<3>& k, Points points,
                             const ElasticOperator& k_operator, const Dirichlet& supports,
                             const Eigen::VectorXd& force, const SolveOptions& options);

}  // namespace cleave::fem
