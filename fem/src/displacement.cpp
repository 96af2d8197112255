#include "cleave/fem/displacement.hpp"

#include <map>
#include <stdexcept>
#include <string>

#include "geometry.hpp"

namespace cleave::fem {

using topology::VertexId;

namespace {

/// What is merged into a vertex: its volume, and its displacement times that.
struct Merged {
  double volume = 0.0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
};

}  // namespace

void carry_over(Eigen::VectorXd& u, const topology::Complex<3>& k, Points points,
                const topology::Relabelling& change) {
  require_one_point_per_vertex(k, points);
  if (u.size() != 3 * static_cast<Eigen::Index>(change.vertices_before) ||
      k.vertex_count() != change.vertices_after)
    throw std::invalid_argument("a displacement with " + std::to_string(u.size()) +
                                " entries cannot follow a change from " +
                                std::to_string(change.vertices_before) + " to " +
                                std::to_string(change.vertices_after) +
                                " vertices, the complex has " + std::to_string(k.vertex_count()));
  const auto at = [&](VertexId vertex) {
    return u.segment<3>(3 * static_cast<Eigen::Index>(vertex.value));
  };

  std::map<VertexId, Merged> merged;
  if (!change.merges.empty())
    for (const topology::RenamedCorner& renamed : change.corners) {
      const double volume = cell_volume(k, points, topology::cell_of<3>(renamed.corner));
      Merged& into = merged[renamed.to];
      into.volume += volume;
      into.moment += volume * at(renamed.from);
    }
  for (const auto& [vertex, gone] : merged) {
    const double whole = star_volume(k, points, vertex);
    at(vertex) = ((whole - gone.volume) * at(vertex) + gone.moment) / whole;
  }
  u.conservativeResize(3 * static_cast<Eigen::Index>(change.vertices_after));
  for (const topology::Split& split : change.splits) at(split.vertex) = at(split.parent);
}

}  // namespace cleave::fem
