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

template <int D>
VertexId at(std::span<const Cell<D>> cells, CornerId corner) {
  return cells[cell_of<D>(corner).value][static_cast<std::size_t>(local_index<D>(corner))];
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
  for (std::uint32_t c = 0; c < cells.size(); ++c)
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

std::string describe(const Rejection& rejection) {
  const std::string corners = " (corners " + std::to_string(rejection.one.value) + " and " +
                              std::to_string(rejection.other.value) + ")";
  switch (rejection.clause) {
    case Rejection::Clause::not_comparable:
      return "the numbers of cells differ";
    case Rejection::Clause::no_parent:
      return "two corners share a vertex that come from different vertices" + corners;
    case Rejection::Clause::uncut_mates_apart:
      return "a facet that is not in the cut came apart at a vertex" + corners;
    case Rejection::Clause::class_not_connected:
      return "two corners share a vertex that no chain of uncut facets connects" + corners;
  }
  return "";
}

template <int D>
std::optional<Rejection> certify(std::span<const Cell<D>> before, std::span<const HalfFacetId> cut,
                                 std::span<const Cell<D>> after) {
  using Clause = Rejection::Clause;
  if (before.size() != after.size()) return Rejection{Clause::not_comparable};
  require_ids_suffice(D, before.size(), 0);

  // (b), and the classes of corners that (c) is about.
  std::vector<HalfFacetId> sorted_cut(cut.begin(), cut.end());
  std::sort(sorted_cut.begin(), sorted_cut.end());
  const auto in_cut = [&](HalfFacetId h) {
    return std::binary_search(sorted_cut.begin(), sorted_cut.end(), h);
  };
  const std::size_t corner_count = before.size() * (D + 1);
  std::vector<std::uint32_t> rank(corner_count, 0), parent(corner_count);
  boost::disjoint_sets<std::uint32_t*, std::uint32_t*> classes(rank.data(), parent.data());
  for (std::uint32_t c = 0; c < corner_count; ++c) classes.make_set(c);
  std::optional<Rejection> rejection;
  for (const MatePair mates : mates_by_sorting<D>(before)) {
    if (in_cut(mates.one) || in_cut(mates.other)) continue;
    for_shared_vertices<D>(before, mates, [&](CornerId one, CornerId other) {
      classes.union_set(one.value, other.value);
      if (!rejection && at<D>(after, one) != at<D>(after, other))
        rejection = Rejection{Clause::uncut_mates_apart, one, other};
    });
  }
  if (rejection) return rejection;

  // (a) and (c): corners that share a vertex after the cut shared it before and are one class.
  std::vector<std::pair<VertexId, CornerId>> by_vertex;
  by_vertex.reserve(corner_count);
  for (std::uint32_t c = 0; c < corner_count; ++c)
    by_vertex.emplace_back(at<D>(after, CornerId{c}), CornerId{c});
  std::sort(by_vertex.begin(), by_vertex.end());
  for (std::size_t n = 1; n < by_vertex.size(); ++n) {
    if (by_vertex[n - 1].first != by_vertex[n].first) continue;
    const CornerId one = by_vertex[n - 1].second, other = by_vertex[n].second;
    if (at<D>(before, one) != at<D>(before, other)) return Rejection{Clause::no_parent, one, other};
    if (classes.find_set(one.value) != classes.find_set(other.value))
      return Rejection{Clause::class_not_connected, one, other};
  }
  return std::nullopt;
}

#define CLEAVE_INSTANTIATE(D)                   \
  template std::optional<Rejection> certify<D>( \
      std::span<const Cell<D>>, std::span<const HalfFacetId>, std::span<const Cell<D>>);
CLEAVE_FOR_EACH_DIMENSION(CLEAVE_INSTANTIATE)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::topology
