#include "cleave/topology/check.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "dimensions.hpp"
#include "facet_matching.hpp"
#include "orientation.hpp"
#include "plain_mates.hpp"
#include "soundness.hpp"
#include "star_levels.hpp"
#include "star_pass.hpp"

namespace cleave::topology {
namespace {

/// Mates that induce the same orientation on their facet, in orientable pieces, and a loop for each
/// of the others. Where all mates are opposite, that is all there is to see.
template <int D>
void find_orientation_faults(const CellView<D>& soup, const std::vector<HalfFacetId>& mates,
                             std::vector<Violation>& found) {
  const auto sign = [&](HalfFacetId h) {
    return soup.signs.empty() ? 1 : soup.signs[cell_of<D>(h).value];
  };
  std::vector<OrientationConflict> conflicts;
  for (Index h = 0; h < mates.size(); ++h) {
    const HalfFacetId mate = mates[h];
    if (mate.value == detail::kNone || mate.value < h) continue;
    const bool as_written = detail::opposite_as_written<D>(soup.cells, HalfFacetId{h}, mate);
    if (as_written != (sign(HalfFacetId{h}) == sign(mate)))
      conflicts.push_back({HalfFacetId{h}, mate});
  }
  if (conflicts.empty()) return;
  const detail::Orientation orientation = detail::orientation<D>(soup.cells, mates);
  for (const OrientationConflict& conflict : conflicts)
    if (orientation.orientable[orientation.piece_of_cell[cell_of<D>(conflict.one).value]])
      found.push_back(conflict);
  found.insert(found.end(), orientation.loops.begin(), orientation.loops.end());
}

/// Vertices whose stars fall into several parts, and what is wrong with the others.
template <int D>
void find_star_faults(std::span<const Cell<D>> cells, const std::vector<HalfFacetId>& mates,
                      const detail::Stars& stars, Level level, std::vector<Violation>& found) {
  std::vector<VertexId> irregular;
  const auto end = stars.surplus.end();
  for (auto first = stars.surplus.begin(), last = first; first != end; first = last) {
    const VertexId vertex = first->vertex;
    last = std::find_if(first, end,
                        [&](const detail::VertexPart& part) { return part.vertex != vertex; });
    found.push_back(NotCutRegular{vertex, cell_of<D>(stars.a_corner[vertex.value]),
                                  cell_of<D>(first->least),
                                  static_cast<std::size_t>(last - first) + 1});
    irregular.push_back(vertex);
  }
  detail::find_faults_beyond_stars<D>(cells, mates, stars.a_corner, std::move(irregular), level,
                                      found);
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

void find_orphans(const detail::Stars& stars, std::vector<Violation>& found) {
  for (Index v = 0; v < stars.a_corner.size(); ++v)
    if (stars.a_corner[v].value == detail::kNone) found.push_back(OrphanVertex{VertexId{v}});
}

/// The mates, if they have a meaning and `level` asks for them: cells are sound, none is there
/// twice and no facet is in three cells. All that is wrong with cells, facets and orientations.
template <int D>
std::optional<std::vector<HalfFacetId>> find_mates(const CellView<D>& soup, Level level,
                                                   std::vector<Violation>& found) {
  if (level >= Level::pseudo_manifold) {
    detail::Crew alone;
    const auto reversed = [&](CellId c) { return !soup.signs.empty() && soup.signs[c.value] < 0; };
    auto mates = detail::plain_mates<D>(soup.cells, soup.vertex_count, reversed, alone);
    if (mates) return mates;  // nothing is wrong
  }
  found = detail::unsound_cells(soup);
  if (!found.empty() || level < Level::pseudo_manifold) return std::nullopt;
  detail::FacetMatching matching = detail::match_facets<D>(soup.cells, soup.vertex_count);
  for (const auto& [first, second] : matching.duplicates)
    found.push_back(DuplicateCell{first, second});
  for (const auto& crowd : matching.crowded) found.push_back(FacetInThreeCells{crowd});
  if (!found.empty()) return std::nullopt;
  find_orientation_faults(soup, matching.mates, found);
  return std::move(matching.mates);
}

}  // namespace

template <int D>
std::vector<Violation> check(const CellView<D>& soup, Level level) {
  require_ids_suffice(D, soup.cells.size(), soup.vertex_count);
  detail::require_signs(soup);
  std::vector<Violation> found;
  const std::optional<std::vector<HalfFacetId>> mates = find_mates(soup, level, found);
  if (mates && level >= Level::cut_regular) {
    const detail::Stars stars = detail::star_pass<D>(soup.cells, *mates, soup.vertex_count);
    find_star_faults<D>(soup.cells, *mates, stars, level, found);
    find_orphans(stars, found);
  } else {
    find_orphans(soup, found);
  }
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
  detail::Crew alone;
  const auto as_written = [](CellId) { return false; };
  if (detail::plain_mates<D>(soup.cells, soup.vertex_count, as_written, alone))
    return std::vector<std::int8_t>(soup.cells.size(), 1);  // they are coherent
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
