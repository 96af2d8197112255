#include "cleave/fem/loads.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>

#include "geometry.hpp"

namespace cleave::fem {

using topology::VertexId;

namespace {

void require_used(const topology::Complex<3>& k, VertexId vertex) {
  if (vertex.value >= k.vertex_count())
    throw std::invalid_argument("a force is given for vertex " + std::to_string(vertex.value) +
                                ", but there are only " + std::to_string(k.vertex_count()) +
                                " vertices");
  if (!k.a_corner(vertex))
    throw std::invalid_argument("a force is given for vertex " + std::to_string(vertex.value) +
                                ", which no cell uses");
}

Eigen::Ref<Eigen::Vector3d> entries_of(Eigen::VectorXd& f, VertexId vertex) {
  return f.segment<3>(3 * static_cast<Eigen::Index>(vertex.value));
}

void add_traction(const topology::Complex<3>& k, Points points, const Traction& load,
                  Eigen::VectorXd& f) {
  if (load.half_facet.value >= k.half_facet_count() || k.is_interior(load.half_facet))
    throw std::invalid_argument("a traction is given for half-facet " +
                                std::to_string(load.half_facet.value) +
                                ", which is not on the boundary");
  const topology::Facet<3> facet = k.facet(load.half_facet);
  const Eigen::Vector3d origin = as_vector(points[facet[0].value]);
  const Eigen::Vector3d one = as_vector(points[facet[1].value]) - origin;
  const Eigen::Vector3d other = as_vector(points[facet[2].value]) - origin;
  const double area = 0.5 * one.cross(other).norm();
  for (const VertexId v : facet) entries_of(f, v) += (area / 3.0) * load.traction;
}

void require_density(const topology::Complex<3>& k, const std::vector<double>& density) {
  if (density.size() != k.cell_count())
    throw std::invalid_argument("gravity needs the density of each of the " +
                                std::to_string(k.cell_count()) + " cells, there are " +
                                std::to_string(density.size()));
  for (std::size_t c = 0; c < density.size(); ++c)
    if (!(std::isfinite(density[c]) && density[c] >= 0.0))
      throw std::invalid_argument("the density of cell " + std::to_string(c) +
                                  " must be finite and not negative, it is " +
                                  std::to_string(density[c]));
}

/// Splits of `change`, by parent: the parent and all its copies.
std::map<VertexId, std::vector<VertexId>> families(const topology::Relabelling& change) {
  std::map<VertexId, std::vector<VertexId>> by_parent;
  for (const topology::Split& split : change.splits) {
    auto& family = by_parent[split.parent];
    if (family.empty()) family.push_back(split.parent);
    family.push_back(split.vertex);
  }
  return by_parent;
}

}  // namespace

std::vector<NodalForce> share_force(const topology::Complex<3>& k, Points points,
                                    std::span<const VertexId> vertices,
                                    const Eigen::Vector3d& total) {
  require_one_point_per_vertex(k, points);
  if (vertices.empty()) throw std::invalid_argument("a force is given for no vertex at all");
  std::vector<VertexId> distinct(vertices.begin(), vertices.end());
  std::sort(distinct.begin(), distinct.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());

  std::vector<double> volumes;
  double sum = 0.0;
  for (const VertexId v : distinct) {
    require_used(k, v);
    volumes.push_back(star_volume(k, points, v));
    sum += volumes.back();
  }
  std::vector<NodalForce> shares;
  for (std::size_t i = 0; i < distinct.size(); ++i)
    shares.push_back({distinct[i], (volumes[i] / sum) * total});
  return shares;
}

Eigen::VectorXd force_vector(const topology::Complex<3>& k, Points points, const Loads& loads) {
  require_one_point_per_vertex(k, points);
  Eigen::VectorXd f = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(k.vertex_count()));
  for (const NodalForce& load : loads.nodal) {
    require_used(k, load.vertex);
    entries_of(f, load.vertex) += load.force;
  }
  for (const Traction& load : loads.tractions) add_traction(k, points, load, f);
  if (loads.gravity == Eigen::Vector3d::Zero()) return f;

  require_density(k, loads.density);
  for (topology::Index c = 0; c < k.cell_count(); ++c) {
    const double mass = loads.density[c] * cell_volume(k, points, {c});
    for (const VertexId v : k.vertices({c})) entries_of(f, v) += (mass / 4.0) * loads.gravity;
  }
  return f;
}

void carry_over(Loads& loads, const topology::Complex<3>& k, Points points,
                const topology::Relabelling& change) {
  const auto split = families(change);
  std::map<VertexId, Eigen::Vector3d> into;  // forces on vertices that others are merged into
  for (const topology::Merge& merge : change.merges)
    into.emplace(merge.into, Eigen::Vector3d::Zero());

  std::vector<NodalForce> carried;
  for (const NodalForce& load : loads.nodal) {
    if (const auto sum = into.find(change.merged(load.vertex)); sum != into.end()) {
      sum->second += load.force;
      continue;
    }
    const auto family = split.find(load.vertex);
    if (family == split.end()) {
      carried.push_back(load);
      continue;
    }
    const auto shares = share_force(k, points, family->second, load.force);
    carried.insert(carried.end(), shares.begin(), shares.end());
  }
  for (const auto& [vertex, force] : into)
    if (force != Eigen::Vector3d::Zero()) carried.push_back({vertex, force});
  loads.nodal = std::move(carried);
}

}  // namespace cleave::fem
