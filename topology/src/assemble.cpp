#include "cleave/topology/assemble.hpp"

#include <algorithm>
#include <utility>

#include "cleave/topology/check.hpp"
#include "dimensions.hpp"
#include "plain_mates.hpp"
#include "soundness.hpp"
#include "star_pass.hpp"

namespace cleave::topology {
namespace {

/// The fraction of the work that is done when the mates are found.
constexpr double kMatched = 0.6;

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

/// A bit for each cell that has a sign other than +1; the signs are gone.
std::vector<bool> reversed_cells(std::size_t cell_count, std::vector<std::int8_t> signs) {
  std::vector<bool> reversed(cell_count, false);
  for (std::size_t c = 0; c < signs.size(); ++c) reversed[c] = signs[c] < 0;
  return reversed;
}

template <int D>
[[noreturn]] void refuse(CellSoup<D> soup, const std::vector<bool>& reversed) {
  soup.signs.resize(soup.cells.size());
  for (std::size_t c = 0; c < reversed.size(); ++c)
    soup.signs[c] = static_cast<std::int8_t>(reversed[c] ? -1 : 1);
  std::vector<Violation> found = hindrances(soup);
  if (found.empty()) throw InvariantBroken("a complex was refused of which check finds no fault");
  throw InvalidComplex(std::move(found));
}

/// Not more threads than the cells keep busy.
RunOptions limited(RunOptions options, std::size_t cells) {
  constexpr std::size_t kCellsPerThread = 1024;
  const auto most = static_cast<int>(std::min<std::size_t>(cells / kCellsPerThread + 1, 1024));
  options.threads = std::min(options.threads, most);
  return options;
}

template <int D>
Regularized<D> build(CellSoup<D> soup, bool regularize, const RunOptions& options) {
  require_ids_suffice(D, soup.cells.size(), soup.vertex_count);
  detail::require_signs<D>(soup);
  std::vector<bool> reversed = reversed_cells(soup.cells.size(), std::exchange(soup.signs, {}));
  detail::Crew crew(limited(options, soup.cells.size()));
  crew.next_stage(kMatched);
  auto mates = detail::plain_mates<D>(
      soup.cells, soup.vertex_count, [&](CellId c) { return reversed[c.value]; }, crew);
  if (!mates) refuse(std::move(soup), reversed);
  crew.end_stage();

  crew.next_stage(1);
  auto [a_corner, surplus] = detail::star_pass<D>(soup.cells, *mates, soup.vertex_count);
  if (!surplus.empty() && !regularize) refuse(std::move(soup), reversed);
  require_ids_suffice(D, soup.cells.size(), soup.vertex_count + surplus.size());
  std::vector<Split> splits = split_parts<D>(soup.cells, *mates, surplus, a_corner);
  crew.end_stage();
  return {detail::ComplexAccess<D>::make(std::move(soup.cells), std::move(*mates),
                                         std::move(reversed), std::move(a_corner)),
          std::move(splits)};
}

}  // namespace

template <int D>
Complex<D> assemble(CellSoup<D> soup, const RunOptions& options) {
  return build(std::move(soup), false, options).complex;
}

template <int D>
Regularized<D> assemble_regularized(CellSoup<D> soup, const RunOptions& options) {
  return build(std::move(soup), true, options);
}

#define CLEAVE_INSTANTIATE(D)                                      \
  template Complex<D> assemble<D>(CellSoup<D>, const RunOptions&); \
  template Regularized<D> assemble_regularized<D>(CellSoup<D>, const RunOptions&);
CLEAVE_FOR_EACH_DIMENSION(CLEAVE_INSTANTIATE)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::topology
