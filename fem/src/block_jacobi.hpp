#pragma once
#include <Eigen/Core>
#include <vector>

#include "cleave/fem/dirichlet.hpp"
#include "cleave/fem/elastic_operator.hpp"

namespace cleave::fem {

/// The inverses of the 3x3 blocks on the diagonal of K, restricted to free coordinates; zero on
/// prescribed ones and on vertices that no cell uses.
class BlockJacobi {
 public:
  BlockJacobi(const ElasticOperator& k_operator, const Dirichlet& supports);

  void apply(const Eigen::VectorXd& r, Eigen::VectorXd& z) const;

 private:
  std::vector<Eigen::Matrix3d> inverses_;
};

}  // namespace cleave::fem
