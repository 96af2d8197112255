#include "block_jacobi.hpp"

#include <Eigen/Cholesky>

namespace cleave::fem {

namespace {

/// The inverse of `block` on the free axes, zero elsewhere.
Eigen::Matrix3d inverse_on(Eigen::Matrix3d block, const std::array<bool, 3>& is_free) {
  Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
  for (int axis = 0; axis < 3; ++axis) {
    if (is_free[static_cast<std::size_t>(axis)]) continue;
    block.row(axis).setZero();
    block.col(axis).setZero();
    block(axis, axis) = 1.0;
    identity(axis, axis) = 0.0;
  }
  return block.llt().solve(identity);
}

}  // namespace

BlockJacobi::BlockJacobi(const ElasticOperator& k_operator, const Dirichlet& supports)
    : inverses_(k_operator.vertex_count(), Eigen::Matrix3d::Zero()) {
  auto next = supports.values().begin();
  for (topology::Index v = 0; v < inverses_.size(); ++v) {
    std::array<bool, 3> is_free{true, true, true};
    for (; next != supports.values().end() && next->first / 3 == v; ++next)
      is_free[next->first % 3] = false;
    const Eigen::Matrix3d& block = k_operator.diagonal_block({v});
    if (!block.isZero(0.0)) inverses_[v] = inverse_on(block, is_free);
  }
}

void BlockJacobi::apply(const Eigen::VectorXd& r, Eigen::VectorXd& z) const {
  z.resize(r.size());
  for (std::size_t v = 0; v < inverses_.size(); ++v) {
    const auto at = 3 * static_cast<Eigen::Index>(v);
    z.segment<3>(at).noalias() = inverses_[v] * r.segment<3>(at);
  }
}

}  // namespace cleave::fem
