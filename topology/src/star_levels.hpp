#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "cleave/topology/violation.hpp"
#include "corner_set.hpp"
#include "doubtful_links.hpp"
#include "flood.hpp"

namespace cleave::topology::detail {

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

/// Those of `vertices` of a 3-complex, other than those in `known_bad` (both ascending), whose link
/// is neither a sphere (Euler characteristic 2, closed) nor a disk (1, one rim). Requires that
/// their stars are one part each.
inline void find_bad_links(std::span<const Cell<3>> cells, const std::vector<HalfFacetId>& mates,
                           const std::vector<CornerId>& a_corner,
                           const std::vector<VertexId>& vertices,
                           const std::vector<VertexId>& known_bad, std::vector<Violation>& found) {
  std::vector<CornerId> star;
  CornerSet seen;
  for (const VertexId vertex : vertices) {
    if (std::binary_search(known_bad.begin(), known_bad.end(), vertex)) continue;
    seen.clear();
    star.clear();
    flood<3>(cells, mates, a_corner[vertex.value], vertex, star,
             [&](CornerId corner) { return seen.insert(corner); });
    const LinkCount link = count_link(cells, mates, star, vertex);
    const bool sphere = link.euler_characteristic == 2 && link.boundary_components == 0;
    const bool disk = link.euler_characteristic == 1 && link.boundary_components == 1;
    if (!sphere && !disk)
      found.push_back(BadVertexLink{vertex, link.euler_characteristic, link.boundary_components});
  }
}

/// What `level` asks for beyond cut-regular: no pinched simplex from edge_regular on, and links
/// that are spheres or balls for a manifold. Adds what is wrong to `found`. In dimension 1 and 2 a
/// vertex that is cut-regular has such a link always; in dimension 4 that is not decided.
/// `a_corner` and `irregular` as star_pass found them.
template <int D>
void find_faults_beyond_stars(std::span<const Cell<D>> cells, const std::vector<HalfFacetId>& mates,
                              const std::vector<CornerId>& a_corner,
                              std::vector<VertexId> irregular, Level level,
                              std::vector<Violation>& found) {
  if (level < Level::edge_regular) return;
  if constexpr (D == 3) {
    const std::vector<VertexId> doubtful = doubtful_links(cells, mates, a_corner, irregular);
    if (doubtful.empty()) return;
    std::vector<bool> asked(a_corner.size(), false);
    for (const VertexId v : doubtful) asked[v.value] = true;
    // Both ends of a pinched edge are in doubt.
    const std::vector<VertexId> pinched = find_pinched_simplices<D>(
        cells, mates, a_corner.size(), [&](VertexId v) { return asked[v.value]; }, found);
    if (level < Level::manifold) return;
    irregular.insert(irregular.end(), pinched.begin(), pinched.end());
    std::sort(irregular.begin(), irregular.end());
    find_bad_links(cells, mates, a_corner, doubtful, irregular, found);
  } else if constexpr (D > 3) {
    find_pinched_simplices<D>(
        cells, mates, a_corner.size(), [](VertexId) { return true; }, found);
  }
}

}  // namespace cleave::topology::detail
