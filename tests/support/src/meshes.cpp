#include "cleave/support/meshes.hpp"

#include <algorithm>
#include <numeric>

#include "cleave/support/dimensions.hpp"

namespace cleave::support {
namespace {

VertexId vertex_id(std::size_t v) { return {static_cast<topology::Index>(v)}; }

template <std::size_t N>
std::size_t product(const std::array<int, N>& factors) {
  return std::accumulate(factors.begin(), factors.end(), std::size_t{1},
                         [](std::size_t p, int f) { return p * static_cast<std::size_t>(f); });
}

template <std::size_t N>
std::array<int, N> digits(std::size_t number, const std::array<int, N>& bases) {
  std::array<int, N> result{};
  for (std::size_t axis = N; axis-- > 0;) {
    result[axis] = static_cast<int>(number % static_cast<std::size_t>(bases[axis]));
    number /= static_cast<std::size_t>(bases[axis]);
  }
  return result;
}

template <std::size_t N>
std::size_t number_of(const std::array<int, N>& digit, const std::array<int, N>& bases) {
  std::size_t result = 0;
  for (std::size_t axis = 0; axis < N; ++axis)
    result = result * static_cast<std::size_t>(bases[axis]) + static_cast<std::size_t>(digit[axis]);
  return result;
}

/// The D! monotone walks through the cube at `least`; `name` numbers the points.
template <int D, class Name>
void add_cube(std::vector<Cell<D>>& cells, const std::array<int, D>& least, const Name& name) {
  std::array<std::size_t, D> axes{};
  std::iota(axes.begin(), axes.end(), std::size_t{0});
  do {
    auto at = least;
    Cell<D> cell{};
    cell[0] = name(at);
    for (std::size_t step = 0; step < axes.size(); ++step) {
      ++at[axes[step]];
      cell[step + 1] = name(at);
    }
    cells.push_back(cell);
  } while (std::next_permutation(axes.begin(), axes.end()));
}

}  // namespace

template <int D>
KuhnGrid<D>::KuhnGrid(Point nodes_per_axis) : nodes(nodes_per_axis) {
  this->vertex_count = product(nodes);
  Point cubes = nodes;
  for (int& n : cubes) --n;
  for (std::size_t c = 0; c < product(cubes); ++c)
    add_cube<D>(this->cells, digits(c, cubes), [&](const Point& p) { return vertex(p); });
}

template <int D>
typename KuhnGrid<D>::Point KuhnGrid<D>::point(VertexId v) const {
  return digits(v.value, nodes);
}

template <int D>
VertexId KuhnGrid<D>::vertex(Point p) const {
  return vertex_id(number_of(p, nodes));
}

template <int D>
typename KuhnGrid<D>::Point KuhnGrid<D>::cube(std::size_t cell) const {
  return point(this->cells[cell].front());
}

template <int D>
Mesh<D> simplex() {
  Cell<D> cell{};
  for (std::size_t i = 0; i < cell.size(); ++i) cell[i] = vertex_id(i);
  return {{cell}, cell.size()};
}

template <int D>
Mesh<D> simplex_boundary() {
  Mesh<D> mesh;
  mesh.vertex_count = static_cast<std::size_t>(D) + 2;
  for (std::size_t without = 0; without < mesh.vertex_count; ++without) {
    Cell<D> cell{};
    for (std::size_t v = 0, to = 0; v < mesh.vertex_count; ++v)
      if (v != without) cell[to++] = vertex_id(v);
    mesh.cells.push_back(cell);
  }
  return mesh;
}

template <int D>
Mesh<D> torus(int n) {
  std::array<int, D> nodes{};
  nodes.fill(n);
  Mesh<D> mesh;
  mesh.vertex_count = product(nodes);
  for (std::size_t c = 0; c < mesh.vertex_count; ++c)
    add_cube<D>(mesh.cells, digits(c, nodes), [&](std::array<int, D> p) {
      for (int& x : p) x %= n;
      return vertex_id(number_of(p, nodes));
    });
  return mesh;
}

template <int D>
Mesh<D> cone(const Mesh<D - 1>& base) {
  Mesh<D> mesh;
  mesh.vertex_count = base.vertex_count + 1;
  for (const auto& facet : base.cells) {
    Cell<D> cell{};
    std::copy(facet.begin(), facet.end(), cell.begin());
    cell.back() = vertex_id(base.vertex_count);
    mesh.cells.push_back(cell);
  }
  return mesh;
}

template <int D>
Mesh<D> suspension(const Mesh<D - 1>& base) {
  Mesh<D> mesh = cone<D>(base);
  const VertexId other = vertex_id(mesh.vertex_count++);
  const std::size_t half = mesh.cells.size();
  for (std::size_t c = 0; c < half; ++c) {
    Cell<D> cell = mesh.cells[c];
    cell.back() = other;
    mesh.cells.push_back(cell);
  }
  return mesh;
}

Mesh<2> band(int n) {
  Mesh<2> mesh;
  mesh.vertex_count = static_cast<std::size_t>(n);
  for (std::size_t i = 0; i < mesh.vertex_count; ++i)
    mesh.cells.push_back({vertex_id(i), vertex_id((i + 1) % mesh.vertex_count),
                          vertex_id((i + 2) % mesh.vertex_count)});
  return mesh;
}

Mesh<2> projective_plane() {
  constexpr std::array<std::array<std::size_t, 3>, 10> kTriangles{{{0, 1, 2},
                                                                   {0, 2, 3},
                                                                   {0, 3, 4},
                                                                   {0, 4, 5},
                                                                   {0, 5, 1},
                                                                   {1, 2, 4},
                                                                   {2, 3, 5},
                                                                   {3, 4, 1},
                                                                   {4, 5, 2},
                                                                   {5, 1, 3}}};
  Mesh<2> mesh;
  mesh.vertex_count = 6;
  for (const auto& t : kTriangles)
    mesh.cells.push_back({vertex_id(t[0]), vertex_id(t[1]), vertex_id(t[2])});
  return mesh;
}

template <int D>
Mesh<D> disjoint_union(Mesh<D> a, const Mesh<D>& b) {
  for (Cell<D> cell : b.cells) {
    for (VertexId& v : cell) v = vertex_id(v.value + a.vertex_count);
    a.cells.push_back(cell);
  }
  a.vertex_count += b.vertex_count;
  return a;
}

template <int D>
Mesh<D> sub_mesh(const Mesh<D>& mesh, const std::vector<bool>& keep) {
  Mesh<D> result;
  result.vertex_count = mesh.vertex_count;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    if (keep[c]) result.cells.push_back(mesh.cells[c]);
  return result;
}

#define CLEAVE_INSTANTIATE(D)                                  \
  template struct KuhnGrid<D>;                                 \
  template Mesh<D> simplex<D>();                               \
  template Mesh<D> simplex_boundary<D>();                      \
  template Mesh<D> torus<D>(int);                              \
  template Mesh<D> disjoint_union<D>(Mesh<D>, const Mesh<D>&); \
  template Mesh<D> sub_mesh<D>(const Mesh<D>&, const std::vector<bool>&);
CLEAVE_FOR_EACH_DIMENSION(CLEAVE_INSTANTIATE)
#undef CLEAVE_INSTANTIATE
template Mesh<2> cone<2>(const Mesh<1>&);
template Mesh<3> cone<3>(const Mesh<2>&);
template Mesh<4> cone<4>(const Mesh<3>&);
template Mesh<2> suspension<2>(const Mesh<1>&);
template Mesh<3> suspension<3>(const Mesh<2>&);
template Mesh<4> suspension<4>(const Mesh<3>&);

}  // namespace cleave::support
