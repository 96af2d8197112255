#include "cleave/topology/certify.hpp"

#include <algorithm>
#include <array>
#include <boost/pending/disjoint_sets.hpp>
#include <cstdint>
#include <vector>

#include "cleave/topology/cell_soup.hpp"
#include "dimensions.hpp"
#include "facet_matching.hpp"
#include "star_labels.hpp"

namespace cleave::topology {
namespace {

using Clause = Rejection::Clause;

template <int D>
VertexId at(std::span<const Cell<D>> cells, CornerId corner) {
  return cells[cell_of<D>(corner).value][static_cast<std::size_t>(local_index<D>(corner))];
}

/// One more than the greatest number, if that is not much more than there are corners; otherwise
/// the vertices are numbered anew, in `room`, to which `cells` then points.
template <int D>
std::size_t bound_numbers(std::span<const Cell<D>>& cells, std::vector<Cell<D>>& room) {
  std::size_t bound = 0;
  for (const Cell<D>& cell : cells)
    for (const VertexId v : cell) bound = std::max(bound, std::size_t{v.value} + 1);
  if (bound <= cells.size() * (D + 1)) return bound;
  std::vector<VertexId> numbers;
  for (const Cell<D>& cell : cells) numbers.insert(numbers.end(), cell.begin(), cell.end());
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  room.assign(cells.begin(), cells.end());
  for (Cell<D>& cell : room)
    for (VertexId& v : cell)
      v.value =
          static_cast<Index>(std::lower_bound(numbers.begin(), numbers.end(), v) - numbers.begin());
  cells = room;
  return numbers.size();
}

/// Two corners that share a vertex after, but did not before.
template <int D>
std::optional<Rejection> reject_parent(std::span<const Cell<D>> before,
                                       std::span<const Cell<D>> after, std::size_t after_bound) {
  std::vector<VertexId> parent_of(after_bound, VertexId{kNoIndex});
  for (Index c = 0; c < after.size(); ++c)
    for (int i = 0; i <= D; ++i) {
      const CornerId corner = half_facet<D>(CellId{c}, i);
      VertexId& parent = parent_of[at<D>(after, corner).value];
      if (parent.value == kNoIndex) parent = at<D>(before, corner);
      if (parent == at<D>(before, corner)) continue;
      CornerId first{};
      while (at<D>(after, first) != at<D>(after, corner)) ++first.value;
      return Rejection{Clause::parent, first, corner};
    }
  return std::nullopt;
}

/// The mates of `before` that are not in the cut.
template <int D>
std::vector<HalfFacetId> uncut_mates(std::span<const Cell<D>> before, std::size_t bound,
                                     std::span<const HalfFacetId> cut) {
  std::vector<HalfFacetId> mates = detail::match_facets<D>(before, bound).mates;
  for (const HalfFacetId h : cut) {
    if (h.value >= mates.size() || mates[h.value].value == kNoIndex) continue;
    mates[mates[h.value].value].value = kNoIndex;
    mates[h.value].value = kNoIndex;
  }
  return mates;
}

/// Calls visit(corner, corner) for the two corners at each vertex that mates h and m share.
template <int D, class Visit>
void for_shared_vertices(std::span<const Cell<D>> before, HalfFacetId h, HalfFacetId m,
                         Visit visit) {
  for (int i = 0; i <= D; ++i)
    for (int j = 0; j <= D; ++j) {
      const CornerId one = half_facet<D>(cell_of<D>(h), i);
      const CornerId other = half_facet<D>(cell_of<D>(m), j);
      if (one != h && other != m && at<D>(before, one) == at<D>(before, other)) visit(one, other);
    }
}

/// Two corners of mates that shared a vertex before, but do not after: one of their cells has
/// changed.
template <int D>
std::optional<Rejection> reject_uncut(std::span<const Cell<D>> before,
                                      const std::vector<HalfFacetId>& mates,
                                      std::span<const Cell<D>> after) {
  std::optional<Rejection> rejection;
  for (Index c = 0; c < before.size() && !rejection; ++c) {
    if (before[c] == after[c]) continue;
    for (int i = 0; i <= D; ++i) {
      const HalfFacetId h = half_facet<D>(CellId{c}, i);
      if (mates[h.value].value == kNoIndex) continue;
      for_shared_vertices<D>(before, h, mates[h.value], [&](CornerId one, CornerId other) {
        if (at<D>(after, one) != at<D>(after, other))
          rejection = Rejection{Clause::uncut, one, other};
      });
    }
  }
  return rejection;
}

/// Two corners that share a vertex after, but that no chain of uncut facets connects. Only vertices
/// that the labels of their stars leave in doubt are looked at, with all classes of corners there.
template <int D>
std::optional<Rejection> reject_connected(std::span<const Cell<D>> before,
                                          const std::vector<HalfFacetId>& mates,
                                          std::span<const Cell<D>> after, std::size_t after_bound) {
  std::vector<bool> in_doubt(after_bound, false);
  {
    detail::StarLabels<D> labels(after, mates, after_bound);
    labels.label_all();
    const std::vector<VertexId> suspects = labels.suspects();
    if (suspects.empty()) return std::nullopt;
    for (const VertexId v : suspects) in_doubt[v.value] = true;
  }
  std::vector<Index> rank(mates.size(), 0), parent(mates.size());
  boost::disjoint_sets<Index*, Index*> classes(rank.data(), parent.data());
  for (Index c = 0; c < mates.size(); ++c) classes.make_set(c);
  for (Index h = 0; h < mates.size(); ++h) {
    if (mates[h].value == kNoIndex || mates[h].value < h) continue;
    for_shared_vertices<D>(before, HalfFacetId{h}, mates[h], [&](CornerId one, CornerId other) {
      if (in_doubt[at<D>(after, one).value]) classes.union_set(one.value, other.value);
    });
  }
  std::vector<CornerId> first(after_bound, CornerId{kNoIndex});
  for (Index c = 0; c < mates.size(); ++c) {
    const VertexId vertex = at<D>(after, CornerId{c});
    if (!in_doubt[vertex.value]) continue;
    CornerId& known = first[vertex.value];
    if (known.value == kNoIndex) known = CornerId{c};
    if (classes.find_set(known.value) != classes.find_set(c))
      return Rejection{Clause::connected, known, CornerId{c}};
  }
  return std::nullopt;
}

}  // namespace

std::string_view name(Clause clause) {
  constexpr std::array<std::string_view, 4> kNames{"cells", "parent", "uncut", "connected"};
  return kNames[static_cast<std::size_t>(clause)];
}

std::string describe(const Rejection& rejection) {
  const std::string corners = " (corners " + std::to_string(rejection.one.value) + " and " +
                              std::to_string(rejection.other.value) + ")";
  switch (rejection.clause) {
    case Clause::cells:
      return "the numbers of cells differ";
    case Clause::parent:
      return "two corners share a vertex that come from different vertices" + corners;
    case Clause::uncut:
      return "a facet that is not in the cut came apart at a vertex" + corners;
    case Clause::connected:
      return "two corners share a vertex that no chain of uncut facets connects" + corners;
  }
  return "";
}

template <int D>
std::optional<Rejection> certify(std::span<const Cell<D>> before, std::span<const HalfFacetId> cut,
                                 std::span<const Cell<D>> after) {
  if (before.size() != after.size()) return Rejection{Clause::cells};
  require_ids_suffice(D, before.size(), 0);

  std::vector<Cell<D>> room_before, room_after;
  const std::size_t before_bound = bound_numbers<D>(before, room_before);
  const std::size_t after_bound = bound_numbers<D>(after, room_after);
  if (auto rejection = reject_parent<D>(before, after, after_bound)) return rejection;
  const std::vector<HalfFacetId> mates = uncut_mates<D>(before, before_bound, cut);
  if (auto rejection = reject_uncut<D>(before, mates, after)) return rejection;
  return reject_connected<D>(before, mates, after, after_bound);
}

#define CLEAVE_INSTANTIATE(D)                   \
  template std::optional<Rejection> certify<D>( \
      std::span<const Cell<D>>, std::span<const HalfFacetId>, std::span<const Cell<D>>);
CLEAVE_FOR_EACH_DIMENSION(CLEAVE_INSTANTIATE)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::topology
