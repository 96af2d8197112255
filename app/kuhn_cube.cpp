#include "kuhn_cube.hpp"

#include <fmt/format.h>

#include <utility>

#include "error.hpp"

namespace cleave::app {
namespace {

// The six orders in which a path along edges gets from one end of a box's diagonal to the other.
// Odd ones are walked with their last two vertices exchanged, which makes the cell positively
// oriented.
struct Path {
  std::array<std::size_t, 3> axes;
  bool odd;
};
constexpr std::array<Path, 6> kPaths{{{{0, 1, 2}, false},
                                      {{0, 2, 1}, true},
                                      {{1, 0, 2}, true},
                                      {{1, 2, 0}, false},
                                      {{2, 0, 1}, false},
                                      {{2, 1, 0}, true}}};

void require_ids_suffice(const CubeSpec& spec) {
  double corners = 24.0, vertices = 1.0;
  for (const std::uint64_t n : spec.nodes) {
    corners *= static_cast<double>(n - 1);
    vertices *= static_cast<double>(n);
  }
  constexpr auto kMost = static_cast<double>(topology::kNoIndex - 1);
  if (corners > kMost / 2 || vertices > kMost)
    throw InputError(
        fmt::format("the cube has too many cells for {}-bit corner numbers; give it fewer nodes",
                    topology::kIdBits));
}

}  // namespace

Mesh kuhn_cube(const CubeSpec& spec) {
  require_ids_suffice(spec);
  const auto [nx, ny, nz] = spec.nodes;
  Mesh mesh;
  mesh.source = "cube";
  mesh.dimension = 3;
  const auto place = [](std::uint64_t i, double length, std::uint64_t n) {
    return length * static_cast<double>(i) / static_cast<double>(n - 1);
  };
  for (std::uint64_t z = 0; z < nz; ++z)
    for (std::uint64_t y = 0; y < ny; ++y)
      for (std::uint64_t x = 0; x < nx; ++x) {
        mesh.vertex_numbers.push_back(mesh.points.size());
        mesh.points.push_back(
            {place(x, spec.size[0], nx), place(y, spec.size[1], ny), place(z, spec.size[2], nz)});
      }
  const std::array<std::uint64_t, 3> stride{1, nx, nx * ny};
  Elements& cells = mesh.elements[3];
  for (std::uint64_t z = 0; z + 1 < nz; ++z)
    for (std::uint64_t y = 0; y + 1 < ny; ++y)
      for (std::uint64_t x = 0; x + 1 < nx; ++x)
        for (const Path& path : kPaths) {
          std::array<std::uint64_t, 4> cell{x + nx * (y + ny * z)};
          for (std::size_t i = 0; i < 3; ++i) cell[i + 1] = cell[i] + stride[path.axes[i]];
          if (path.odd) std::swap(cell[2], cell[3]);
          for (const std::uint64_t v : cell) cells.vertices.push_back(static_cast<Index>(v));
          cells.numbers.push_back(cells.numbers.size());
        }
  return mesh;
}

}  // namespace cleave::app
