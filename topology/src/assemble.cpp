#include "cleave/topology/assemble.hpp"

#include <algorithm>
#include <utility>

#include "cleave/topology/check.hpp"
#include "dimensions.hpp"
#include "facet_matching.hpp"
#include "soundness.hpp"
#include "star_pass.hpp"

namespace cleave::topology {
namespace {

/// The violations that keep `soup` from being a complex once its stars are regular.
template <int D>
std::vector<Violation> hindrances(const CellSoup<D>& soup) {
  std::vector<Violation> all = check(soup, Level::cut_regular);
  all.erase(
      std::remove_if(all.begin(), all.end(),
                     [](const Violation& v) { return std::holds_alternative<OrphanVertex>(v); }),
      all.end());
  return all;
}

template <int D>
bool coherent(const CellSoup<D>& soup, const std::vector<HalfFacetId>& mates) {
  const auto sign = [&](HalfFacetId h) {
    return soup.signs.empty() ? 1 : soup.signs[cell_of<D>(h).value];
  };
  for (Index h = 0; h < mates.size(); ++h) {
    const HalfFacetId mate = mates[h];
    if (mate.value == detail::kNone || mate.value < h) continue;
    const bool as_written = detail::opposite_as_written<D>(soup.cells, HalfFacetId{h}, mate);
    if (as_written != (sign(HalfFacetId{h}) == sign(mate))) return false;
  }
  return true;
}

/// Gives every part but the first of each star a vertex of its own, in the order of `surplus`.
template <int D>
std::vector<Split> split_parts(std::vector<Cell<D>>& cells, const std::vector<HalfFacetId>& mates,
                               const std::vector<detail::VertexPart>& surplus,
                               std::vector<CornerId>& a_corner) {
  std::vector<Split> splits;
  std::vector<CornerId> part;
  for (const detail::VertexPart& s : surplus) {
    const VertexId copy{static_cast<Index>(a_corner.size())};
    a_corner.push_back(s.least);
    splits.push_back({copy, s.vertex});
    part.clear();
    detail::flood<D>(cells, mates, s.least, s.vertex, part, [&](CornerId corner) {
      cells[cell_of<D>(corner).value][static_cast<std::size_t>(local_index<D>(corner))] = copy;
      return true;  // a renamed corner is found no more by the old vertex
    });
  }
  return splits;
}

template <int D>
Regularized<D> build(CellSoup<D> soup, bool regularize) {
  require_ids_suffice(D, soup.cells.size(), soup.vertex_count);
  detail::require_signs<D>(soup);
  if (!detail::unsound_cells<D>(soup).empty()) throw InvalidComplex(hindrances(soup));
  detail::FacetMatching matching = detail::match_facets<D>(soup.cells, soup.vertex_count);
  if (!matching.crowded.empty() || !matching.duplicates.empty() || !coherent(soup, matching.mates))
    throw InvalidComplex(hindrances(soup));

  auto [a_corner, surplus] = detail::star_pass<D>(soup.cells, matching.mates, soup.vertex_count);
  if (!surplus.empty() && !regularize) throw InvalidComplex(hindrances(soup));
  require_ids_suffice(D, soup.cells.size(), soup.vertex_count + surplus.size());
  std::vector<Split> splits = split_parts<D>(soup.cells, matching.mates, surplus, a_corner);
  std::vector<bool> reversed(soup.cells.size(), false);
  for (std::size_t c = 0; c < soup.signs.size(); ++c) reversed[c] = soup.signs[c] < 0;
  return {detail::ComplexAccess<D>::make(std::move(soup.cells), std::move(matching.mates),
                                         std::move(reversed), std::move(a_corner)),
          std::move(splits)};
}

}  // namespace

template <int D>
Complex<D> assemble(CellSoup<D> soup) {
  return build(std::move(soup), false).complex;
}

template <int D>
Regularized<D> assemble_regularized(CellSoup<D> soup) {
  return build(std::move(soup), true);
}

#define CLEAVE_INSTANTIATE(D)                   \
  template Complex<D> assemble<D>(CellSoup<D>); \
  template Regularized<D> assemble_regularized<D>(CellSoup<D>);
CLEAVE_FOR_EACH_DIMENSION(CLEAVE_INSTANTIATE)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::topology
