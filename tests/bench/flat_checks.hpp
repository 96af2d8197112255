#pragma once
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "flat_yardstick.hpp"

/// What the yardstick does where the library looks at all stars: as plainly as it goes, and with no
/// word on what is found.
namespace cleave::bench {

/// Visits the cells around each vertex through the mates: visit(vertex, its corners), once for each
/// vertex that has any. A mark per cell says for which vertex it was seen last.
template <int D, class Visit>
void for_each_star(const FlatMesh<D>& mesh, Visit visit) {
  constexpr std::uint32_t kCorners = D + 1;
  std::vector<std::uint32_t> a_corner(mesh.vertices, mesh.kNone),
      mark(mesh.cells.size(), mesh.kNone);
  for (std::uint32_t c = 0, corner = 0; c < mesh.cells.size(); ++c)
    for (const std::uint32_t v : mesh.cells[c]) a_corner[v] = corner++;
  std::vector<std::uint32_t> star;
  for (std::uint32_t v = 0; v < mesh.vertices; ++v) {
    if (a_corner[v] == mesh.kNone) continue;
    star.assign(1, a_corner[v]);
    mark[a_corner[v] / kCorners] = v;
    for (std::size_t next = 0; next < star.size(); ++next) {
      const std::uint32_t begin = star[next] - star[next] % kCorners;
      for (std::uint32_t h = begin; h < begin + kCorners; ++h) {
        const std::uint32_t mate = mesh.mates[h];
        if (h == star[next] || mate == mesh.kNone) continue;
        const std::uint32_t across = mate / kCorners;
        if (mark[across] == v) continue;
        mark[across] = v;
        std::uint32_t i = 0;
        while (mesh.cells[across][i] != v) ++i;
        star.push_back(kCorners * across + i);
      }
    }
    visit(v, star);
  }
}

/// The corners of each vertex in one array: of vertex v from start[v] on.
struct FlatIndex {
  FlatIndex() = default;
  explicit FlatIndex(const FlatMesh<3>& mesh)
      : start(mesh.vertices + 2, 0), corners(4 * mesh.cells.size()) {
    for (const auto& cell : mesh.cells)
      for (const std::uint32_t v : cell) ++start[v + 2];
    for (std::uint32_t v = 0; v < mesh.vertices; ++v) start[v + 2] += start[v + 1];
    std::uint32_t corner = 0;
    for (const auto& cell : mesh.cells)
      for (const std::uint32_t v : cell) corners[start[v + 1]++] = corner++;
  }
  std::vector<std::uint32_t> start, corners;
};

/// Whether every star is one part.
template <int D>
bool is_cut_regular(const FlatMesh<D>& mesh) {
  std::size_t reached = 0;
  for_each_star(mesh, [&](std::uint32_t, const auto& star) { reached += star.size(); });
  return reached == (D + 1) * mesh.cells.size();
}

/// Whether every vertex link is a sphere or a disk, the stars being one part each: by Euler's
/// number, which is 2 or 1 for these and less for any other surface and where a link is pinched.
inline bool links_are_spheres_or_disks(const FlatMesh<3>& mesh) {
  std::vector<std::uint32_t> seen(mesh.vertices, mesh.kNone);
  bool all = true;
  std::size_t reached = 0;
  for_each_star(mesh, [&](std::uint32_t v, const auto& star) {
    reached += star.size();
    std::uint32_t corners = 0, rim = 0;
    for (const std::uint32_t corner : star)
      for (std::uint32_t h = corner & ~3U; h < (corner & ~3U) + 4; ++h) {
        if (h == corner) continue;
        rim += mesh.mates[h] == mesh.kNone ? 1 : 0;
        std::uint32_t& mark = seen[mesh.cells[h / 4][h % 4]];
        corners += mark != v ? 1 : 0;
        mark = v;
      }
    const auto triangles = static_cast<std::uint32_t>(star.size());
    const std::uint32_t edges = (3 * triangles + rim) / 2;
    all &= corners + triangles == edges + (rim == 0 ? 2 : 1);
  });
  return all && reached == 4 * mesh.cells.size();
}

/// Whether `after` is `before` with its stars divided into their parts once the cut is open:
/// before.mates are those of before the cut.
template <int D>
bool is_unglued(FlatMesh<D> before, const std::vector<std::uint32_t>& cut,
                const std::vector<typename FlatMesh<D>::Cell>& after) {
  for (const std::uint32_t h : cut) {
    const std::uint32_t mate = before.mates[h];
    before.mates[h] = before.mates[mate] = before.kNone;
  }
  // Each part is given a number; it must have one name after, and no other part that name.
  constexpr std::uint32_t kCorners = D + 1;
  std::vector<std::uint32_t> part;
  std::vector<bool> taken(kCorners * after.size(), false);
  const std::uint32_t first = before.vertices;
  std::uint32_t next = first;
  for (std::uint32_t corner = 0; corner < kCorners * after.size(); ++corner) {
    const std::uint32_t old = before.vertex(corner);
    if (old >= first) continue;
    const std::uint32_t name = after[corner / kCorners][corner % kCorners];
    if (taken[name]) return false;
    taken[name] = true;
    before.flood(corner, old, next++, part);
    for (const std::uint32_t c : part)
      if (after[c / kCorners][c % kCorners] != name) return false;
  }
  return true;
}

}  // namespace cleave::bench
