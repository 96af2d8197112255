#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "cleave/fem/body.hpp"
#include "cleave/fem/dirichlet.hpp"
#include "cleave/topology/complex.hpp"
#include "cleave/topology/pieces.hpp"

namespace cleave::fem {

/// A piece that its supports let move as a rigid body, and how. Mode m moves point x by
/// t + w cross (x - centre)/radius, where t and w are rows 0..2 and 3..5 of column m of `modes`;
/// the columns are orthonormal.
struct UnsupportedPiece {
  topology::Index piece = 0;                         // as topology::pieces numbers them
  topology::CellId a_cell{};                         // the least cell of the piece
  std::vector<topology::VertexId> vertices;          // of the piece, ascending
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  // mean of its points
  double radius = 0.0;                               // largest distance of a point from it
  Eigen::Matrix<double, 6, Eigen::Dynamic> modes;    // one column per free mode, 1 to 6

  /// What mode `m` does to point `x`.
  Eigen::Vector3d move(Eigen::Index m, const std::array<double, 3>& x) const;
};

/// "piece 2 (cell 17 and the cells connected to it): 6 of its 6 rigid motions are free", ..
std::string describe(const UnsupportedPiece& piece);

/// The pieces that can move rigidly, ascending; empty: K on the free coordinates is positive
/// definite. In a cut-regular complex a piece is connected through facets, so its zero modes are
/// exactly the rigid motions that its supports do not stop (T9). Those are found as the null space
/// of the prescribed rows of its six rigid modes, in coordinates centred and scaled to the piece,
/// by singular values with relative tolerance 1e-10: three collinear fixed vertices leave one
/// rotation. Time: linear in the cells, and 36 operations per prescribed coordinate.
std::vector<UnsupportedPiece> unsupported_pieces(const topology::Complex<3>& k, Points points,
                                                 const topology::Pieces& pieces,
                                                 const Dirichlet& supports);

}  // namespace cleave::fem
