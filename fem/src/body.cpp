#include "cleave/fem/body.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "cleave/topology/pieces.hpp"
#include "geometry.hpp"

namespace cleave::fem {

using topology::CellId;
using topology::Complex;
using topology::VertexId;

namespace {

struct Words {
  std::string operator()(const PointNotFinite& f) const {
    return "vertex " + std::to_string(f.vertex.value) + " of cell " + std::to_string(f.cell.value) +
           " has a coordinate that is not finite";
  }
  std::string operator()(const FlatCell& f) const {
    return "cell " + std::to_string(f.cell.value) + " is flat: it has no volume";
  }
  std::string operator()(const InvertedCell& f) const {
    return "cell " + std::to_string(f.cell.value) +
           " is turned inside out against the other cells of its piece";
  }
  std::string operator()(const BadMaterial& f) const {
    return "material " + std::to_string(f.material) +
           " needs mu > 0 and 3 lambda + 2 mu > 0, both finite; lambda is " +
           std::to_string(f.value.lambda) + ", mu is " + std::to_string(f.value.mu);
  }
  std::string operator()(const UnknownMaterial& f) const {
    return "cell " + std::to_string(f.cell.value) + " names material " +
           std::to_string(f.material) + ", which the table does not have";
  }
};

std::string describe_all(const std::vector<BodyFlaw>& flaws) {
  constexpr std::size_t kShown = 5;
  std::string text = "the body is not fit for elasticity:";
  for (std::size_t i = 0; i < flaws.size() && i < kShown; ++i) text += "\n  " + describe(flaws[i]);
  if (flaws.size() > kShown) text += "\n  and " + std::to_string(flaws.size() - kShown) + " more";
  return text;
}

/// The vertices of the cells without a finite point, each once.
std::vector<BodyFlaw> points_not_finite(const Complex<3>& k, Points points) {
  std::vector<BodyFlaw> flaws;
  std::vector<bool> seen(points.size(), false);
  for (topology::Index c = 0; c < k.cell_count(); ++c)
    for (const VertexId v : k.vertices({c})) {
      if (seen[v.value]) continue;
      seen[v.value] = true;
      if (!is_finite(points[v.value])) flaws.emplace_back(PointNotFinite{v, {c}});
    }
  return flaws;
}

}  // namespace

std::string describe(const BodyFlaw& flaw) { return std::visit(Words{}, flaw); }

InvalidBody::InvalidBody(std::vector<BodyFlaw> all)
    : std::invalid_argument(describe_all(all)), flaws(std::move(all)) {}

std::vector<BodyFlaw> check_body(const Complex<3>& k, Points points) {
  require_one_point_per_vertex(k, points);
  auto flaws = points_not_finite(k, points);
  if (!flaws.empty()) return flaws;

  const auto pieces = topology::pieces(k);
  std::vector<std::int8_t> side(k.cell_count(), 0);    // geometric orientation; 0: flat
  std::vector<std::int64_t> balance(pieces.count, 0);  // positive minus negative cells
  for (topology::Index c = 0; c < k.cell_count(); ++c) {
    const Eigen::Matrix3d edges = edge_matrix(k, points, {c});
    if (is_flat(edges)) continue;
    side[c] = static_cast<std::int8_t>((edges.determinant() > 0.0 ? 1 : -1) * k.sign({c}));
    balance[pieces.of_cell[c]] += side[c];
  }
  for (topology::Index c = 0; c < k.cell_count(); ++c) {
    const int majority = balance[pieces.of_cell[c]] >= 0 ? 1 : -1;
    if (side[c] == 0)
      flaws.emplace_back(FlatCell{{c}});
    else if (side[c] != majority)
      flaws.emplace_back(InvertedCell{{c}});
  }
  return flaws;
}

std::vector<BodyFlaw> check_materials(const Complex<3>& k, const Materials& materials) {
  if (materials.of_cell.size() != k.cell_count())
    throw std::invalid_argument("there are " + std::to_string(k.cell_count()) +
                                " cells, but materials for " +
                                std::to_string(materials.of_cell.size()));
  std::vector<BodyFlaw> flaws;
  for (std::uint32_t m = 0; m < materials.table.size(); ++m)
    if (!is_positive(materials.table[m])) flaws.emplace_back(BadMaterial{m, materials.table[m]});
  for (topology::Index c = 0; c < k.cell_count(); ++c)
    if (materials.of_cell[c] >= materials.table.size())
      flaws.emplace_back(UnknownMaterial{{c}, materials.of_cell[c]});
  return flaws;
}

double cell_volume(const Complex<3>& k, Points points, CellId cell) {
  return std::abs(edge_matrix(k, points, cell).determinant()) / 6.0;
}

std::vector<double> star_volumes(const Complex<3>& k, Points points) {
  require_one_point_per_vertex(k, points);
  std::vector<double> volumes(k.vertex_count(), 0.0);
  for (topology::Index c = 0; c < k.cell_count(); ++c) {
    const double volume = cell_volume(k, points, {c});
    for (const VertexId v : k.vertices({c})) volumes[v.value] += volume;
  }
  return volumes;
}

}  // namespace cleave::fem
