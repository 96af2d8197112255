#include "cleave/topology/check.hpp"

#include <algorithm>
#include <utility>

#include "dimensions.hpp"
#include "facet_matching.hpp"
#include "orientation.hpp"
#include "soundness.hpp"
#include "star_levels.hpp"
#include "star_pass.hpp"

namespace cleave::topology {
namespace {

template <int D>
void find_orientation_faults(const CellView<D>& soup, const std::vector<HalfFacetId>& mates,
                             std::vector<Violation>& found) {
  const detail::Orientation orientation = detail::orientation<D>(soup.cells, mates);
  const auto sign = [&](CellId c) { return soup.signs.empty() ? 1 : soup.signs[c.value]; };
  for (Index h = 0; h < mates.size(); ++h) {
    const HalfFacetId mate = mates[h];
    if (mate.value == detail::kNone || mate.value < h) continue;
    const CellId cell = cell_of<D>(HalfFacetId{h});
    if (!orientation.orientable[orientation.piece_of_cell[cell.value]]) continue;
    const bool as_written = detail::opposite_as_written<D>(soup.cells, HalfFacetId{h}, mate);
    if (as_written != (sign(cell) == sign(cell_of<D>(mate))))
      found.push_back(OrientationConflict{HalfFacetId{h}, mate});
  }
  found.insert(found.end(), orientation.loops.begin(), orientation.loops.end());
}

/// Vertices whose star falls into several parts, ascending; and them as violations.
template <int D>
std::vector<VertexId> find_irregular_vertices(std::span<const Cell<D>> cells,
                                              const std::vector<HalfFacetId>& mates,
                                              std::size_t vertex_count,
                                              std::vector<Violation>& found) {
  const detail::Stars stars = detail::star_pass<D>(cells, mates, vertex_count);
  std::vector<VertexId> vertices;
  for (auto first = stars.surplus.begin(); first != stars.surplus.end();) {
    const auto last = std::find_if(first, stars.surplus.end(), [&](const detail::VertexPart& part) {
      return part.vertex != first->vertex;
    });
    found.push_back(NotCutRegular{first->vertex, cell_of<D>(stars.a_corner[first->vertex.value]),
                                  cell_of<D>(first->least),
                                  static_cast<std::size_t>(last - first) + 1});
    vertices.push_back(first->vertex);
    first = last;
  }
  return vertices;
}

template <int D>
void find_orphans(const CellView<D>& soup, std::vector<Violation>& found) {
  std::vector<bool> used(soup.vertex_count, false);
  for (const Cell<D>& cell : soup.cells)
    for (const VertexId v : cell)
      if (v.value < soup.vertex_count) used[v.value] = true;
  for (Index v = 0; v < soup.vertex_count; ++v)
    if (!used[v]) found.push_back(OrphanVertex{VertexId{v}});
}

}  // namespace

template <int D>
std::vector<Violation> check(const CellView<D>& soup, Level level) {
  require_ids_suffice(D, soup.cells.size(), soup.vertex_count);
  detail::require_signs(soup);
  std::vector<Violation> found = detail::unsound_cells(soup);
  if (found.empty() && level >= Level::pseudo_manifold) {
    const detail::FacetMatching matching = detail::match_facets<D>(soup.cells, soup.vertex_count);
    for (const auto& [first, second] : matching.duplicates)
      found.push_back(DuplicateCell{first, second});
    for (const auto& crowd : matching.crowded) found.push_back(FacetInThreeCells{crowd});
    if (found.empty()) {
      find_orientation_faults(soup, matching.mates, found);
      std::vector<VertexId> irregular;
      if (level >= Level::cut_regular)
        irregular =
            find_irregular_vertices<D>(soup.cells, matching.mates, soup.vertex_count, found);
      std::vector<VertexId> pinched;
      if (level >= Level::edge_regular)
        pinched = detail::find_pinched_simplices<D>(soup.cells, matching.mates, found);
      if (level >= Level::manifold) {
        irregular.insert(irregular.end(), pinched.begin(), pinched.end());
        std::sort(irregular.begin(), irregular.end());
        detail::find_bad_links<D>(soup.cells, matching.mates, soup.vertex_count, irregular, found);
      }
    }
  }
  find_orphans(soup, found);
  return found;
}

Level level_reached(int dimension, const std::vector<Violation>& violations) {
  Level reached = dimension <= 3 ? Level::manifold : Level::edge_regular;
  for (const Violation& violation : violations) {
    const Level broken = breaks(violation);
    if (broken != Level::none && broken <= reached)
      reached = static_cast<Level>(static_cast<int>(broken) - 1);
  }
  return reached;
}

template <int D>
std::variant<std::vector<std::int8_t>, NonOrientable> orient(const CellView<D>& soup) {
  require_ids_suffice(D, soup.cells.size(), soup.vertex_count);
  std::vector<Violation> unsound = detail::unsound_cells(soup);
  if (!unsound.empty()) throw InvalidComplex(std::move(unsound));
  const detail::FacetMatching matching = detail::match_facets<D>(soup.cells, soup.vertex_count);
  if (!matching.crowded.empty()) {
    std::vector<Violation> crowded;
    for (const auto& crowd : matching.crowded) crowded.push_back(FacetInThreeCells{crowd});
    throw InvalidComplex(std::move(crowded));
  }
  detail::Orientation orientation = detail::orientation<D>(soup.cells, matching.mates);
  if (!orientation.loops.empty()) return std::move(orientation.loops.front());
  return std::move(orientation.signs);
}

#define CLEAVE_INSTANTIATE(D)                                          \
  template std::vector<Violation> check<D>(const CellView<D>&, Level); \
  template std::variant<std::vector<std::int8_t>, NonOrientable> orient<D>(const CellView<D>&);
CLEAVE_FOR_EACH_DIMENSION(CLEAVE_INSTANTIATE)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::topology
