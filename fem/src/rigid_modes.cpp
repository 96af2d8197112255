#include "cleave/fem/rigid_modes.hpp"

#include <Eigen/SVD>
#include <algorithm>

#include "geometry.hpp"

namespace cleave::fem {

using topology::CellId;
using topology::VertexId;

namespace {

using Row = Eigen::Matrix<double, 1, 6>;
using Rows = Eigen::Matrix<double, Eigen::Dynamic, 6>;

/// What each of the six rigid modes does to coordinate `axis` of the point at `place` (centred and
/// scaled): the row of (t, w) -> (t + w cross place)[axis].
Row row_of(const Eigen::Vector3d& place, int axis) {
  Row row = Row::Zero();
  row[axis] = 1.0;
  const int next = (axis + 1) % 3, last = (axis + 2) % 3;
  row[3 + next] = place[last];
  row[3 + last] = -place[next];
  return row;
}

/// An orthonormal basis of the null space of `rows`, by singular values.
Eigen::Matrix<double, 6, Eigen::Dynamic> null_space(const Rows& rows) {
  constexpr double kTolerance = 1e-10;
  if (rows.rows() == 0) return Eigen::Matrix<double, 6, 6>::Identity();
  // Rows of zeros below make the matrix tall enough for six singular values.
  Rows tall = Rows::Zero(std::max<Eigen::Index>(rows.rows(), 6), 6);
  tall.topRows(rows.rows()) = rows;
  const Eigen::JacobiSVD<Rows> svd(tall, Eigen::ComputeFullV);
  const auto& values = svd.singularValues();
  Eigen::Index rank = 0;
  while (rank < 6 && values[rank] > kTolerance * values[0]) ++rank;
  return svd.matrixV().rightCols(6 - rank);
}

/// The vertices of each piece, ascending, and its least cell.
std::vector<UnsupportedPiece> all_pieces(const topology::Complex<3>& k,
                                         const topology::Pieces& pieces) {
  std::vector<UnsupportedPiece> all(pieces.count);
  std::vector<bool> seen(k.vertex_count(), false);
  for (auto c = static_cast<topology::Index>(k.cell_count()); c-- > 0;) {
    UnsupportedPiece& piece = all[pieces.of_cell[c]];
    piece.piece = pieces.of_cell[c];
    piece.a_cell = {c};
    for (const VertexId v : k.vertices({c})) {
      if (!seen[v.value]) piece.vertices.push_back(v);
      seen[v.value] = true;
    }
  }
  for (UnsupportedPiece& piece : all) std::sort(piece.vertices.begin(), piece.vertices.end());
  return all;
}

void measure(UnsupportedPiece& piece, Points points) {
  for (const VertexId v : piece.vertices) piece.centre += as_vector(points[v.value]);
  piece.centre /= static_cast<double>(piece.vertices.size());
  for (const VertexId v : piece.vertices)
    piece.radius = std::max(piece.radius, (as_vector(points[v.value]) - piece.centre).norm());
}

Rows prescribed_rows(const UnsupportedPiece& piece, Points points, const Dirichlet& supports) {
  std::vector<Row> rows;
  for (const VertexId v : piece.vertices)
    for (int axis = 0; axis < 3; ++axis)
      if (supports.prescribes(v, axis))
        rows.push_back(row_of((as_vector(points[v.value]) - piece.centre) / piece.radius, axis));
  Rows matrix(static_cast<Eigen::Index>(rows.size()), 6);
  for (std::size_t i = 0; i < rows.size(); ++i) matrix.row(static_cast<Eigen::Index>(i)) = rows[i];
  return matrix;
}

}  // namespace

Eigen::Vector3d UnsupportedPiece::move(Eigen::Index m, const std::array<double, 3>& x) const {
  const Eigen::Vector3d place = (as_vector(x) - centre) / radius;
  const Eigen::Vector3d translation = modes.col(m).head<3>(), rotation = modes.col(m).tail<3>();
  return translation + rotation.cross(place);
}

std::string describe(const UnsupportedPiece& piece) {
  return "piece " + std::to_string(piece.piece) + " (cell " + std::to_string(piece.a_cell.value) +
         " and the cells connected to it): " + std::to_string(piece.modes.cols()) +
         " of its 6 rigid motions are free";
}

std::vector<UnsupportedPiece> unsupported_pieces(const topology::Complex<3>& k, Points points,
                                                 const topology::Pieces& pieces,
                                                 const Dirichlet& supports) {
  require_one_point_per_vertex(k, points);
  std::vector<UnsupportedPiece> found;
  for (UnsupportedPiece& piece : all_pieces(k, pieces)) {
    measure(piece, points);
    piece.modes = null_space(prescribed_rows(piece, points, supports));
    if (piece.modes.cols() > 0) found.push_back(std::move(piece));
  }
  return found;
}

}  // namespace cleave::fem
