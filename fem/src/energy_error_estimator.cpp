#include "energy_error_estimator.hpp"

#include <algorithm>

namespace cleave::fem {

const std::vector<EnergyErrorEstimator::Estimate>& EnergyErrorEstimator::add(double decrease) {
  constexpr double kTolerance = 0.25;  // of what the window leaves out, against the window
  constexpr double kMemory = 1e12;     // fall of the squared error over which the factor looks back

  closed_.clear();
  decreases_.push_back(decrease);
  const std::size_t newest = decreases_.size() - 1;
  sums_.assign(1, decrease);
  double safety = 1.0;
  bool remembers = true;
  for (std::size_t j = newest; j-- > 0 && (remembers || j >= open_);) {
    sums_.push_back(sums_.back() + decreases_[j]);
    if (remembers) safety = std::max(safety, sums_.back() / decreases_[j]);
    remembers = remembers && sums_.back() < kMemory * decrease;
  }
  const double rest = safety * decrease;
  while (open_ < newest && rest <= kTolerance * (sums_[newest - open_] - decrease)) {
    closed_.push_back({open_, sums_[newest - open_]});
    ++open_;
  }
  return closed_;
}

}  // namespace cleave::fem
