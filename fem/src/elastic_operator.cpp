#include "cleave/fem/elastic_operator.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "geometry.hpp"

namespace cleave::fem {

using topology::CellId;
using topology::CornerId;
using topology::VertexId;

namespace {

Eigen::Index first_entry(VertexId v) { return 3 * static_cast<Eigen::Index>(v.value); }

/// 2 mu eps + lambda trace(eps) I, for the displacement gradient E.
Eigen::Matrix3d stress(const Eigen::Matrix3d& gradient, const Lame& material) {
  Eigen::Matrix3d sigma = material.mu * (gradient + gradient.transpose());
  sigma.diagonal().array() += material.lambda * gradient.trace();
  return sigma;
}

void require_size(const Eigen::VectorXd& u, Eigen::Index size) {
  if (u.size() != size)
    throw std::invalid_argument("the operator takes vectors of " + std::to_string(size) +
                                " entries, this one has " + std::to_string(u.size()));
}

}  // namespace

ElasticOperator::ElasticOperator(const topology::Complex<3>& k, Points points,
                                 const Materials& materials)
    : cells_(k.cells().begin(), k.cells().end()),
      material_(materials.of_cell),
      table_(materials.table),
      diagonal_(k.vertex_count(), Eigen::Matrix3d::Zero()) {
  auto flaws = check_body(k, points);
  const auto more = check_materials(k, materials);
  flaws.insert(flaws.end(), more.begin(), more.end());
  if (!flaws.empty()) throw InvalidBody(std::move(flaws));

  gradients_.reserve(cells_.size());
  for (topology::Index c = 0; c < cells_.size(); ++c) {
    const Eigen::Matrix3d edges = edge_matrix(k, points, {c});
    const double volume = std::abs(edges.determinant()) / 6.0;
    gradients_.emplace_back(std::sqrt(volume) * edges.inverse());
  }
  for (topology::Index h = 0; h < 4 * cells_.size(); ++h)
    diagonal_[k.vertex({h}).value] += diagonal_share({h});
}

void ElasticOperator::update(const topology::Complex<3>& k, const topology::Relabelling& change) {
  if (k.cell_count() != cells_.size())
    throw std::invalid_argument("the complex has " + std::to_string(k.cell_count()) +
                                " cells, the operator " + std::to_string(cells_.size()));
  if (change.vertices_before != vertex_count() || change.vertices_after != k.vertex_count())
    throw std::invalid_argument("the change leads from " + std::to_string(change.vertices_before) +
                                " to " + std::to_string(change.vertices_after) +
                                " vertices, the operator has " + std::to_string(vertex_count()) +
                                ", the complex " + std::to_string(k.vertex_count()));
  std::vector<VertexId> touched;
  for (const topology::RenamedCorner& renamed : change.corners) {
    cells_[topology::cell_of<3>(renamed.corner).value]
          [static_cast<std::size_t>(topology::local_index<3>(renamed.corner))] = renamed.to;
    touched.push_back(renamed.from);
    touched.push_back(renamed.to);
  }
  std::sort(touched.begin(), touched.end());
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());

  diagonal_.resize(k.vertex_count(), Eigen::Matrix3d::Zero());
  for (const VertexId v : touched) {
    if (v.value >= k.vertex_count()) continue;  // merged away, and its id was the last
    diagonal_[v.value].setZero();
    if (!k.a_corner(v)) continue;
    auto corners = topology::star(k, v);
    std::sort(corners.begin(), corners.end());  // the order of summation of a new operator
    for (const CornerId corner : corners) diagonal_[v.value] += diagonal_share(corner);
  }
}

Eigen::Matrix3d ElasticOperator::displacement_gradient(std::size_t cell,
                                                       const Eigen::VectorXd& u) const {
  const topology::Cell<3>& v = cells_[cell];
  const Eigen::Vector3d u0 = u.segment<3>(first_entry(v[0]));
  Eigen::Matrix3d differences;  // U of Equation (1)
  differences.col(0) = u.segment<3>(first_entry(v[1])) - u0;
  differences.col(1) = u.segment<3>(first_entry(v[2])) - u0;
  differences.col(2) = u.segment<3>(first_entry(v[3])) - u0;
  return differences * gradients_[cell];
}

void ElasticOperator::apply(const Eigen::VectorXd& u, Eigen::VectorXd& f) const {
  require_size(u, size());
  f.setZero(size());
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    const topology::Cell<3>& v = cells_[c];
    const Eigen::Matrix3d forces =
        stress(displacement_gradient(c, u), table_[material_[c]]) * gradients_[c].transpose();
    f.segment<3>(first_entry(v[0])) -= forces.rowwise().sum();
    f.segment<3>(first_entry(v[1])) += forces.col(0);
    f.segment<3>(first_entry(v[2])) += forces.col(1);
    f.segment<3>(first_entry(v[3])) += forces.col(2);
  }
}

double ElasticOperator::energy(const Eigen::VectorXd& u) const {
  require_size(u, size());
  double twice = 0.0;
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    const Eigen::Matrix3d gradient = displacement_gradient(c, u);
    const Lame& material = table_[material_[c]];
    const double trace = gradient.trace();
    const Eigen::Matrix3d deviator =
        0.5 * (gradient + gradient.transpose()) - (trace / 3.0) * Eigen::Matrix3d::Identity();
    // Deviator and trace apart: no term is negative, whatever the sign of lambda.
    twice += 2.0 * material.mu * deviator.squaredNorm() +
             (material.lambda + 2.0 / 3.0 * material.mu) * trace * trace;
  }
  return 0.5 * twice;
}

Eigen::Vector3d ElasticOperator::scaled_gradient(CellId cell, int i) const {
  const Gradients& g = gradients_[cell.value];
  if (i == 0) return -g.colwise().sum().transpose();
  return g.row(i - 1).transpose();
}

Eigen::Matrix3d ElasticOperator::diagonal_share(CornerId corner) const {
  const CellId cell = topology::cell_of<3>(corner);
  const Lame& material = table_[material_[cell.value]];
  const Eigen::Vector3d g = scaled_gradient(cell, topology::local_index<3>(corner));
  Eigen::Matrix3d block = (material.lambda + material.mu) * g * g.transpose();
  block.diagonal().array() += material.mu * g.squaredNorm();
  return block;
}

CellStiffness ElasticOperator::cell_stiffness(CellId cell) const {
  const Lame& material = table_[material_[cell.value]];
  CellStiffness matrix;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const Eigen::Vector3d gi = scaled_gradient(cell, i), gj = scaled_gradient(cell, j);
      Eigen::Matrix3d block =
          material.lambda * gi * gj.transpose() + material.mu * gj * gi.transpose();
      block.diagonal().array() += material.mu * gi.dot(gj);
      matrix.block<3, 3>(3 * i, 3 * j) = block;
    }
  return matrix;
}

}  // namespace cleave::fem
