#pragma once
#include <algorithm>
#include <array>
#include <bitset>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "cleave/topology/violation.hpp"
#include "corner_set.hpp"
#include "flood.hpp"

namespace cleave::topology::detail {

/// A face of a cell: the cell and which of its local vertices belong to the face.
struct CellFace {
  CellId cell;
  std::uint32_t mask;
};

/// The local vertices of `other` that the face has; its cells share a facet that contains it.
template <int D>
std::uint32_t mask_in(std::span<const Cell<D>> cells, CellFace face, CellId other) {
  std::uint32_t mask = 0;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(D); ++i) {
    if ((face.mask >> i & 1u) == 0) continue;
    const VertexId v = cells[face.cell.value][i];
    for (std::size_t j = 0; j <= static_cast<std::size_t>(D); ++j)
      if (cells[other.value][j] == v) mask |= 1u << j;
  }
  return mask;
}

/// Simplices of dimension 1 .. D-2 whose cells fall into several facet-connected parts, by
/// dimension, then lexicographically. Returns the vertices of such simplices, with repetitions.
/// Time: linear, and sorting one entry per part; memory: 2^(D+1) bits per cell.
template <int D>
std::vector<VertexId> find_pinched_simplices(std::span<const Cell<D>> cells,
                                             const std::vector<HalfFacetId>& mates,
                                             std::vector<Violation>& found) {
  std::vector<VertexId> vertices;
  for (std::size_t size = 2; size + 1 <= static_cast<std::size_t>(D); ++size) {
    struct Part {
      std::array<VertexId, static_cast<std::size_t>(D)> simplex;
      CellId least;
    };
    std::vector<Part> parts;
    std::vector<std::bitset<(std::size_t{1} << (D + 1))>> seen(cells.size());
    std::vector<CellFace> queue;
    for (Index c = 0; c < cells.size(); ++c) {
      for (std::uint32_t mask = 0; mask < 1u << (D + 1); ++mask) {
        if (std::bitset<D + 1>(mask).count() != size || seen[c][mask]) continue;
        Part part{{}, CellId{c}};
        for (std::size_t i = 0, to = 0; i <= static_cast<std::size_t>(D); ++i)
          if (mask >> i & 1u) part.simplex[to++] = cells[c][i];
        std::sort(part.simplex.begin(), part.simplex.begin() + static_cast<std::ptrdiff_t>(size));
        parts.push_back(part);
        seen[c].set(mask);
        queue.assign(1, CellFace{CellId{c}, mask});
        for (std::size_t next = 0; next < queue.size(); ++next) {
          const CellFace face = queue[next];
          for (int i = 0; i <= D; ++i) {
            if (face.mask >> i & 1u) continue;  // this facet does not contain the face
            const HalfFacetId mate = mates[half_facet<D>(face.cell, i).value];
            if (!is_mate(mate)) continue;
            const CellId across = cell_of<D>(mate);
            const std::uint32_t there = mask_in<D>(cells, face, across);
            if (seen[across.value][there]) continue;
            seen[across.value].set(there);
            queue.push_back({across, there});
          }
        }
      }
    }
    std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
      return a.simplex != b.simplex ? a.simplex < b.simplex : a.least < b.least;
    });
    for (auto first = parts.begin(); first != parts.end();) {
      auto last = first + 1;
      while (last != parts.end() && last->simplex == first->simplex) ++last;
      if (last - first > 1) {
        const auto end = first->simplex.begin() + static_cast<std::ptrdiff_t>(size);
        found.push_back(PinchedSimplex{{first->simplex.begin(), end},
                                       first->least,
                                       (first + 1)->least,
                                       static_cast<std::size_t>(last - first)});
        vertices.insert(vertices.end(), first->simplex.begin(), end);
      }
      first = last;
    }
  }
  return vertices;
}

/// Counts the link of a vertex of a 3-complex, a surface: corners, then edges, then triangles of
/// the star seen from the vertex.
struct LinkCount {
  int euler_characteristic;
  int boundary_components;
};

inline LinkCount count_link(std::span<const Cell<3>> cells, const std::vector<HalfFacetId>& mates,
                            const std::vector<CornerId>& star, VertexId vertex) {
  using Edge = std::pair<VertexId, VertexId>;
  std::vector<VertexId> neighbours;
  std::vector<Edge> rim;  // link edges with one triangle
  std::size_t half_edges = 0;
  for (const CornerId corner : star) {
    const Cell<3>& cell = cells[cell_of<3>(corner).value];
    for (int i = 0; i <= 3; ++i) {
      if (i == local_index<3>(corner)) continue;
      neighbours.push_back(cell[static_cast<std::size_t>(i)]);
      ++half_edges;
      if (is_mate(mates[half_facet<3>(cell_of<3>(corner), i).value])) continue;
      std::vector<VertexId> ends;
      for (int j = 0; j <= 3; ++j)
        if (j != i && cell[static_cast<std::size_t>(j)] != vertex)
          ends.push_back(cell[static_cast<std::size_t>(j)]);
      rim.emplace_back(ends[0], ends[1]);
    }
  }
  std::sort(neighbours.begin(), neighbours.end());
  neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
  const std::size_t edges = (half_edges + rim.size()) / 2;

  // Components of the rim: each vertex of it points to the least it is known to be joined with.
  std::vector<std::size_t> joined(neighbours.size());
  for (std::size_t n = 0; n < joined.size(); ++n) joined[n] = n;
  const auto root = [&](VertexId v) {
    auto n = static_cast<std::size_t>(std::lower_bound(neighbours.begin(), neighbours.end(), v) -
                                      neighbours.begin());
    while (joined[n] != n) n = joined[n] = joined[joined[n]];
    return n;
  };
  std::vector<std::size_t> roots;
  for (const auto& [a, b] : rim) joined[root(a)] = root(b);
  for (const auto& edge : rim) roots.push_back(root(edge.first));
  std::sort(roots.begin(), roots.end());
  roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
  return {
      static_cast<int>(neighbours.size()) - static_cast<int>(edges) + static_cast<int>(star.size()),
      static_cast<int>(roots.size())};
}

/// Vertices of a 3-complex, other than those in `known_bad` (ascending), whose link is neither a
/// sphere (Euler characteristic 2, closed) nor a disk (1, one rim). In dimension 1 and 2 a vertex
/// that is cut-regular has such a link always; in dimension 4 this is not decided.
template <int D>
void find_bad_links(std::span<const Cell<D>> cells, const std::vector<HalfFacetId>& mates,
                    std::size_t vertex_count, const std::vector<VertexId>& known_bad,
                    std::vector<Violation>& found) {
  if constexpr (D == 3) {
    std::vector<CornerId> a_corner(vertex_count, CornerId{kNone});
    for (Index c = 0; c < mates.size(); ++c) a_corner[cells[c / 4][c % 4].value].value = c;
    std::vector<CornerId> star;
    CornerSet seen;
    for (Index v = 0; v < vertex_count; ++v) {
      const VertexId vertex{v};
      if (a_corner[v].value == kNone ||
          std::binary_search(known_bad.begin(), known_bad.end(), vertex))
        continue;
      seen.clear();
      star.clear();
      flood<3>(cells, mates, a_corner[v], vertex, star,
               [&](CornerId corner) { return seen.insert(corner); });
      const LinkCount link = count_link(cells, mates, star, vertex);
      const bool sphere = link.euler_characteristic == 2 && link.boundary_components == 0;
      const bool disk = link.euler_characteristic == 1 && link.boundary_components == 1;
      if (!sphere && !disk)
        found.push_back(BadVertexLink{vertex, link.euler_characteristic, link.boundary_components});
    }
  }
}

}  // namespace cleave::topology::detail
