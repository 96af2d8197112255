#include "cleave/topology/fix_it.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "dimensions.hpp"
#include "least_cut.hpp"

namespace cleave::topology {
namespace {

/// Facets found so far beside the scored ones.
template <int D>
class Finder {
 public:
  Finder(const Complex<D>& k, const FacetSet& scored, const FacetSet& asked)
      : k_(k), scored_(scored | asked) {}

  /// A smallest set, besides those found, that opens a facet. At most `limit` facets.
  std::optional<std::vector<HalfFacetId>> smallest(HalfFacetId facet, std::size_t limit) const {
    const std::array<CellId, 1> from{cell_of<D>(facet)}, to{cell_of<D>(*k_.mate(facet))};
    std::optional<std::vector<HalfFacetId>> best;
    for (const VertexId vertex : k_.facet(facet)) {
      auto cut = detail::LeastCut<D>(k_, vertex)
                     .between(from, to, best ? best->size() : limit, [&](HalfFacetId h) {
                       return scored_.contains(h) || found_.contains(h);
                     });
      if (!cut) continue;
      if (!best || std::pair(cut->size(), *cut) < std::pair(best->size(), *best))
        best = std::move(cut);
      if (best->empty()) break;
    }
    return best;
  }

  bool opens(HalfFacetId facet) const { return smallest(facet, 0).has_value(); }

  void add(const std::vector<HalfFacetId>& facets) { found_.insert(facets.begin(), facets.end()); }
  void remove(HalfFacetId facet) { found_.erase(facet); }
  FacetSet found() const { return FacetSet::of_lesser({found_.begin(), found_.end()}); }

 private:
  const Complex<D>& k_;
  FacetSet scored_;
  std::unordered_set<HalfFacetId> found_;
};

}  // namespace

template <int D>
FacetSet separating_facets(const Complex<D>& k, const FacetSet& scored, HalfFacetId facet) {
  return separating_facets(k, scored, std::span<const HalfFacetId>(&facet, 1));
}

template <int D>
FacetSet separating_facets(const Complex<D>& k, const FacetSet& scored,
                           std::span<const HalfFacetId> facets) {
  const FacetSet asked = FacetSet::of(k, facets);
  Finder<D> finder(k, scored, asked);
  for (const HalfFacetId facet : asked.half_facets())
    finder.add(*finder.smallest(facet, k.half_facet_count()));
  if (asked.size() < 2) return finder.found();

  // What is needed by none of them is left out. Only a facet with a common vertex can need it.
  std::unordered_map<VertexId, std::vector<HalfFacetId>> around;
  for (const HalfFacetId facet : asked.half_facets())
    for (const VertexId vertex : k.facet(facet)) around[vertex].push_back(facet);
  const FacetSet found = finder.found();
  for (const HalfFacetId h : found.half_facets()) {
    finder.remove(h);
    bool needed = false;
    for (const VertexId vertex : k.facet(h)) {
      const auto near = around.find(vertex);
      if (near == around.end()) continue;
      for (const HalfFacetId facet : near->second) needed = needed || !finder.opens(facet);
    }
    if (needed) finder.add({h});
  }
  return finder.found();
}

#define CLEAVE_INSTANTIATE(D)                                                              \
  template FacetSet separating_facets<D>(const Complex<D>&, const FacetSet&, HalfFacetId); \
  template FacetSet separating_facets<D>(const Complex<D>&, const FacetSet&,               \
                                         std::span<const HalfFacetId>);
CLEAVE_FOR_EACH_DIMENSION(CLEAVE_INSTANTIATE)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::topology
