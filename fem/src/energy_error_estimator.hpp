#pragma once
#include <cstddef>
#include <vector>

namespace cleave::fem {

/// The delayed Hestenes-Stiefel estimate of |x* - x_j|_A^2 for the iterates of CG, with the window
/// of each iterate chosen as in Meurant, Papez & Tichy 2021 (Accurate error estimation in CG). Step
/// j of CG, from iterate j to j+1, lowers the squared error by a known decrease; the sum of the
/// decreases from j on is a lower bound of the squared error of iterate j. It is close once what is
/// left, the squared error of the newest iterate, is small against it. That rest is estimated as
/// the newest decrease times a safety factor: the largest ratio of known error to decrease over
/// those last steps in which the squared error fell by no more than a factor 1e12. (The paper looks
/// back over 1e4. Bodies of stiff and soft parts have longer plateaus: for layers with a contrast
/// of 1e6 estimates were off by up to 706 with 1e4, 36 with 1e8 and 1.4 with 1e12; on bodies of one
/// material the longer memory costs one iteration in ten of delay.)
class EnergyErrorEstimator {
 public:
  /// The squared estimate of one iterate.
  struct Estimate {
    std::size_t iterate;
    double squared;
  };

  /// Takes the decrease of the next step; the result names the iterates whose windows closed with
  /// it. Time: linear in the window.
  const std::vector<Estimate>& add(double decrease);

 private:
  std::vector<double> decreases_;
  std::size_t open_ = 0;      // the first iterate without an estimate
  std::vector<double> sums_;  // scratch: sums_[i] = decreases from the newest back to newest - i
  std::vector<Estimate> closed_;  // what the last add returned
};

}  // namespace cleave::fem
