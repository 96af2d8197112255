#include "soups.hpp"

#include <algorithm>

#include "cleave/support/meshes.hpp"

namespace cleave::fuzz {
namespace {

using support::Mesh;
using topology::Cell;
using topology::CellSoup;
using topology::VertexId;

template <int D>
Mesh<D> arbitrary_tuples(Choices& choices) {
  Mesh<D> mesh;
  mesh.vertex_count = 1 + choices.below(16);
  const std::size_t cells = choices.below(25);
  for (std::size_t c = 0; c < cells; ++c) {
    Cell<D> cell{};
    for (VertexId& v : cell)  // one number too many: out of range
      v.value = static_cast<std::uint32_t>(choices.below(mesh.vertex_count + 1));
    mesh.cells.push_back(cell);
  }
  return mesh;
}

template <int D>
Mesh<D> grid(Choices& choices) {
  typename support::KuhnGrid<D>::Point nodes{};
  nodes.fill(2);
  std::size_t cells = 1;
  for (std::size_t axis = 0; axis < nodes.size(); ++axis) cells *= axis + 1;
  for (std::size_t step = choices.below(8); step > 0; --step) {
    int& along = nodes[choices.below(nodes.size())];
    const std::size_t longer =
        cells / static_cast<std::size_t>(along - 1) * static_cast<std::size_t>(along);
    if (longer > 48) break;
    ++along;
    cells = longer;
  }
  return support::KuhnGrid<D>(nodes);
}

template <int D>
Mesh<D> solid(Choices& choices) {
  switch (choices.below(6)) {
    case 0:
      return support::simplex_boundary<D>();
    case 1:
      if constexpr (D <= 2) return support::torus<D>(3 + static_cast<int>(choices.below(2)));
      break;
    case 2:
      if constexpr (D == 2) return support::band(5 + static_cast<int>(choices.below(4)));
      break;
    case 3:
      if constexpr (D >= 2) return support::cone<D>(solid<D - 1>(choices));
      break;
    case 4:
      if constexpr (D >= 2) return support::suspension<D>(grid<D - 1>(choices));
      break;
    default:
      break;
  }
  return grid<D>(choices);
}

/// Leaves cells out, exchanges entries of tuples, makes vertices one.
template <int D>
void disturb(Mesh<D>& mesh, Choices& choices) {
  if (choices.bit()) {
    std::vector<bool> keep;
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) keep.push_back(!choices.bit());
    mesh = support::sub_mesh<D>(mesh, keep);
  }
  if (choices.bit())
    for (Cell<D>& cell : mesh.cells)
      if (choices.bit()) std::swap(cell[choices.below(cell.size())], cell[0]);
  for (std::size_t times = choices.below(4); times > 0 && mesh.vertex_count > 0; --times) {
    const auto from = static_cast<std::uint32_t>(choices.below(mesh.vertex_count));
    const auto to = static_cast<std::uint32_t>(choices.below(mesh.vertex_count));
    for (Cell<D>& cell : mesh.cells)
      std::replace(cell.begin(), cell.end(), VertexId{from}, VertexId{to});
  }
}

}  // namespace

template <int D>
CellSoup<D> soup_of(Choices& choices) {
  const bool arbitrary = choices.below(4) == 0;
  Mesh<D> mesh = arbitrary ? arbitrary_tuples<D>(choices) : solid<D>(choices);
  if (!arbitrary) disturb<D>(mesh, choices);
  CellSoup<D> soup{mesh.cells, mesh.vertex_count, {}};
  if (choices.below(4) == 0)
    for (std::size_t c = 0; c < mesh.cells.size(); ++c)
      soup.signs.push_back(static_cast<std::int8_t>(choices.bit() ? -1 : 1));
  return soup;
}

template CellSoup<1> soup_of<1>(Choices&);
template CellSoup<2> soup_of<2>(Choices&);
template CellSoup<3> soup_of<3>(Choices&);
template CellSoup<4> soup_of<4>(Choices&);

}  // namespace cleave::fuzz
