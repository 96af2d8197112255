#include "cleave/fem/dirichlet.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "cleave/topology/carry_over.hpp"

namespace cleave::fem {

using topology::VertexId;

namespace {

constexpr char kAxes[] = {'x', 'y', 'z'};

std::string contradiction(VertexId vertex, int axis, double first, double second) {
  return "vertex " + std::to_string(vertex.value) + " is prescribed two displacements along " +
         kAxes[axis] + ": " + std::to_string(first) + " and " + std::to_string(second);
}

}  // namespace

ContradictorySupport::ContradictorySupport(VertexId at, int along, double first, double second)
    : std::invalid_argument(contradiction(at, along, first, second)),
      vertex(at),
      axis(along),
      earlier(first),
      later(second) {}

void Dirichlet::prescribe(VertexId vertex, int axis, double value) {
  if (axis < 0 || axis > 2)
    throw std::invalid_argument("axis " + std::to_string(axis) + " is none of 0, 1, 2 (x, y, z)");
  if (!std::isfinite(value))
    throw std::invalid_argument("the displacement prescribed at vertex " +
                                std::to_string(vertex.value) + " along " + kAxes[axis] +
                                " is not finite");
  const auto [at, is_new] = values_.try_emplace(coordinate(vertex, axis), value);
  if (!is_new && at->second != value) throw ContradictorySupport(vertex, axis, at->second, value);
}

void Dirichlet::prescribe(VertexId vertex, const Eigen::Vector3d& value) {
  for (int axis = 0; axis < 3; ++axis) prescribe(vertex, axis, value[axis]);
}

void Dirichlet::carry_over(const topology::Relabelling& change) {
  Dirichlet result = *this;
  for (const topology::Merge& merge : change.merges)
    for (int axis = 0; axis < 3; ++axis) {
      const auto gone = result.values_.find(coordinate(merge.vertex, axis));
      if (gone == result.values_.end()) continue;
      const double value = gone->second;
      result.values_.erase(gone);
      result.prescribe(merge.into, axis, value);
    }
  for (const topology::Split& split : change.splits)
    for (int axis = 0; axis < 3; ++axis) {
      const auto parent = result.values_.find(coordinate(split.parent, axis));
      if (parent != result.values_.end()) result.prescribe(split.vertex, axis, parent->second);
    }
  *this = std::move(result);
}

std::vector<SupportConflict> Dirichlet::conflicts(std::span<const topology::Merge> merges) const {
  std::vector<SupportConflict> found;
  topology::detail::for_each_merged(merges, [&](std::span<const VertexId> vertices) {
    for (int axis = 0; axis < 3; ++axis) {
      auto first = values_.end();
      for (const VertexId v : vertices) {
        const auto at = values_.find(coordinate(v, axis));
        if (at == values_.end()) continue;
        if (first == values_.end()) first = at;
        if (first->second == at->second) continue;
        const VertexId one{static_cast<topology::Index>(first->first / 3)};
        found.push_back({one, v, axis, first->second, at->second});
        break;
      }
    }
  });
  return found;
}

void Dirichlet::require_within(Eigen::Index size) const {
  if (values_.empty()) return;
  const std::size_t last = values_.rbegin()->first;
  if (last >= static_cast<std::size_t>(size))
    throw std::invalid_argument("vertex " + std::to_string(last / 3) +
                                " has a prescribed displacement, but there are only " +
                                std::to_string(size / 3) + " vertices");
}

void Dirichlet::impose(Eigen::VectorXd& u) const {
  require_within(u.size());
  for (const auto& [at, value] : values_) u[static_cast<Eigen::Index>(at)] = value;
}

void Dirichlet::project(Eigen::VectorXd& v) const {
  require_within(v.size());
  for (const auto& [at, value] : values_) v[static_cast<Eigen::Index>(at)] = 0.0;
}

}  // namespace cleave::fem
