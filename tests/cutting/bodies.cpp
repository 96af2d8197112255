#include "bodies.hpp"

#include <algorithm>
#include <cleave/support/reference.hpp>

#include "cleave/topology/assemble.hpp"

namespace cleave::cutting::bodies {
namespace {

template <int D>
using Nodes = std::array<int, static_cast<std::size_t>(D)>;

template <int D>
Body<D> assembled(const support::Mesh<D>& mesh, std::vector<Point<D>> points) {
  topology::CellSoup<D> soup;
  soup.cells = mesh.cells;
  soup.vertex_count = mesh.vertex_count;
  soup.signs = *support::coherent_signs<D>(mesh.cells);
  topology::Regularized<D> regularized = topology::assemble_regularized(std::move(soup));
  points.resize(regularized.complex.vertex_count());
  for (const topology::Split& split : regularized.splits)
    points[split.vertex.value] = points[split.parent.value];
  Body<D> body;
  body.k = std::move(regularized.complex);
  body.points = std::move(points);
  return body;
}

/// Where the body's coordinates along `axis` end.
template <int D>
double extent(const Body<D>& body, std::size_t axis) {
  return body.spacing * (body.nodes[axis] - 1);
}

/// A coordinate in or near the body: on the grid, half between, or anywhere.
template <int D>
double any_coordinate(const Body<D>& body, std::size_t axis, Rng& rng) {
  const int steps = body.nodes[axis] - 1;
  switch (rng.below(3)) {
    case 0:
      return body.spacing * rng.between(-1, steps + 1);
    case 1:
      return body.spacing * (rng.between(-1, steps) + 0.5);
    default:
      return body.spacing * (-1 + (steps + 2) * rng.unit());
  }
}

template <int D>
Point<D> any_corner(const Body<D>& body, Rng& rng) {
  const auto cell = topology::CellId{static_cast<topology::Index>(rng.below(body.k.cell_count()))};
  if (rng.chance(0.3)) return dual_point(body.k, body.points, cell);
  if (rng.chance(0.4)) return body.points[body.k.vertices(cell)[rng.below(D + 1)].value];
  Point<D> p;
  for (std::size_t i = 0; i < p.size(); ++i) p[i] = any_coordinate(body, i, rng);
  return p;
}

/// A sheet over the axes other than `up`: positions of the blade along `ahead`, its ends along
/// `across`, with the heights given per position and end.
Sweep<3> sheet(std::array<std::size_t, 3> up_ahead_across, const std::vector<double>& along,
               std::array<double, 2> ends, const std::vector<std::array<double, 2>>& heights) {
  const auto [up, ahead, across] = up_ahead_across;
  std::vector<std::array<Point<3>, 2>> positions(along.size());
  for (std::size_t i = 0; i < along.size(); ++i)
    for (std::size_t end = 0; end < 2; ++end) {
      positions[i][end][up] = heights[i][end];
      positions[i][end][ahead] = along[i];
      positions[i][end][across] = ends[end];
    }
  return sweep_of_blade(positions);
}

Sweep<2> path_along(std::size_t ahead, const std::vector<double>& along,
                    const std::vector<double>& heights) {
  std::vector<Point<2>> points(along.size());
  for (std::size_t i = 0; i < along.size(); ++i) {
    points[i][ahead] = along[i];
    points[i][1 - ahead] = heights[i];
  }
  return sweep_of_polyline(points);
}

/// -reach = along[0] < along[1] < .. = reach
std::vector<double> stations(double low, double high, Rng& rng) {
  std::vector<double> along{low, high};
  for (std::size_t more = rng.below(5); more > 0; --more)
    along.push_back(low + (high - low) * rng.unit());
  std::sort(along.begin(), along.end());
  return along;
}

}  // namespace

template <int D>
Body<D> kuhn(Nodes<D> nodes, double spacing) {
  const support::KuhnGrid<D> grid(nodes);
  std::vector<Point<D>> points(grid.vertex_count);
  for (topology::Index v = 0; v < points.size(); ++v)
    for (std::size_t i = 0; i < nodes.size(); ++i)
      points[v][i] = spacing * grid.point(topology::VertexId{v})[i];
  Body<D> body = assembled<D>(grid, std::move(points));
  body.spacing = spacing;
  body.nodes = nodes;
  return body;
}

template <int D>
Body<D> jittered(Nodes<D> nodes, double spacing, double jitter, Rng& rng) {
  Body<D> body = kuhn<D>(nodes, spacing);
  for (Point<D>& p : body.points)
    for (double& x : p) x += spacing * jitter * (2 * rng.unit() - 1);
  return body;
}

template <int D>
Body<D> part(const Body<D>& body, const std::vector<bool>& keep) {
  const support::Mesh<D> mesh{{body.k.cells().begin(), body.k.cells().end()},
                              body.k.vertex_count()};
  Body<D> rest = assembled<D>(support::sub_mesh(mesh, keep), body.points);
  rest.spacing = body.spacing;
  rest.nodes = body.nodes;
  return rest;
}

template <int D>
Body<D> thinned(const Body<D>& body, double share, Rng& rng) {
  std::vector<bool> keep(body.k.cell_count());
  for (std::size_t c = 0; c < keep.size(); ++c) keep[c] = !rng.chance(share);
  keep[0] = true;
  return part(body, keep);
}

template <int D>
Body<D> any_small(Rng& rng) {
  Nodes<D> nodes;
  for (int& n : nodes) n = rng.between(2, D == 2 ? 7 : 4);
  const double spacing = std::array{1.0, 0.1, 0.3}[rng.below(3)];
  Body<D> body = rng.chance(0.5) ? kuhn<D>(nodes, spacing) : jittered<D>(nodes, spacing, 0.2, rng);
  return rng.chance(0.3) ? thinned(body, 0.2, rng) : body;
}

template <int D>
std::vector<Point<D>> duals(const Body<D>& body) {
  std::vector<Point<D>> result;
  for (topology::Index c = 0; c < body.k.cell_count(); ++c)
    result.push_back(dual_point(body.k, body.points, topology::CellId{c}));
  return result;
}

template <>
Sweep<2> aligned_plane<2>(const Body<2>& body, Nodes<2> normal, double offset) {
  const double c = offset * body.spacing, reach = 2 * (extent(body, 0) + extent(body, 1));
  const std::size_t axis = normal[0] != 0 ? 0 : 1;  // solve for this coordinate
  std::vector<Point<2>> points;
  for (const double other : {-reach, 0.5 * extent(body, 1 - axis), reach}) {
    Point<2> p;
    p[1 - axis] = other;
    p[axis] = normal[axis] * (c - normal[1 - axis] * other);
    points.push_back(p);
  }
  return sweep_of_polyline(points);
}

template <>
Sweep<3> aligned_plane<3>(const Body<3>& body, Nodes<3> normal, double offset) {
  const double c = offset * body.spacing;
  const double reach = 2 * (extent(body, 0) + extent(body, 1) + extent(body, 2));
  const std::size_t axis = normal[0] != 0 ? 0 : normal[1] != 0 ? 1 : 2;
  const std::size_t j = (axis + 1) % 3, k = (axis + 2) % 3;
  const std::vector<double> along{-reach, 0.5 * extent(body, j), reach};
  std::vector<std::array<double, 2>> heights;
  for (const double at : along) {
    const auto height = [&](double across) {
      return normal[axis] * (c - normal[j] * at - normal[k] * across);
    };
    heights.push_back({height(-reach), height(reach)});
  }
  return sheet({axis, j, k}, along, {-reach, reach}, heights);
}

template <>
Sweep<2> full_crossing<2>(const Body<2>& body, Rng& rng) {
  const std::size_t ahead = rng.below(2);
  const double margin = 2 * body.spacing;
  const auto along = stations(-margin, extent(body, ahead) + margin, rng);
  std::vector<double> heights;
  for (std::size_t i = 0; i < along.size(); ++i)
    heights.push_back(extent(body, 1 - ahead) * rng.unit());
  return path_along(ahead, along, heights);
}

template <>
Sweep<3> full_crossing<3>(const Body<3>& body, Rng& rng) {
  const std::size_t up = rng.below(3), ahead = (up + 1 + rng.below(2)) % 3;
  const std::size_t across = 3 - up - ahead;
  const double margin = 2 * body.spacing;
  const auto along = stations(-margin, extent(body, ahead) + margin, rng);
  std::vector<std::array<double, 2>> heights;
  for (std::size_t i = 0; i < along.size(); ++i)
    heights.push_back({extent(body, up) * rng.unit(), extent(body, up) * rng.unit()});
  return sheet({up, ahead, across}, along, {-margin, extent(body, across) + margin}, heights);
}

template <>
Sweep<2> any_path<2>(const Body<2>& body, Rng& rng) {
  std::vector<Point<2>> points;
  for (std::size_t n = 2 + rng.below(4); n > 0; --n) points.push_back(any_corner(body, rng));
  return sweep_of_polyline(points);
}

template <>
Sweep<3> any_path<3>(const Body<3>& body, Rng& rng) {
  std::vector<std::array<Point<3>, 2>> positions;
  for (std::size_t n = 2 + rng.below(3); n > 0; --n)
    positions.push_back({any_corner(body, rng), any_corner(body, rng)});
  return sweep_of_blade(positions);
}

template <int D>
Sweep<D> short_path(const Body<D>& body, Rng& rng) {
  Point<D> middle;
  for (std::size_t i = 0; i < middle.size(); ++i) middle[i] = any_coordinate(body, i, rng);
  Sweep<D> sweep = any_path(body, rng);
  const double reach = std::max({extent(body, 0), extent(body, 1), extent(body, D - 1)});
  for (auto& simplex : sweep.simplices)
    for (Point<D>& p : simplex)
      for (std::size_t i = 0; i < p.size(); ++i)
        p[i] = middle[i] + (p[i] - 0.5 * extent(body, i)) * body.spacing / reach;
  return sweep;
}

template <int D>
Sweep<D> scattered(const Body<D>& body, Rng& rng) {
  Sweep<D> sweep;
  for (std::uint32_t n = 0; n < 4; ++n) {
    auto& simplex = sweep.simplices.emplace_back();
    for (Point<D>& corner : simplex) corner = any_corner(body, rng);
    if (rng.chance(0.1)) simplex.back() = simplex.front();
    sweep.step_of.push_back(n / 2);
  }
  return sweep;
}

template <int D>
Sweep<D> any_sweep(const Body<D>& body, Rng& rng) {
  switch (rng.below(5)) {
    case 0:
      return full_crossing(body, rng);
    case 1:
      return any_path(body, rng);
    case 2:
      return scattered(body, rng);
    case 3:
      return short_path(body, rng);
    default:
      break;
  }
  Nodes<D> normal{};
  normal[rng.below(D)] = 1;
  for (int& n : normal)
    if (rng.chance(0.4)) n = rng.between(-1, 1);
  if (std::all_of(normal.begin(), normal.end(), [](int n) { return n == 0; })) normal[0] = 1;
  return aligned_plane(body, normal, 0.5 * rng.between(0, 2 * body.nodes[0]));
}

template <int D>
Sweep<D> there_and_back(const Sweep<D>& sweep) {
  Sweep<D> both = sweep;
  const auto turn = static_cast<std::uint32_t>(sweep.step_count());
  for (std::size_t i = sweep.simplices.size(); i > 0; --i) {
    both.simplices.push_back(sweep.simplices[i - 1]);
    both.step_of.push_back(2 * turn - 1 - sweep.step_of[i - 1]);
  }
  return both;
}

template Body<2> kuhn(Nodes<2>, double);
template Body<3> kuhn(Nodes<3>, double);
template Body<2> jittered(Nodes<2>, double, double, Rng&);
template Body<3> jittered(Nodes<3>, double, double, Rng&);
template Body<2> part(const Body<2>&, const std::vector<bool>&);
template Body<3> part(const Body<3>&, const std::vector<bool>&);
template Body<2> thinned(const Body<2>&, double, Rng&);
template Body<3> thinned(const Body<3>&, double, Rng&);
template Body<2> any_small(Rng&);
template Body<3> any_small(Rng&);
template std::vector<Point<2>> duals(const Body<2>&);
template std::vector<Point<3>> duals(const Body<3>&);
template Sweep<2> short_path(const Body<2>&, Rng&);
template Sweep<3> short_path(const Body<3>&, Rng&);
template Sweep<2> scattered(const Body<2>&, Rng&);
template Sweep<3> scattered(const Body<3>&, Rng&);
template Sweep<2> any_sweep(const Body<2>&, Rng&);
template Sweep<3> any_sweep(const Body<3>&, Rng&);
template Sweep<2> there_and_back(const Sweep<2>&);
template Sweep<3> there_and_back(const Sweep<3>&);

}  // namespace cleave::cutting::bodies
