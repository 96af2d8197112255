#include "cleave/topology/certify.hpp"

#include <algorithm>
#include <array>
#include <boost/pending/disjoint_sets.hpp>
#include <cstdint>
#include <utility>
#include <vector>

#include "cleave/topology/cell_soup.hpp"
#include "dimensions.hpp"

namespace cleave::topology {
namespace {

using Clause = Rejection::Clause;

template <int D>
VertexId at(std::span<const Cell<D>> cells, CornerId corner) {
  return cells[cell_of<D>(corner).value][static_cast<std::size_t>(local_index<D>(corner))];
}

/// All corners, sorted by their vertex.
template <int D>
std::vector<std::pair<VertexId, CornerId>> corners_by_vertex(std::span<const Cell<D>> cells) {
  std::vector<std::pair<VertexId, CornerId>> by_vertex;
  by_vertex.reserve(cells.size() * (D + 1));
  for (Index c = 0; c < cells.size() * (D + 1); ++c)
    by_vertex.emplace_back(at<D>(cells, CornerId{c}), CornerId{c});
  std::sort(by_vertex.begin(), by_vertex.end());
  return by_vertex;
}

/// Names two corners of one vertex of which `differ` holds, if there are any. Only neighbours in
/// `by_vertex` are looked at, which is enough where "do not differ" is an equivalence.
template <class Corners, class Differ>
std::optional<Rejection> reject_if(Clause clause, const Corners& by_vertex, Differ differ) {
  for (std::size_t n = 1; n < by_vertex.size(); ++n) {
    const CornerId one = by_vertex[n - 1].second, other = by_vertex[n].second;
    if (by_vertex[n - 1].first == by_vertex[n].first && differ(one, other))
      return Rejection{clause, one, other};
  }
  return std::nullopt;
}

struct MatePair {
  HalfFacetId one, other;
};

/// The pairs of half-facets of `cells` with the same vertices, found by sorting them all.
template <int D>
std::vector<MatePair> mates_by_sorting(std::span<const Cell<D>> cells) {
  struct Entry {
    Facet<D> facet;
    HalfFacetId half_facet;
  };
  std::vector<Entry> entries;
  entries.reserve(cells.size() * (D + 1));
  for (Index c = 0; c < cells.size(); ++c)
    for (int opposite = 0; opposite <= D; ++opposite) {
      Entry entry{{}, half_facet<D>(CellId{c}, opposite)};
      auto to = entry.facet.begin();
      for (int i = 0; i <= D; ++i)
        if (i != opposite) *to++ = cells[c][static_cast<std::size_t>(i)];
      std::sort(entry.facet.begin(), entry.facet.end());
      entries.push_back(entry);
    }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return a.facet != b.facet ? a.facet < b.facet : a.half_facet < b.half_facet;
  });
  std::vector<MatePair> mates;
  for (std::size_t n = 1; n < entries.size(); ++n)
    if (entries[n - 1].facet == entries[n].facet)
      mates.push_back({entries[n - 1].half_facet, entries[n].half_facet});
  return mates;
}

/// The mates that are not in the cut.
template <int D>
std::vector<MatePair> uncut_mates(std::span<const Cell<D>> cells,
                                  std::span<const HalfFacetId> cut) {
  std::vector<HalfFacetId> sorted_cut(cut.begin(), cut.end());
  std::sort(sorted_cut.begin(), sorted_cut.end());
  const auto in_cut = [&](HalfFacetId h) {
    return std::binary_search(sorted_cut.begin(), sorted_cut.end(), h);
  };
  std::vector<MatePair> mates = mates_by_sorting<D>(cells);
  mates.erase(
      std::remove_if(mates.begin(), mates.end(),
                     [&](const MatePair& pair) { return in_cut(pair.one) || in_cut(pair.other); }),
      mates.end());
  return mates;
}

/// Calls visit(corner, corner) for the two corners at each vertex that the mates share before the
/// cut.
template <int D, class Visit>
void for_shared_vertices(std::span<const Cell<D>> before, MatePair mates, Visit visit) {
  for (int i = 0; i <= D; ++i)
    for (int j = 0; j <= D; ++j) {
      const CornerId one = half_facet<D>(cell_of<D>(mates.one), i);
      const CornerId other = half_facet<D>(cell_of<D>(mates.other), j);
      if (one != mates.one && other != mates.other && at<D>(before, one) == at<D>(before, other))
        visit(one, other);
    }
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

  const auto by_vertex = corners_by_vertex<D>(after);
  auto rejection = reject_if(Clause::parent, by_vertex, [&](CornerId one, CornerId other) {
    return at<D>(before, one) != at<D>(before, other);
  });
  if (rejection) return rejection;

  // The classes of corners that chains of uncut facets connect are what the last clause is about.
  const std::vector<MatePair> mates = uncut_mates<D>(before, cut);
  std::vector<Index> rank(by_vertex.size(), 0), parent(by_vertex.size());
  boost::disjoint_sets<Index*, Index*> classes(rank.data(), parent.data());
  for (Index c = 0; c < by_vertex.size(); ++c) classes.make_set(c);
  for (const MatePair& pair : mates)
    for_shared_vertices<D>(before, pair, [&](CornerId one, CornerId other) {
      classes.union_set(one.value, other.value);
      if (!rejection && at<D>(after, one) != at<D>(after, other))
        rejection = Rejection{Clause::uncut, one, other};
    });
  if (rejection) return rejection;

  return reject_if(Clause::connected, by_vertex, [&](CornerId one, CornerId other) {
    return classes.find_set(one.value) != classes.find_set(other.value);
  });
}

#define CLEAVE_INSTANTIATE(D)                   \
  template std::optional<Rejection> certify<D>( \
      std::span<const Cell<D>>, std::span<const HalfFacetId>, std::span<const Cell<D>>);
CLEAVE_FOR_EACH_DIMENSION(CLEAVE_INSTANTIATE)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::topology
