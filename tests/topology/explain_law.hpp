#pragma once
#include <set>
#include <string>

#include "cleave/topology/explain.hpp"
#include "cleave/topology/unglue.hpp"
#include "view_laws.hpp"

namespace cleave::views {

/// The cells that share a facet that is not scored with a given cell, and the facet's vertices.
using Neighbours = std::map<CellId, std::vector<std::pair<CellId, Vertices>>>;

template <int D>
Neighbours neighbours_by_definition(const Complex<D>& k, const FacetSet& scored) {
  Neighbours neighbours;
  for (const auto& [facet, half_facets] : support::facets_of<D>(k.cells())) {
    if (half_facets.size() != 2 || scored.contains(half_facets[0])) continue;
    const CellId a = cell_of<D>(half_facets[0]), b = cell_of<D>(half_facets[1]);
    neighbours[a].emplace_back(b, ascending(facet));
    neighbours[b].emplace_back(a, ascending(facet));
  }
  return neighbours;
}

/// The cells that are `steps` or fewer steps away from `from` around `vertex`.
inline std::set<CellId> within(const Neighbours& neighbours, VertexId vertex, CellId from,
                               std::size_t steps) {
  std::set<CellId> reached{from};
  for (std::size_t step = 0; step < steps; ++step)
    for (const CellId cell : std::set(reached)) {
      const auto found = neighbours.find(cell);
      if (found == neighbours.end()) continue;
      for (const auto& [neighbour, facet] : found->second)
        if (std::binary_search(facet.begin(), facet.end(), vertex)) reached.insert(neighbour);
    }
  return reached;
}

/// What is wrong with a chain of cells from `from` to `to` around `vertex`; "" if nothing is, and
/// there is none that is shorter.
inline std::string chain_flaw(const Neighbours& neighbours, const Because& because, CellId from,
                              CellId to) {
  const auto& chain = because.through;
  if (chain.size() < 2 || chain.front() != from || chain.back() != to) return "wrong ends";
  for (std::size_t i = 1; i < chain.size(); ++i)
    if (!within(neighbours, because.vertex, chain[i - 1], 1).contains(chain[i]))
      return "a step that is none";
  if (within(neighbours, because.vertex, from, chain.size() - 2).contains(to)) return "a detour";
  return "";
}

/// Explains every facet of `cut` before the cut and every shut one after it, and says what is wrong
/// with that: "" if nothing is.
template <int D>
std::string explanation_flaw(Complex<D> k, const FacetSet& cut) {
  std::vector<HalfFacetId> foretold;
  for (const HalfFacetId h : cut.half_facets())
    for (const Because& because : explain(k, cut, h))
      if (because.through.empty() && (foretold.empty() || foretold.back() != h))
        foretold.push_back(h);

  const Relabelling change = unglue(k, cut);
  std::vector<HalfFacetId> opened;
  for (const OpenedFacet& facet : change.opened) opened.push_back(facet.half_facet);
  if (opened != foretold) return "a facet opened that was not foretold, or stayed shut";

  const FacetSet shut = FacetSet::of_lesser(change.shut);
  const Neighbours neighbours = neighbours_by_definition(k, shut);
  for (const HalfFacetId h : change.shut) {
    const auto reasons = explain(k, shut, h);
    const Facet<D> facet = k.facet(h);
    for (std::size_t i = 0; i < facet.size(); ++i) {
      if (reasons.size() != facet.size() || reasons[i].vertex != facet[i]) return "wrong vertices";
      const auto flaw = chain_flaw(neighbours, reasons[i], cell_of<D>(h), cell_of<D>(*k.mate(h)));
      if (!flaw.empty()) return flaw;
    }
  }
  return "";
}

}  // namespace cleave::views
