#include "geometry_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "body.hpp"
#include "cleave/cutting/predicates.hpp"
#include "file_words.hpp"

namespace cleave::app {
namespace {

using Vector = std::array<double, 3>;

Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double length(const Vector& a) { return std::hypot(a[0], a[1], a[2]); }

// The points of one cell; D+1 of them count.
struct Corners {
  int dimension;
  std::array<Vector, 4> p;

  double longest_edge() const {
    double longest = 0;
    for (int i = 0; i <= dimension; ++i)
      for (int j = 0; j < i; ++j) longest = std::max(longest, length(minus(at(i), at(j))));
    return longest;
  }

  // The sign of the volume or area, exact; +1 for a kind of cell that has no sign.
  int sign(bool planar) const {
    if (dimension == 3) return cutting::orient3d(p[0], p[1], p[2], p[3]);
    if (dimension == 2 && planar)
      return cutting::orient2d({p[0][0], p[0][1]}, {p[1][0], p[1][1]}, {p[2][0], p[2][1]});
    return 1;
  }

  // The least height, the longest edge being 1: D! * volume over (D-1)! * the largest facet. Scaled
  // first, so that nothing overflows.
  double least_height(double longest) const {
    if (longest == 0) return 0;
    std::array<Vector, 4> q{};
    for (int i = 1; i <= dimension; ++i)
      for (std::size_t x = 0; x < 3; ++x)
        q[static_cast<std::size_t>(i)][x] = at(i)[x] / longest - p[0][x] / longest;
    if (dimension == 1) return 1;
    const double base = length(cross(q[1], q[2]));
    if (dimension == 2) return base;  // over the longest edge, which is 1
    const double largest = std::max({base, length(cross(q[1], q[3])), length(cross(q[2], q[3])),
                                     length(cross(minus(q[2], q[1]), minus(q[3], q[1])))});
    const Vector n = cross(q[1], q[2]);
    return largest == 0 ? 0 : std::abs(n[0] * q[3][0] + n[1] * q[3][1] + n[2] * q[3][2]) / largest;
  }

 private:
  const Vector& at(int i) const { return p[static_cast<std::size_t>(i)]; }
};

Finding not_finite(const Mesh& mesh, Index v, std::size_t axis) {
  const std::string name(1, "xyz"[axis]);
  const double value = mesh.points[v][axis];
  return {
      "not-finite",
      Severity::error,
      fmt::format("vertex {} has {} = {}", mesh.vertex_numbers[v], name, value),
      {{"vertex", mesh.vertex_numbers[v]}, {"axis", name}, {"value", fmt::format("{}", value)}}};
}

Finding about_cell(const Mesh& mesh, Index cell, const char* rule, double height) {
  const auto number = cell_number(mesh, {cell});
  const auto vertices = cell_vertices(mesh, {cell});
  const bool flat = std::string_view(rule) == "flat-cell";
  return {rule,
          Severity::error,
          flat ? fmt::format("cell {} ({}) is flat: its least height is {:.3g} of its longest edge",
                             number, listed(vertices), height)
               : fmt::format("cell {} ({}) is inverted: its vertices are in mirrored order", number,
                             listed(vertices)),
          {{"cell", number}, {"vertices", vertices}, {"relative_height", height}}};
}

}  // namespace

std::vector<Finding> check_geometry(const Mesh& mesh, double flat_ratio) {
  std::vector<Finding> not_finite_ones, inverted, flat;
  std::vector<bool> finite(mesh.points.size(), true);
  for (Index v = 0; v < mesh.points.size(); ++v)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (std::isfinite(mesh.points[v][axis])) continue;
      finite[v] = false;
      not_finite_ones.push_back(not_finite(mesh, v, axis));
    }

  const bool planar = is_planar(mesh);
  const auto corners = static_cast<std::size_t>(mesh.dimension) + 1;
  for (Index c = 0; c < mesh.cells().size(); ++c) {
    const Index* tuple = &mesh.cells().vertices[corners * c];
    Corners cell{mesh.dimension, {}};
    bool sound = true;
    for (std::size_t i = 0; i < corners; ++i) {
      sound = sound && finite[tuple[i]] && std::find(tuple, tuple + i, tuple[i]) == tuple + i;
      cell.p[i] = mesh.points[tuple[i]];
    }
    if (!sound) continue;
    const int sign = cell.sign(planar);
    const double height = sign == 0 ? 0 : cell.least_height(cell.longest_edge());
    if (sign == 0 || height < flat_ratio)
      flat.push_back(about_cell(mesh, c, "flat-cell", height));
    else if (sign < 0)
      inverted.push_back(about_cell(mesh, c, "inverted-cell", height));
  }

  std::vector<Finding> findings = std::move(inverted);
  findings.insert(findings.end(), flat.begin(), flat.end());
  findings.insert(findings.end(), not_finite_ones.begin(), not_finite_ones.end());
  return findings;
}

}  // namespace cleave::app
