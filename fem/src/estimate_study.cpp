#include "cleave/fem/estimate_study.hpp"

#include <algorithm>

namespace cleave::fem {

double EstimateStudy::worst_factor(std::size_t first, double floor) const {
  double worst = 1.0;
  for (const EstimatedIterate& it : iterates)
    if (it.iteration >= first && it.truth > floor)
      worst = std::max({worst, it.estimate / it.truth, it.truth / it.estimate});
  return worst;
}

EstimateStudy study_estimate(const topology::Complex<3>& k, Points points,
                             const ElasticOperator& k_operator, const Dirichlet& supports,
                             const Eigen::VectorXd& force, const SolveOptions& options) {
  SolveOptions tight = options;
  tight.tolerance = 1e-14;
  tight.norm = Norm::residual;
  tight.max_iterations = std::max<std::size_t>(100000, options.max_iterations);
  const SolveResult reference = solve(k, points, k_operator, supports, force, tight);

  EstimateStudy study{reference.outcome, {}};
  if (reference.outcome == Outcome::unsupported_piece) return study;
  std::vector<double> truths;
  SolveOptions observed = options;
  observed.on_iterate = [&](std::size_t, const Eigen::VectorXd& u) {
    truths.push_back(energy_distance(k_operator, u, reference.displacement) /
                     reference.energy_norm);
  };
  const SolveResult run = solve(k, points, k_operator, supports, force, observed);
  for (const Sample& sample : run.samples)
    if (sample.energy_error)
      study.iterates.push_back({sample.iteration, *sample.energy_error, truths[sample.iteration]});
  return study;
}

}  // namespace cleave::fem
