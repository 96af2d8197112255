#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "cleave/fem/body.hpp"
#include "cleave/topology/complex.hpp"
#include "cleave/topology/relabelling.hpp"

namespace cleave::fem {

/// The stiffness matrix of a 12-coordinate cell: rows and columns 3i..3i+2 belong to its i-th
/// vertex.
using CellStiffness = Eigen::Matrix<double, 12, 12>;

/// The stiffness operator K of linear elasticity on linear tetrahedra: displacement -> elastic
/// force, without a stored matrix. Vectors have 3 entries per vertex (x, y, z of vertex v at 3v ..
/// 3v+2). Per cell, Equation (1) of Nienhuys & van der Stappen 2000 with its two misprints mended:
///   X = (X1-X0|X2-X0|X3-X0),  U likewise,  E = U X^-1,  eps = (E + E^T)/2,
///   (F1|F2|F3) = volume (2 mu eps + lambda trace(eps) I) X^-T,  F0 = -(F1+F2+F3).
/// K is symmetric and positive semidefinite; rigid motions give zero.
/// A value of its own: it keeps no reference to the complex. Memory: 92 bytes per cell, 72 per
/// vertex. Const members may be called from several threads at once.
class ElasticOperator {
 public:
  /// Throws InvalidBody (all flaws of check_body and check_materials), std::invalid_argument for
  /// sizes that do not fit. Time: linear.
  ElasticOperator(const topology::Complex<3>& k, Points points, const Materials& materials);

  std::size_t cell_count() const { return cells_.size(); }
  std::size_t vertex_count() const { return diagonal_.size(); }

  /// Entries of a displacement or force vector: 3 per vertex.
  Eigen::Index size() const { return 3 * static_cast<Eigen::Index>(diagonal_.size()); }

  /// Follows a change of the complex: `k` is the complex after it. Copies lie where their parents
  /// do. Afterwards the operator equals a new one bit for bit. Throws std::invalid_argument if the
  /// numbers of cells or vertices show that it is not the next change of this body. Time: the
  /// renamed corners and the stars of their old and new vertices (and the growth of the diagonal).
  void update(const topology::Complex<3>& k, const topology::Relabelling& change);

  /// f = K u, in newtons for metres and pascals. `f` is resized; it must not be `u`.
  /// Throws std::invalid_argument unless u has size(). Time: linear in the cells.
  void apply(const Eigen::VectorXd& u, Eigen::VectorXd& f) const;

  /// The elastic energy u.Ku/2 in joules; never negative. Time: linear in the cells.
  double energy(const Eigen::VectorXd& u) const;

  /// The 3x3 block of K on the diagonal at `vertex`; zero if no cell uses it.
  const Eigen::Matrix3d& diagonal_block(topology::VertexId vertex) const {
    return diagonal_[vertex.value];
  }

  /// The part of K that one cell contributes.
  CellStiffness cell_stiffness(topology::CellId cell) const;

  /// The vertices of `cell`.
  const topology::Cell<3>& vertices(topology::CellId cell) const { return cells_[cell.value]; }

 private:
  /// Rows g_1, g_2, g_3 of X^-1, times sqrt(volume). The force is quadratic in them, so the volume
  /// needs no place of its own.
  using Gradients = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

  /// E of Equation (1), times the square root of the cell's volume.
  Eigen::Matrix3d displacement_gradient(std::size_t cell, const Eigen::VectorXd& u) const;
  Eigen::Vector3d scaled_gradient(topology::CellId cell, int i) const;
  Eigen::Matrix3d diagonal_share(topology::CornerId corner) const;

  std::vector<topology::Cell<3>> cells_;
  std::vector<Gradients> gradients_;
  std::vector<std::uint32_t> material_;
  std::vector<Lame> table_;
  std::vector<Eigen::Matrix3d> diagonal_;  // per vertex
};

}  // namespace cleave::fem
