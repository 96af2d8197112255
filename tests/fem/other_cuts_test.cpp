// The other two ways to cut in Figure 1 of the paper, tried on its cube: removing the cells that
// the blade meets, and subdividing them along it; beside the cut along facets.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <utility>
#include <vector>

#include "bodies.hpp"
#include "cleave/fem/stiffness.hpp"

namespace cleave::fem {
namespace {

using topology::Cell;

/// Heights over a plane that passes near the middle of the cube and through no vertex.
std::vector<double> heights(const Body& body, const Eigen::Vector3d& normal) {
  std::vector<double> result;
  for (const Point& p : body.points)
    result.push_back(normal.dot(Eigen::Vector3d(p[0] - 0.53, p[1] - 0.52, p[2] - 0.51)));
  return result;
}

/// The vertices of a cell above and below.
std::array<std::vector<VertexId>, 2> sides(const Cell<3>& cell, const std::vector<double>& height) {
  std::array<std::vector<VertexId>, 2> result;
  for (const VertexId v : cell) result[height[v.value] > 0.0 ? 0 : 1].push_back(v);
  return result;
}

/// A mesh in which the cells that the plane meets are divided along it.
class Subdivision {
 public:
  Subdivision(const Body& body, const std::vector<double>& height)
      : points_(body.points), height_(height) {
    for (const Cell<3>& cell : body.k.cells()) {
      auto [one, other] = sides(cell, height);
      if (one.empty() || other.empty()) {
        cells.push_back(cell);
      } else if (one.size() == 2) {
        const VertexId a = one[0], b = one[1], c = other[0], d = other[1];
        wedge({a, meet(a, c), meet(a, d)}, {b, meet(b, c), meet(b, d)});
        wedge({c, meet(a, c), meet(b, c)}, {d, meet(a, d), meet(b, d)});
      } else {
        if (one.size() == 3) std::swap(one, other);
        const VertexId a = one[0];
        const Triangle cut{meet(a, other[0]), meet(a, other[1]), meet(a, other[2])};
        cells.push_back({a, cut[0], cut[1], cut[2]});
        wedge(cut, {other[0], other[1], other[2]});
      }
    }
  }

  std::vector<Cell<3>> cells;
  const std::vector<Point>& points() const { return points_; }

 private:
  using Triangle = std::array<VertexId, 3>;

  /// The vertex where the plane meets an edge.
  VertexId meet(VertexId a, VertexId b) {
    const auto [at, is_new] = meets_.try_emplace(
        std::minmax(a, b), VertexId{static_cast<topology::Index>(points_.size())});
    if (is_new) {
      const double share = height_[a.value] / (height_[a.value] - height_[b.value]);
      Point p{};
      for (std::size_t i = 0; i < 3; ++i)
        p[i] = points_[a.value][i] + share * (points_[b.value][i] - points_[a.value][i]);
      points_.push_back(p);
    }
    return at->second;
  }

  /// Three tetrahedra. The diagonal of a quadrangle starts at its least vertex, so that the cells
  /// on both sides of it agree.
  void wedge(Triangle u, Triangle w) {
    if (std::min({w[0], w[1], w[2]}) < std::min({u[0], u[1], u[2]})) std::swap(u, w);
    while (u[0] != std::min({u[0], u[1], u[2]})) {
      std::rotate(u.begin(), u.begin() + 1, u.end());
      std::rotate(w.begin(), w.begin() + 1, w.end());
    }
    cells.push_back({u[0], w[0], w[1], w[2]});
    if (std::min(u[1], w[2]) < std::min(u[2], w[1])) {
      cells.push_back({u[0], u[1], u[2], w[2]});
      cells.push_back({u[0], u[1], w[1], w[2]});
    } else {
      cells.push_back({u[0], u[1], u[2], w[1]});
      cells.push_back({u[0], u[2], w[1], w[2]});
    }
  }

  std::vector<Point> points_;
  const std::vector<double>& height_;
  std::map<std::pair<VertexId, VertexId>, VertexId> meets_;
};

double volume(const Body& body, CellId cell) {
  Eigen::Matrix3d x;
  const Cell<3>& v = body.k.vertices(cell);
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) {
      const auto axis = static_cast<std::size_t>(i);
      x(i, j) = body.points[v[static_cast<std::size_t>(j) + 1].value][axis] -
                body.points[v[0].value][axis];
    }
  return std::abs(x.determinant()) / 6.0;
}

double volume(const Body& body) {
  double sum = 0.0;
  for (topology::Index c = 0; c < body.k.cell_count(); ++c) sum += volume(body, {c});
  return sum;
}

double least_volume(const Body& body) {
  double least = 1.0;
  for (topology::Index c = 0; c < body.k.cell_count(); ++c)
    least = std::min(least, volume(body, {c}));
  return least;
}

/// Of K with the bottom of the cube held; lambda = mu = 1.
double condition_number(const Body& body) {
  const auto held = vertices_where(body, [](const Point& p) { return p[2] == 0.0; });
  std::vector<Eigen::Index> free;
  for (topology::Index v = 0; v < body.points.size(); ++v)
    if (!std::binary_search(held.begin(), held.end(), VertexId{v}))
      for (Eigen::Index i = 0; i < 3; ++i) free.push_back(3 * Eigen::Index{v} + i);
  const Eigen::MatrixXd k =
      Eigen::MatrixXd(assemble_stiffness(uniform_operator(body, {1.0, 1.0})))(free, free);
  const Eigen::VectorXd values =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(k, Eigen::EigenvaluesOnly).eigenvalues();
  return values.maxCoeff() / values.minCoeff();
}

TEST(OtherWaysToCut, RemovalLosesMassAndSubdivisionGrowsTheMeshAndTheConditionNumber) {
  for (const Eigen::Vector3d& normal : {Eigen::Vector3d(1.0, 0.3, 0.2), {1.0, 0.8, 0.1}}) {
    const Body whole = cube(5);
    const auto height = heights(whole, normal);
    const double whole_condition = condition_number(whole);

    double lost = 0.0;
    for (topology::Index c = 0; c < whole.k.cell_count(); ++c) {
      const auto [one, other] = sides(whole.k.vertices({c}), height);
      if (!one.empty() && !other.empty()) lost += volume(whole, {c});
    }

    const Subdivision divided(whole, height);
    Body parts = body_of(divided.cells, divided.points());
    const auto above = [&](const Point& p) {
      return normal.dot(Eigen::Vector3d(p[0] - 0.53, p[1] - 0.52, p[2] - 0.51)) > 0.0;
    };
    cut(parts, facets_between(parts, above));
    const double parts_condition = condition_number(parts);

    Body along_facets = whole;
    cut(along_facets, facets_between(along_facets, above));
    const double facets_condition = condition_number(along_facets);

    std::printf(
        "removal: %.0f %% of the volume; subdivision: %zu cells of %zu, least volume %.1e of "
        "%.1e, condition number %.0f of %.0f; along facets: %zu cells, %.0f\n",
        100.0 * lost, parts.k.cell_count(), whole.k.cell_count(), least_volume(parts),
        least_volume(whole), parts_condition, whole_condition, along_facets.k.cell_count(),
        facets_condition);
    EXPECT_NEAR(volume(parts), 1.0, 1e-12);
    EXPECT_NEAR(volume(along_facets), 1.0, 1e-12);
    EXPECT_EQ(along_facets.k.cell_count(), whole.k.cell_count());
    EXPECT_GT(lost, 0.1);
    EXPECT_GT(parts.k.cell_count(), 3 * whole.k.cell_count() / 2);
    EXPECT_GT(parts_condition, 10.0 * facets_condition);
  }
}

}  // namespace
}  // namespace cleave::fem
