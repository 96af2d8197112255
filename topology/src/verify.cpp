#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "cleave/topology/check.hpp"
#include "cleave/topology/unglue.hpp"
#include "cleave/topology/violation.hpp"

namespace cleave::topology {
namespace {

void require(bool holds, const char* what, std::uint32_t id) {
  if (!holds) throw InvariantBroken(std::string(what) + " (" + std::to_string(id) + ")");
}

template <int D>
Facet<D> sorted_facet(const Complex<D>& k, HalfFacetId h) {
  Facet<D> facet = k.facet(h);
  std::sort(facet.begin(), facet.end());
  return facet;
}

/// The sign of the permutation that sorts facet(h), times the sign the cell induces on it.
template <int D>
int sorted_facet_sign(const Complex<D>& k, HalfFacetId h) {
  const Facet<D> facet = k.facet(h);
  int sign = k.facet_sign(h);
  for (std::size_t i = 0; i < facet.size(); ++i)
    for (std::size_t j = i + 1; j < facet.size(); ++j)
      if (facet[j] < facet[i]) sign = -sign;
  return sign;
}

template <int D>
void verify_half_facets(const Complex<D>& k, CellId cell) {
  for (int i = 0; i <= D; ++i) {
    const HalfFacetId h = half_facet<D>(cell, i);
    const auto mate = k.mate(h);
    if (!mate) continue;
    require(k.mate(*mate) == h, "mates do not name each other at half-facet", h.value);
    require(sorted_facet(k, h) == sorted_facet(k, *mate), "mates differ in vertices at half-facet",
            h.value);
    require(sorted_facet_sign(k, h) == -sorted_facet_sign(k, *mate),
            "mates have the same orientation at half-facet", h.value);
  }
}

void verify_names(const Relabelling& change) {
  require(change.vertices_after == change.vertices_before + change.splits.size(),
          "vertices are not counted right, splits",
          static_cast<std::uint32_t>(change.splits.size()));
  for (std::size_t n = 0; n < change.splits.size(); ++n) {
    const Split& split = change.splits[n];
    require(split.vertex.value == change.vertices_before + n, "a copy is misnumbered",
            split.vertex.value);
    require(split.parent.value < change.vertices_before, "a copy's parent is new",
            split.vertex.value);
  }
  for (const RenamedCorner& renamed : change.corners) {
    require(renamed.from != renamed.to && renamed.from.value < change.vertices_before,
            "a corner is renamed to no copy", renamed.corner.value);
    require(change.parent(renamed.to) == renamed.from, "a corner got a copy of another vertex",
            renamed.corner.value);
  }
}

/// The facets of `cut` are the opened and the shut ones, and what is said of them is so.
template <int D>
void verify_facets(const Complex<D>& k, const FacetSet& cut, const Relabelling& change) {
  require(change.opened.size() + change.shut.size() == cut.size(),
          "opened and shut facets are not those of the cut",
          static_cast<std::uint32_t>(cut.size()));
  for (const HalfFacetId h : change.shut) {
    require(cut.contains(h), "a shut facet was not asked for", h.value);
    require(k.is_interior(h), "a shut facet lost its mate", h.value);
  }
  const auto parents = [&](HalfFacetId h) {
    Facet<D> facet = k.facet(h);
    for (VertexId& v : facet) v = change.parent(v);
    std::sort(facet.begin(), facet.end());
    return facet;
  };
  for (const OpenedFacet& facet : change.opened) {
    require(cut.contains(facet.half_facet), "a facet opened that was not asked for",
            facet.half_facet.value);
    require(!k.is_interior(facet.half_facet) && !k.is_interior(facet.former_mate),
            "an opened facet has a mate", facet.half_facet.value);
    require(sorted_facet(k, facet.half_facet) != sorted_facet(k, facet.former_mate),
            "an opened facet has the same vertices on both sides", facet.half_facet.value);
    require(parents(facet.half_facet) == parents(facet.former_mate),
            "an opened facet's sides do not come from one facet", facet.half_facet.value);
  }
}

using VertexCorner = std::pair<VertexId, CornerId>;

/// The corners on both sides of the cut's facets and those renamed, by vertex: each class of
/// corners at a touched vertex has at least one here.
template <int D>
std::vector<VertexCorner> touched_corners(const Complex<D>& k, const Relabelling& change) {
  std::vector<VertexCorner> touched;
  const auto add_side = [&](HalfFacetId side) {
    for (int i = 0; i <= D; ++i) {
      const CornerId corner = half_facet<D>(cell_of<D>(side), i);
      if (corner != side) touched.emplace_back(k.vertex(corner), corner);
    }
  };
  for (const OpenedFacet& facet : change.opened) {
    add_side(facet.half_facet);
    add_side(facet.former_mate);
  }
  for (const HalfFacetId h : change.shut) {
    add_side(h);
    add_side(*k.mate(h));
  }
  for (const RenamedCorner& renamed : change.corners) {
    require(k.vertex(renamed.corner) == renamed.to, "a corner does not have its new vertex",
            renamed.corner.value);
    touched.emplace_back(renamed.to, renamed.corner);
  }
  std::sort(touched.begin(), touched.end());
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  return touched;
}

}  // namespace

template <int D>
void verify_touched(const Complex<D>& k, const FacetSet& cut, const Relabelling& change) {
  verify_names(change);
  verify_facets(k, cut, change);
  const std::vector<VertexCorner> touched = touched_corners(k, change);
  std::vector<CellId> cells;
  for (auto first = touched.begin(); first != touched.end();) {
    const auto last = std::find_if(first, touched.end(), [&](const VertexCorner& entry) {
      return entry.first != first->first;
    });
    std::vector<CornerId> around = star(k, first->first);
    std::sort(around.begin(), around.end());
    for (const CornerId corner : around) cells.push_back(cell_of<D>(corner));
    for (auto entry = first; entry != last; ++entry)
      require(std::binary_search(around.begin(), around.end(), entry->second),
              "the star of a vertex is not one part", entry->first.value);
    first = last;
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  for (const CellId cell : cells) verify_half_facets(k, cell);
}

template <int D>
void verify_all(const Complex<D>& k) {
  CellSoup<D> soup;
  soup.cells.assign(k.cells().begin(), k.cells().end());
  soup.vertex_count = k.vertex_count();
  soup.signs.reserve(k.cell_count());
  for (std::uint32_t c = 0; c < k.cell_count(); ++c)
    soup.signs.push_back(static_cast<std::int8_t>(k.sign(CellId{c})));
  for (const Violation& violation : check(soup, Level::cut_regular))
    if (!std::holds_alternative<OrphanVertex>(violation))
      throw InvariantBroken(describe(violation));
  for (std::uint32_t c = 0; c < k.cell_count(); ++c) verify_half_facets(k, CellId{c});
}

#define CLEAVE_INSTANTIATE(D)                                                              \
  template void verify_touched<D>(const Complex<D>&, const FacetSet&, const Relabelling&); \
  template void verify_all<D>(const Complex<D>&);
CLEAVE_INSTANTIATE(1)
CLEAVE_INSTANTIATE(2)
CLEAVE_INSTANTIATE(3)
CLEAVE_INSTANTIATE(4)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::topology
