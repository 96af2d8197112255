#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <map>
#include <span>
#include <stdexcept>
#include <vector>

#include "cleave/topology/ids.hpp"
#include "cleave/topology/relabelling.hpp"

namespace cleave::fem {

/// Two different values were prescribed for one coordinate.
class ContradictorySupport : public std::invalid_argument {
 public:
  ContradictorySupport(topology::VertexId at, int along, double first, double second);
  topology::VertexId vertex;
  int axis;
  double earlier, later;
};

/// Two vertices that are to be merged have different values prescribed along an axis.
struct SupportConflict {
  topology::VertexId one, other;
  int axis;
  double value_of_one, value_of_other;
};

/// Prescribed displacements of single coordinates: the set B and the values p of the paper's
/// Equation (2). Axes are 0, 1, 2 for x, y, z; values are displacements in the unit of the points.
class Dirichlet {
 public:
  /// Prescribes one coordinate. The same value again changes nothing. Throws ContradictorySupport
  /// for another value, std::invalid_argument for a value that is not finite or an axis not in
  /// 0..2.
  void prescribe(topology::VertexId vertex, int axis, double value);

  /// All three coordinates of `vertex` at `value`.
  void prescribe(topology::VertexId vertex, const Eigen::Vector3d& value);

  /// Follows a change of the complex: what is prescribed at a vertex holds for all its copies, and
  /// moves to the vertex that a copy is merged into. Throws ContradictorySupport if merged copies
  /// disagree, and then nothing has changed. Time: the prescribed coordinates, and the splits and
  /// merges times a logarithm.
  void carry_over(const topology::Relabelling& change);

  /// What forbids these merges, which a stitch plans (topology::Incision::planned_merges) or made:
  /// for each vertex that stays and each axis, the first two that disagree of those that become
  /// one; ascending. Empty: carry_over will not throw. Time: the merges times a logarithm.
  std::vector<SupportConflict> conflicts(std::span<const topology::Merge> merges) const;

  bool prescribes(topology::VertexId vertex, int axis) const {
    return values_.count(coordinate(vertex, axis)) != 0;
  }
  std::size_t size() const { return values_.size(); }
  bool empty() const { return values_.empty(); }

  /// Coordinate 3*vertex + axis -> value, ascending.
  const std::map<std::size_t, double>& values() const { return values_; }

  /// Sets the prescribed coordinates of `u` to their values. Throws std::invalid_argument if one of
  /// them lies beyond the end of `u`.
  void impose(Eigen::VectorXd& u) const;

  /// Sets the prescribed coordinates of `v` to zero: the orthogonal projection onto displacements
  /// that keep the supports still. Throws as `impose`.
  void project(Eigen::VectorXd& v) const;

 private:
  void require_within(Eigen::Index size) const;

  static std::size_t coordinate(topology::VertexId vertex, int axis) {
    return 3 * static_cast<std::size_t>(vertex.value) + static_cast<std::size_t>(axis);
  }
  std::map<std::size_t, double> values_;
};

}  // namespace cleave::fem
