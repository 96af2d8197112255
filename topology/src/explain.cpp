#include "cleave/topology/explain.hpp"

#include <algorithm>
#include <cstddef>
#include <unordered_map>

#include "star_steps.hpp"

namespace cleave::topology {
namespace {

/// Breadth first through the star of `vertex`, from cell to cell over facets that are not scored.
template <int D>
std::vector<CellId> shortest_chain(const Complex<D>& k, const FacetSet& scored, VertexId vertex,
                                   CellId from, CellId to) {
  std::unordered_map<CellId, CellId> reached_from{{from, from}};
  std::vector<CellId> queue{from};
  for (std::size_t next = 0; next < queue.size() && !reached_from.contains(to); ++next) {
    const CellId cell = queue[next];
    detail::for_each_step(k, vertex, cell, [&](HalfFacetId h) {
      if (scored.contains(detail::lesser(k, h))) return;
      const CellId neighbour = cell_of<D>(*k.mate(h));
      if (reached_from.try_emplace(neighbour, cell).second) queue.push_back(neighbour);
    });
  }

  if (!reached_from.contains(to)) return {};
  std::vector<CellId> chain{to};
  while (chain.back() != from) chain.push_back(reached_from.at(chain.back()));
  std::reverse(chain.begin(), chain.end());
  return chain;
}

}  // namespace

template <int D>
std::vector<Because> explain(const Complex<D>& k, const FacetSet& scored, HalfFacetId facet) {
  if (facet.value >= k.half_facet_count()) throw NotInterior(facet);
  const auto mate = k.mate(facet);
  if (!mate) throw NotInterior(facet);
  std::vector<Because> reasons;
  for (const VertexId vertex : k.facet(facet))
    reasons.push_back(
        {vertex, shortest_chain(k, scored, vertex, cell_of<D>(facet), cell_of<D>(*mate))});
  return reasons;
}

template std::vector<Because> explain(const Complex<1>&, const FacetSet&, HalfFacetId);
template std::vector<Because> explain(const Complex<2>&, const FacetSet&, HalfFacetId);
template std::vector<Because> explain(const Complex<3>&, const FacetSet&, HalfFacetId);
template std::vector<Because> explain(const Complex<4>&, const FacetSet&, HalfFacetId);

}  // namespace cleave::topology
