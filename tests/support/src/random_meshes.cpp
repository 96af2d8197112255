#include "cleave/support/random_meshes.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "cleave/support/dimensions.hpp"
#include "cleave/support/reference.hpp"

namespace cleave::support {
namespace {

template <int D>
using Point = typename KuhnGrid<D>::Point;

VertexId add_vertex(std::size_t& vertex_count) {
  return {static_cast<topology::Index>(vertex_count++)};
}

/// A grid of random proportions whose number of cells suits a test.
template <int D>
KuhnGrid<D> random_grid(Rng& rng, int fewest_nodes) {
  constexpr std::array<std::size_t, 5> kMostCells{0, 40, 110, 220, 250};
  for (;;) {
    Point<D> nodes{};
    std::size_t cells = 1;
    for (std::size_t axis = 0; axis < nodes.size(); ++axis) {
      nodes[axis] = rng.between(fewest_nodes, D == 1 ? 30 : 8);
      cells *= static_cast<std::size_t>(nodes[axis] - 1) * (axis + 1);
    }
    if (cells <= kMostCells[D] && cells >= 2) return KuhnGrid<D>(nodes);
  }
}

template <int D>
Mesh<D> scattered(Rng& rng) {
  const KuhnGrid<D> grid = random_grid<D>(rng, 2);
  const double density = 0.25 + 0.7 * rng.unit();
  std::vector<bool> keep(grid.cells.size());
  for (std::size_t c = 0; c < keep.size(); ++c) keep[c] = rng.chance(density);
  keep[rng.below(keep.size())] = true;
  return sub_mesh<D>(grid, keep);
}

template <int D>
Mesh<D> pinched(Rng& rng) {
  Point<D> nodes{};
  nodes.fill(2);
  nodes[0] = nodes[static_cast<std::size_t>(D == 1 ? 0 : 1)] = 3;
  if (D <= 3 && rng.chance(0.6)) nodes[rng.below(nodes.size())] += rng.between(1, D == 3 ? 1 : 3);
  const KuhnGrid<D> grid(nodes);
  const double more = rng.chance(0.5) ? 0.0 : 0.3 * rng.unit();
  std::map<Point<D>, bool> cube;
  std::vector<bool> keep(grid.cells.size());
  for (std::size_t c = 0; c < keep.size(); ++c) {
    const Point<D> at = grid.cube(c);
    const bool even = std::accumulate(at.begin(), at.end(), 0) % 2 == 0;
    const bool kept = cube.try_emplace(at, even || rng.chance(more)).first->second;
    keep[c] = kept || rng.chance(more / 4);
  }
  return sub_mesh<D>(grid, keep);
}

/// A grid without one of its inner cubes.
template <int D>
Mesh<D> without_a_cube(Rng& rng) {
  const KuhnGrid<D> grid = random_grid<D>(rng, 4);
  Point<D> hole{};
  for (std::size_t axis = 0; axis < hole.size(); ++axis)
    hole[axis] = rng.between(1, grid.nodes[axis] - 3);
  std::vector<bool> keep(grid.cells.size());
  for (std::size_t c = 0; c < keep.size(); ++c) keep[c] = grid.cube(c) != hole;
  return sub_mesh<D>(grid, keep);
}

/// A small grid without the star of an inner vertex.
template <int D>
Mesh<D> without_a_star(Rng& rng) {
  Point<D> nodes{};
  nodes.fill(3);
  if (D == 3) nodes[rng.below(nodes.size())] = 4;
  const KuhnGrid<D> grid(nodes);
  Point<D> middle{};
  middle.fill(1);
  const VertexId gone = grid.vertex(middle);
  std::vector<bool> keep(grid.cells.size());
  for (std::size_t c = 0; c < keep.size(); ++c)
    keep[c] = std::find(grid.cells[c].begin(), grid.cells[c].end(), gone) == grid.cells[c].end();
  return sub_mesh<D>(grid, keep);
}

template <int D>
Mesh<D> small_mesh(Rng& rng) {
  if (rng.chance(0.3)) return simplex<D>();
  Point<D> nodes{};
  for (int& n : nodes) n = rng.between(2, D <= 2 ? 4 : (D == 3 ? 3 : 2));
  return KuhnGrid<D>(nodes);
}

template <int D>
Mesh<D> sphere_or_torus(Rng& rng) {
  if constexpr (D == 1) {
    return torus<1>(rng.between(3, 20));
  } else {
    const std::size_t kind = rng.below(D == 4 ? 3 : 4);
    if (kind == 0) return simplex_boundary<D>();
    if (kind == 1) return suspension<D>(sphere_or_torus<D - 1>(rng));
    if (kind == 2) return disjoint_union<D>(simplex_boundary<D>(), simplex_boundary<D>());
    return torus<D>(D == 2 ? rng.between(3, 5) : 3);
  }
}

template <int D>
void refine(Mesh<D>& mesh, std::size_t most_cells, Rng& rng) {
  for (int step = rng.between(4, 14); step > 0 && mesh.cells.size() < most_cells; --step) {
    if (rng.chance(0.4))
      subdivide<D>(mesh, rng);
    else
      insert_vertex<D>(mesh, 6, rng);
  }
}

}  // namespace

std::string_view name(MeshClass mesh_class) {
  constexpr std::array<std::string_view, 6> kNames{"scattered", "pinched",   "hollow",
                                                   "stellar",   "irregular", "closed"};
  return kNames[static_cast<std::size_t>(mesh_class)];
}

template <int D>
void subdivide(Mesh<D>& mesh, Rng& rng) {
  Cell<D> cell = rng.pick(mesh.cells);
  rng.shuffle(cell);
  const std::set<VertexId> starred(cell.begin(), cell.begin() + rng.between(2, D + 1));
  const VertexId apex = add_vertex(mesh.vertex_count);
  std::vector<Cell<D>> result;
  for (const Cell<D>& old : mesh.cells) {
    const auto inside = [&](VertexId v) { return starred.count(v) != 0; };
    if (static_cast<std::size_t>(std::count_if(old.begin(), old.end(), inside)) != starred.size()) {
      result.push_back(old);
      continue;
    }
    for (const VertexId v : starred) {
      result.push_back(old);
      std::replace(result.back().begin(), result.back().end(), v, apex);
    }
  }
  mesh.cells = std::move(result);
}

template <int D>
void insert_vertex(Mesh<D>& mesh, std::size_t largest, Rng& rng) {
  const auto mates = mates_of<D>(mesh.cells);
  const auto side = [](std::size_t cell, int i) {
    return topology::half_facet<D>({static_cast<topology::Index>(cell)}, i);
  };
  std::vector<std::size_t> cavity{rng.below(mesh.cells.size())};
  std::vector<bool> in_cavity(mesh.cells.size());
  in_cavity[cavity.front()] = true;
  for (std::size_t tries = 0; tries < 2 * largest && cavity.size() < largest; ++tries) {
    const auto mate = mates[side(rng.pick(cavity), rng.between(0, D)).value];
    if (!mate || in_cavity[topology::cell_of<D>(*mate).value]) continue;
    cavity.push_back(topology::cell_of<D>(*mate).value);
    in_cavity[cavity.back()] = true;
  }
  std::vector<HalfFacetId> wall;
  for (const std::size_t cell : cavity)
    for (int i = 0; i <= D; ++i) {
      const auto mate = mates[side(cell, i).value];
      if (!mate || !in_cavity[topology::cell_of<D>(*mate).value]) wall.push_back(side(cell, i));
    }
  const auto degrees = ridge_degrees<D>(mesh.cells, wall);
  if (wall.empty() || (D == 1 && wall.size() != 2) ||
      std::any_of(degrees.begin(), degrees.end(), [](const auto& d) { return d.second != 2; }))
    return;
  Mesh<D> result;
  result.vertex_count = mesh.vertex_count;
  const VertexId apex = add_vertex(result.vertex_count);
  for (const HalfFacetId h : wall) {
    result.cells.push_back(mesh.cells[topology::cell_of<D>(h).value]);
    result.cells.back()[static_cast<std::size_t>(topology::local_index<D>(h))] = apex;
  }
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    if (!in_cavity[c]) result.cells.push_back(mesh.cells[c]);
  mesh = std::move(result);
}

template <int D>
void scramble(Mesh<D>& mesh, Rng& rng) {
  std::vector<VertexId> used;
  for (const auto& [vertex, star] : stars_of<D>(mesh.cells)) used.push_back(vertex);
  rng.shuffle(used);
  std::map<VertexId, VertexId> number;
  std::size_t count = 0;
  for (const VertexId v : used) number[v] = add_vertex(count);
  mesh.vertex_count = count;
  rng.shuffle(mesh.cells);
  for (Cell<D>& cell : mesh.cells) {
    for (VertexId& v : cell) v = number.at(v);
    rng.shuffle(cell);
  }
}

template <int D>
Mesh<D> random_mesh(MeshClass mesh_class, Rng& rng) {
  Mesh<D> mesh;
  switch (mesh_class) {
    case MeshClass::scattered:
      mesh = scattered<D>(rng);
      break;
    case MeshClass::pinched:
      mesh = pinched<D>(rng);
      break;
    case MeshClass::hollow:
      mesh = D <= 2 ? without_a_cube<D>(rng) : without_a_star<D>(rng);
      break;
    case MeshClass::stellar:
      mesh = small_mesh<D>(rng);
      for (int step = rng.between(3, D <= 2 ? 20 : 10); step > 0 && mesh.cells.size() < 150; --step)
        subdivide<D>(mesh, rng);
      break;
    case MeshClass::irregular:
      mesh = small_mesh<D>(rng);
      for (int step = rng.between(5, D <= 2 ? 30 : 15); step > 0 && mesh.cells.size() < 150; --step)
        insert_vertex<D>(mesh, 8, rng);
      break;
    case MeshClass::closed:
      mesh = sphere_or_torus<D>(rng);
      refine<D>(mesh, 160, rng);
      break;
  }
  scramble<D>(mesh, rng);
  return mesh;
}

#define CLEAVE_INSTANTIATE(D)                                  \
  template Mesh<D> random_mesh<D>(MeshClass, Rng&);            \
  template void subdivide<D>(Mesh<D>&, Rng&);                  \
  template void insert_vertex<D>(Mesh<D>&, std::size_t, Rng&); \
  template void scramble<D>(Mesh<D>&, Rng&);
CLEAVE_FOR_EACH_DIMENSION(CLEAVE_INSTANTIATE)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::support
