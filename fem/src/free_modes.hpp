#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

#include "cleave/fem/dirichlet.hpp"
#include "cleave/fem/rigid_modes.hpp"

namespace cleave::fem {

/// The free rigid modes R of all unsupported pieces, as two projections that are transposes of each
/// other, W being the volume around each vertex:
///   motion:  u -> u - R (R^T W R)^-1 R^T W u   leaves no rigid part in the mean over the volume,
///   load:    f -> f - W R (R^T W R)^-1 R^T f   leaves no load that works on a free mode, and takes
/// away what would accelerate the piece as a rigid body of even density.
class FreeModes {
 public:
  FreeModes(std::span<const UnsupportedPiece> pieces, Points points,
            std::span<const double> star_volumes, const Dirichlet& supports);

  bool empty() const { return blocks_.empty(); }
  void remove_motion(Eigen::VectorXd& u) const;
  void remove_load(Eigen::VectorXd& f) const;

 private:
  /// Of one piece: an orthonormal basis of W^(1/2) R, three rows per vertex.
  struct Block {
    std::vector<topology::VertexId> vertices;
    Eigen::VectorXd root_weights;
    Eigen::MatrixXd basis;
  };

  /// v -> v - weights^-1 basis basis^T weights v on the vertices of `block`.
  static void project(const Block& block, const Eigen::VectorXd& weights, Eigen::VectorXd& v);

  std::vector<Block> blocks_;
};

}  // namespace cleave::fem
