#include "cleave/support/defects.hpp"

#include <algorithm>
#include <utility>

#include "cleave/support/dimensions.hpp"
#include "cleave/support/random_meshes.hpp"
#include "cleave/support/reference.hpp"

namespace cleave::support {
namespace {

template <int D>
CellId last_cell(const Mesh<D>& mesh) {
  return {static_cast<topology::Index>(mesh.cells.size() - 1)};
}

template <int D>
VertexId new_vertex(Mesh<D>& mesh) {
  return {static_cast<topology::Index>(mesh.vertex_count++)};
}

/// A complex of dimension D whose cells have no coherent signs.
template <int D>
Mesh<D> one_sided(Rng& rng) {
  if constexpr (D == 2) {
    return rng.chance(0.5) ? band(5 + 2 * static_cast<int>(rng.below(3))) : projective_plane();
  } else {
    const Mesh<D - 1> base = one_sided<D - 1>(rng);
    return rng.chance(0.5) ? cone<D>(base) : suspension<D>(base);
  }
}

template <int D>
void append(Planted<D>& planted, const Cell<D>& cell, std::int8_t sign) {
  planted.mesh.cells.push_back(cell);
  planted.signs.push_back(sign);
}

template <int D>
void put_beside(Planted<D>& planted, const Mesh<D>& other) {
  planted.mesh = disjoint_union<D>(std::move(planted.mesh), other);
  const auto signs = coherent_signs<D>(other.cells);
  for (std::size_t c = 0; c < other.cells.size(); ++c)
    planted.signs.push_back(signs ? (*signs)[c] : std::int8_t{1});
}

template <int D>
void plant_in_a_cell(Planted<D>& planted, Defect defect, Rng& rng) {
  auto& cells = planted.mesh.cells;
  const CellId at{static_cast<topology::Index>(rng.below(cells.size()))};
  const auto i = rng.below(static_cast<std::size_t>(D) + 1);
  Cell<D>& cell = cells[at.value];
  planted.cells = {at};
  if (defect == Defect::degenerate_cell) {
    cell[i] = cell[(i + 1 + rng.below(D)) % cell.size()];
    planted.vertices = {cell[i]};
  } else if (defect == Defect::vertex_out_of_range) {
    cell[i] = {static_cast<topology::Index>(planted.mesh.vertex_count + rng.below(5))};
    planted.vertices = {cell[i]};
  } else if (defect == Defect::duplicate_cell) {
    Cell<D> again = cell;
    rng.shuffle(again);
    append(planted, again, planted.signs[at.value]);
    planted.cells.push_back(last_cell(planted.mesh));
  }
}

template <int D>
void plant_third_cell(Planted<D>& planted, Rng& rng) {
  auto& mesh = planted.mesh;
  const HalfFacetId h = rng.pick(interior_facets<D>(mesh.cells));
  const HalfFacetId mate = *mates_of<D>(mesh.cells)[h.value];
  Cell<D> third = mesh.cells[topology::cell_of<D>(h).value];
  third[static_cast<std::size_t>(topology::local_index<D>(h))] = new_vertex(mesh);
  append(planted, third, std::int8_t{1});
  planted.cells = {topology::cell_of<D>(h), topology::cell_of<D>(mate), last_cell(mesh)};
}

/// Reverses some cells of the ball, but not all, so that two mates are alike.
template <int D>
void plant_conflict(Planted<D>& planted, Rng& rng) {
  const std::size_t count = 1 + rng.below(planted.signs.size() - 1);
  std::vector<std::size_t> order(planted.signs.size());
  for (std::size_t c = 0; c < order.size(); ++c) order[c] = c;
  rng.shuffle(order);
  for (std::size_t i = 0; i < count; ++i)
    planted.signs[order[i]] = static_cast<std::int8_t>(-planted.signs[order[i]]);
}

template <int D>
void plant_touching_cell(Planted<D>& planted, Rng& rng) {
  const VertexId shared = rng.pick(planted.mesh.cells)[0];
  Cell<D> cell{};
  cell[0] = shared;
  for (std::size_t i = 1; i < cell.size(); ++i) cell[i] = new_vertex(planted.mesh);
  append(planted, cell, std::int8_t{1});
  planted.cells = {last_cell(planted.mesh)};
  planted.vertices = {shared};
}

template <int D>
void plant_pinched_edge(Planted<D>& planted) {
  const auto shift = static_cast<topology::Index>(planted.mesh.vertex_count);
  std::vector<bool> keep;
  const KuhnGrid<D> grid = pinched_edge_grid<D>(keep);
  put_beside<D>(planted, sub_mesh<D>(grid, keep));
  typename KuhnGrid<D>::Point low{1, 1, 1};
  typename KuhnGrid<D>::Point high{1, 1, 2};
  planted.vertices = {{grid.vertex(low).value + shift}, {grid.vertex(high).value + shift}};
}

template <int D>
Planted<D> ball(Rng& rng) {
  Planted<D> planted;
  planted.mesh = random_mesh<D>(MeshClass::stellar, rng);
  planted.signs = coherent_signs<D>(planted.mesh.cells).value();
  return planted;
}

}  // namespace

std::string_view name(Defect defect) {
  constexpr std::array<std::string_view, kDefects.size()> kNames{"none",
                                                                 "degenerate cell",
                                                                 "vertex out of range",
                                                                 "duplicate cell",
                                                                 "facet in three cells",
                                                                 "orientation conflict",
                                                                 "non-orientable",
                                                                 "not cut-regular",
                                                                 "pinched simplex",
                                                                 "bad vertex link",
                                                                 "orphan vertex"};
  return kNames[static_cast<std::size_t>(defect)];
}

bool can_occur(Defect defect, int dimension) {
  switch (defect) {
    case Defect::non_orientable:
    case Defect::not_cut_regular:
      return dimension >= 2;
    case Defect::pinched_simplex:
      return dimension >= 3;
    case Defect::bad_vertex_link:
      return dimension == 3;  // D = 2: implies not cut-regular
    default:
      return true;
  }
}

template <int D>
KuhnGrid<D> pinched_edge_grid(std::vector<bool>& keep) {
  typename KuhnGrid<D>::Point nodes{3, 3, 4};
  if (D == 4) nodes.back() = 2;
  KuhnGrid<D> grid(nodes);
  keep.assign(grid.cells.size(), true);
  for (std::size_t c = 0; c < keep.size(); ++c) {
    const auto cube = grid.cube(c);
    keep[c] = cube[2] != 1 || cube[0] == cube[1];
  }
  return grid;
}

template <int D>
Planted<D> plant(Defect defect, Rng& rng) {
  Planted<D> planted = ball<D>(rng);
  switch (defect) {
    case Defect::none:
      break;
    case Defect::degenerate_cell:
    case Defect::vertex_out_of_range:
    case Defect::duplicate_cell:
      plant_in_a_cell<D>(planted, defect, rng);
      break;
    case Defect::facet_in_three_cells:
      plant_third_cell<D>(planted, rng);
      break;
    case Defect::orientation_conflict:
      plant_conflict<D>(planted, rng);
      break;
    case Defect::non_orientable:
      if constexpr (D >= 2) put_beside<D>(planted, one_sided<D>(rng));
      break;
    case Defect::not_cut_regular:
      plant_touching_cell<D>(planted, rng);
      break;
    case Defect::pinched_simplex:
      if constexpr (D >= 3) plant_pinched_edge<D>(planted);
      break;
    case Defect::bad_vertex_link:
      if constexpr (D == 3) {
        put_beside<D>(planted, cone<D>(torus<D - 1>(rng.between(3, 4))));
        planted.vertices = {{static_cast<topology::Index>(planted.mesh.vertex_count - 1)}};
      }
      break;
    case Defect::orphan_vertex:
      planted.vertices = {new_vertex(planted.mesh)};
      break;
  }
  return planted;
}

template <int D>
Mesh<D> random_soup(Rng& rng) {
  Mesh<D> mesh;
  mesh.vertex_count = static_cast<std::size_t>(rng.between(D + 1, D + 6));
  const std::size_t names = mesh.vertex_count + rng.below(2);
  for (int n = rng.between(1, 12); n > 0; --n) {
    Cell<D> cell{};
    const bool may_repeat = rng.chance(0.1);
    for (std::size_t i = 0; i < cell.size(); ++i) do
        cell[i] = {static_cast<topology::Index>(rng.below(names))};
      while (!may_repeat && std::find(cell.begin(), cell.begin() + static_cast<int>(i), cell[i]) !=
                                cell.begin() + static_cast<int>(i));
    mesh.cells.push_back(cell);
  }
  return mesh;
}

#define CLEAVE_INSTANTIATE(D)                 \
  template Planted<D> plant<D>(Defect, Rng&); \
  template Mesh<D> random_soup<D>(Rng&);
CLEAVE_FOR_EACH_DIMENSION(CLEAVE_INSTANTIATE)
#undef CLEAVE_INSTANTIATE
template KuhnGrid<3> pinched_edge_grid<3>(std::vector<bool>&);
template KuhnGrid<4> pinched_edge_grid<4>(std::vector<bool>&);

}  // namespace cleave::support
