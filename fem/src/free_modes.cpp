#include "free_modes.hpp"

#include <Eigen/QR>
#include <cmath>

namespace cleave::fem {

using topology::VertexId;

namespace {

Eigen::Index first_entry(VertexId v) { return 3 * static_cast<Eigen::Index>(v.value); }

}  // namespace

FreeModes::FreeModes(std::span<const UnsupportedPiece> pieces, Points points,
                     std::span<const double> star_volumes, const Dirichlet& supports) {
  for (const UnsupportedPiece& piece : pieces) {
    const auto rows = 3 * static_cast<Eigen::Index>(piece.vertices.size());
    Block block{piece.vertices, Eigen::VectorXd(rows), {}};
    Eigen::MatrixXd modes = Eigen::MatrixXd::Zero(rows, piece.modes.cols());
    for (std::size_t i = 0; i < piece.vertices.size(); ++i) {
      const VertexId v = piece.vertices[i];
      const auto at = 3 * static_cast<Eigen::Index>(i);
      const double root = std::sqrt(star_volumes[v.value]);
      block.root_weights.segment<3>(at).setConstant(root);
      for (Eigen::Index m = 0; m < modes.cols(); ++m) {
        const Eigen::Vector3d motion = piece.move(m, points[v.value]);
        for (int axis = 0; axis < 3; ++axis)  // a free mode leaves supports alone but for rounding
          if (!supports.prescribes(v, axis)) modes(at + axis, m) = root * motion[axis];
      }
    }
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(modes);
    block.basis = qr.householderQ() * Eigen::MatrixXd::Identity(rows, modes.cols());
    blocks_.push_back(std::move(block));
  }
}

void FreeModes::remove_motion(Eigen::VectorXd& u) const {
  for (const Block& block : blocks_) project(block, block.root_weights, u);
}

void FreeModes::remove_load(Eigen::VectorXd& f) const {
  for (const Block& block : blocks_) project(block, block.root_weights.cwiseInverse(), f);
}

void FreeModes::project(const Block& block, const Eigen::VectorXd& weights, Eigen::VectorXd& v) {
  Eigen::VectorXd part(weights.size());
  for (std::size_t i = 0; i < block.vertices.size(); ++i)
    part.segment<3>(3 * static_cast<Eigen::Index>(i)) =
        v.segment<3>(first_entry(block.vertices[i]));
  const Eigen::VectorXd amounts = block.basis.transpose() * part.cwiseProduct(weights);
  part -= (block.basis * amounts).cwiseQuotient(weights);
  for (std::size_t i = 0; i < block.vertices.size(); ++i)
    v.segment<3>(first_entry(block.vertices[i])) =
        part.segment<3>(3 * static_cast<Eigen::Index>(i));
}

}  // namespace cleave::fem
