#pragma once
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "cleave/support/meshes.hpp"
#include "cleave/support/rng.hpp"

namespace cleave::support {

/// What can be wrong with a list of cells.
enum class Defect {
  none,
  degenerate_cell,
  vertex_out_of_range,
  duplicate_cell,
  facet_in_three_cells,
  orientation_conflict,
  non_orientable,
  not_cut_regular,
  pinched_simplex,
  bad_vertex_link,
  orphan_vertex
};

inline constexpr std::array<Defect, 11> kDefects{Defect::none,
                                                 Defect::degenerate_cell,
                                                 Defect::vertex_out_of_range,
                                                 Defect::duplicate_cell,
                                                 Defect::facet_in_three_cells,
                                                 Defect::orientation_conflict,
                                                 Defect::non_orientable,
                                                 Defect::not_cut_regular,
                                                 Defect::pinched_simplex,
                                                 Defect::bad_vertex_link,
                                                 Defect::orphan_vertex};

std::string_view name(Defect defect);

/// Whether the defect exists in this dimension without another one that implies it.
bool can_occur(Defect defect, int dimension);

/// Cells with one defect, and where it is.
template <int D>
struct Planted {
  Mesh<D> mesh;
  std::vector<std::int8_t> signs;  // coherent, but for an orientation conflict
  std::vector<CellId> cells;       // the cells that are to blame, if it is cells
  std::vector<VertexId> vertices;  // the vertices that are to blame, ascending, if it is vertices
};

/// A stellar ball with this defect planted in it, or beside it; without it, the ball has none.
template <int D>
Planted<D> plant(Defect defect, Rng& rng);

/// Random tuples over few vertices: every defect of cells at once, most of the time.
template <int D>
Mesh<D> random_soup(Rng& rng);

/// A solid whose only defect is one simplex of dimension 1 with a star in two parts: two cubes of a
/// middle layer touch along it, and the layers above and below join them. D = 3 or 4.
template <int D>
KuhnGrid<D> pinched_edge_grid(std::vector<bool>& keep);

}  // namespace cleave::support
