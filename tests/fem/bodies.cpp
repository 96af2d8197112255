#include "bodies.hpp"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <variant>

#include "cleave/fem/loads.hpp"
#include "cleave/fem/stiffness.hpp"
#include "cleave/support/meshes.hpp"
#include "cleave/topology/assemble.hpp"
#include "cleave/topology/boundary.hpp"
#include "cleave/topology/carry_over.hpp"
#include "cleave/topology/check.hpp"
#include "cleave/topology/unglue.hpp"

namespace cleave::fem {

using topology::FacetSet;

Body body_of(std::vector<topology::Cell<3>> cells, std::vector<Point> points) {
  topology::CellSoup<3> soup{std::move(cells), points.size(), {}};
  soup.signs = std::get<std::vector<std::int8_t>>(topology::orient(soup));
  auto regularized = topology::assemble_regularized(std::move(soup));
  points.resize(regularized.complex.vertex_count());
  for (const auto& split : regularized.splits)
    points[split.vertex.value] = points[split.parent.value];
  const std::size_t cell_count = regularized.complex.cell_count();
  return {std::move(regularized.complex), std::move(points),
          std::vector<std::uint32_t>(cell_count, 0)};
}

Body cube(int n) { return distorted_cube(n, 0.0); }

namespace {

/// The points of a grid of the unit cube, inner ones moved by up to `amount` of an edge.
std::vector<Point> grid_points(const support::KuhnGrid<3>& grid, double amount, support::Rng& rng) {
  const int n = grid.nodes[0];
  std::vector<Point> points(grid.vertex_count);
  for (topology::Index v = 0; v < grid.vertex_count; ++v) {
    const auto place = grid.point({v});
    const bool is_inner =
        std::all_of(place.begin(), place.end(), [n](int x) { return x > 0 && x < n - 1; });
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double shift = is_inner ? amount * (2.0 * rng.unit() - 1.0) : 0.0;
      points[v][axis] = (place[axis] + shift) / (n - 1);
    }
  }
  return points;
}

}  // namespace

Body distorted_cube(int n, double amount, std::uint64_t seed) {
  const support::KuhnGrid<3> grid({n, n, n});
  support::Rng rng(seed);
  return body_of(grid.cells, grid_points(grid, amount, rng));
}

Body random_body(support::Rng& rng) {
  const int n = rng.between(2, 5);
  const support::KuhnGrid<3> grid({n, n, n});
  const double density = 0.3 + 0.7 * rng.unit();
  std::vector<topology::Cell<3>> cells;
  for (const auto& cell : grid.cells)
    if (cells.empty() || rng.chance(density)) cells.push_back(cell);
  return body_of(std::move(cells), grid_points(grid, 0.15, rng));
}

Body medit_body(const std::string& path) {
  std::ifstream file(path);
  std::string word;
  std::vector<Point> points;
  std::vector<topology::Cell<3>> cells;
  std::vector<std::uint32_t> labels;
  while (file >> word && word != "Vertices") {
  }
  std::size_t count = 0;
  std::uint32_t label = 0;
  file >> count;
  for (Point p; points.size() < count && file >> p[0] >> p[1] >> p[2] >> label;)
    points.push_back(p);
  while (file >> word && word != "Tetrahedra") {
  }
  file >> count;
  for (std::array<topology::Index, 4> v{};
       cells.size() < count && file >> v[0] >> v[1] >> v[2] >> v[3] >> label;) {
    cells.push_back({VertexId{v[0] - 1}, {v[1] - 1}, {v[2] - 1}, {v[3] - 1}});
    labels.push_back(label);
  }
  if (cells.empty() || cells.size() != count) throw std::runtime_error("cannot read " + path);
  Body body = body_of(std::move(cells), std::move(points));
  body.labels = std::move(labels);
  return body;
}

Point centroid(const Body& body, CellId cell) {
  Point sum{};
  for (const VertexId v : body.k.vertices(cell))
    for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += body.points[v.value][axis] / 4.0;
  return sum;
}

Materials layered(const Body& body, int layers, const Lame& even, const Lame& odd) {
  Materials materials{{even, odd}, {}};
  for (topology::Index c = 0; c < body.k.cell_count(); ++c)
    materials.of_cell.push_back(static_cast<int>(centroid(body, {c})[2] * layers) % 2);
  return materials;
}

Scene under_its_weight(Body body) {
  Scene scene{std::move(body), {}, {}};
  scene.supports = clamped(vertices_where(scene.body, [](const Point& p) { return p[2] == 0.0; }));
  Loads loads;
  loads.gravity = {0.3, 0.1, -1.0};
  loads.density.assign(scene.body.k.cell_count(), 1.0);
  scene.force = force_vector(scene.body.k, scene.body.points, loads);
  return scene;
}

FacetSet facets_between(const Body& body, const std::function<bool(const Point&)>& chosen) {
  std::vector<HalfFacetId> facets;
  for (topology::Index h = 0; h < body.k.half_facet_count(); ++h) {
    const auto mate = body.k.mate({h});
    if (!mate || mate->value < h) continue;
    if (chosen(centroid(body, topology::cell_of<3>({h}))) !=
        chosen(centroid(body, topology::cell_of<3>(*mate))))
      facets.push_back({h});
  }
  return FacetSet::of_lesser(std::move(facets));
}

FacetSet random_cut(const Complex<3>& k, support::Rng& rng) {
  const double density = rng.unit();
  std::vector<HalfFacetId> facets;
  const FacetSet every = FacetSet::all(k);
  for (const HalfFacetId h : every.half_facets())
    if (rng.chance(density)) facets.push_back(h);
  return FacetSet::of_lesser(std::move(facets));
}

topology::Relabelling cut(Body& body, const FacetSet& facets) {
  auto change = topology::unglue(body.k, facets);
  topology::carry_over(body.points, change);
  return change;
}

std::vector<VertexId> vertices_where(const Body& body,
                                     const std::function<bool(const Point&)>& chosen) {
  std::vector<VertexId> vertices;
  for (topology::Index v = 0; v < body.points.size(); ++v)
    if (body.k.a_corner({v}) && chosen(body.points[v])) vertices.push_back({v});
  return vertices;
}

Dirichlet clamped(const std::vector<VertexId>& vertices) {
  Dirichlet supports;
  for (const VertexId v : vertices) supports.prescribe(v, Eigen::Vector3d::Zero());
  return supports;
}

std::vector<VertexId> boundary_vertices(const Complex<3>& k) {
  std::vector<VertexId> vertices;
  for (const HalfFacetId h : topology::boundary(k))
    for (const VertexId v : k.facet(h)) vertices.push_back(v);
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

ElasticOperator uniform_operator(const Body& body, const Lame& material) {
  return {body.k, body.points, Materials::uniform(body.k.cell_count(), material)};
}

Eigen::VectorXd sample(const Body& body,
                       const std::function<Eigen::Vector3d(const Point&)>& value) {
  Eigen::VectorXd samples(3 * static_cast<Eigen::Index>(body.points.size()));
  for (std::size_t v = 0; v < body.points.size(); ++v)
    samples.segment<3>(3 * static_cast<Eigen::Index>(v)) = value(body.points[v]);
  return samples;
}

Eigen::VectorXd random_vector(Eigen::Index size, support::Rng& rng) {
  Eigen::VectorXd v(size);
  for (double& entry : v) entry = 2.0 * rng.unit() - 1.0;
  return v;
}

Eigen::MatrixXd rigid_modes_of(const Body& body) {
  Eigen::MatrixXd modes(3 * static_cast<Eigen::Index>(body.points.size()), 6);
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d along = Eigen::Vector3d::Unit(axis);
    modes.col(axis) = sample(body, [&](const Point&) { return along; });
    modes.col(3 + axis) = sample(body, [&](const Point& p) -> Eigen::Vector3d {
      return along.cross(Eigen::Vector3d(p[0] - 0.5, p[1] - 0.5, p[2] - 0.5));
    });
  }
  return modes;
}

Eigen::VectorXd direct_solution(const ElasticOperator& k_operator, const Dirichlet& supports,
                                const Eigen::VectorXd& force) {
  Eigen::VectorXd u = Eigen::VectorXd::Zero(force.size());
  supports.impose(u);
  Eigen::SparseMatrix<double> matrix = assemble_stiffness(k_operator);
  Eigen::VectorXd load = force - matrix * u;
  supports.project(load);
  std::vector<bool> is_fixed(static_cast<std::size_t>(force.size()), false);
  for (const auto& [at, value] : supports.values()) is_fixed[at] = true;
  matrix.prune([&](Eigen::Index i, Eigen::Index j, double) {
    return i == j ||
           !(is_fixed[static_cast<std::size_t>(i)] || is_fixed[static_cast<std::size_t>(j)]);
  });
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(matrix);
  if (factors.info() != Eigen::Success) throw std::runtime_error("K cannot be factorised");
  return u + factors.solve(load);
}

}  // namespace cleave::fem
