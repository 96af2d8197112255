#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "cleave/fem/body.hpp"

/// What the sources of this module share about points and cells.
namespace cleave::fem {

inline Eigen::Vector3d as_vector(const std::array<double, 3>& point) {
  return {point[0], point[1], point[2]};
}

inline bool is_finite(const std::array<double, 3>& point) {
  return std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]);
}

/// X of Equation (1): the edges from the first vertex of a cell to the others, as columns.
inline Eigen::Matrix3d edge_matrix(const topology::Complex<3>& k, Points points,
                                   topology::CellId cell) {
  const auto& vertices = k.vertices(cell);
  const Eigen::Vector3d origin = as_vector(points[vertices[0].value]);
  Eigen::Matrix3d edges;
  for (std::size_t i = 1; i < 4; ++i)
    edges.col(static_cast<Eigen::Index>(i) - 1) = as_vector(points[vertices[i].value]) - origin;
  return edges;
}

/// Whether rounding alone could account for the volume that these edges span.
inline bool is_flat(const Eigen::Matrix3d& edges) {
  const double scale = edges.col(0).norm() * edges.col(1).norm() * edges.col(2).norm();
  return !(std::abs(edges.determinant()) > 16.0 * std::numeric_limits<double>::epsilon() * scale);
}

inline void require_one_point_per_vertex(const topology::Complex<3>& k, Points points) {
  if (points.size() != k.vertex_count())
    throw std::invalid_argument("the complex has " + std::to_string(k.vertex_count()) +
                                " vertices, but there are " + std::to_string(points.size()) +
                                " points");
}

/// The volume of the cells around a vertex. Time: linear in the star.
inline double star_volume(const topology::Complex<3>& k, Points points, topology::VertexId vertex) {
  double volume = 0.0;
  for (const topology::CornerId corner : topology::star(k, vertex))
    volume += cell_volume(k, points, topology::cell_of<3>(corner));
  return volume;
}

}  // namespace cleave::fem
