#include "cleave/topology/incision.hpp"

#include <algorithm>
#include <utility>

#include "complex_access.hpp"

namespace cleave::topology {
template <int D>
Incision<D>::Incision(Complex<D> original)
    : complex_(std::move(original)), original_vertex_count_(complex_.vertex_count()) {}

template <int D>
VertexId Incision<D>::original(VertexId vertex) const {
  return vertex.value < original_vertex_count_
             ? vertex
             : original_of_copy_[vertex.value - original_vertex_count_];
}

template <int D>
std::vector<OpenedFacet> Incision<D>::opened() const {
  std::vector<OpenedFacet> opened;
  opened.reserve(sides_.size() / 2);
  for (const auto& [half_facet, side] : sides_)
    if (half_facet < side.former_mate) opened.push_back({half_facet, side.former_mate, side.by});
  std::sort(opened.begin(), opened.end(),
            [](const OpenedFacet& a, const OpenedFacet& b) { return a.half_facet < b.half_facet; });
  return opened;
}

template <int D>
FacetSet Incision<D>::scored() const {
  std::vector<HalfFacetId> scored(shut_.half_facets().begin(), shut_.half_facets().end());
  for (const auto& [half_facet, side] : sides_)
    if (half_facet < side.former_mate) scored.push_back(half_facet);
  return FacetSet::of_lesser(std::move(scored));
}

template <int D>
FacetSet Incision<D>::facets(std::span<const HalfFacetId> half_facets) const {
  std::vector<HalfFacetId> lesser;
  lesser.reserve(half_facets.size());
  for (const HalfFacetId h : half_facets) {
    if (h.value >= complex_.half_facet_count()) throw NotInterior(h);
    if (const auto mate = complex_.mate(h)) {
      lesser.push_back(std::min(h, *mate));
    } else {
      const auto side = sides_.find(h);
      if (side == sides_.end()) throw NotInterior(h);
      lesser.push_back(std::min(h, side->second.former_mate));
    }
  }
  return FacetSet::of_lesser(std::move(lesser));
}

template <int D>
Relabelling Incision<D>::cut(const FacetSet& facets, Verify verify) {
  std::vector<HalfFacetId> asked(shut_.half_facets().begin(), shut_.half_facets().end());
  for (const HalfFacetId h : facets.half_facets())
    if (sides_.count(h) == 0) asked.push_back(h);
  Relabelling change = unglue(complex_, FacetSet::of_lesser(std::move(asked)), verify);
  for (const Split& split : change.splits) original_of_copy_.push_back(original(split.parent));
  for (const OpenedFacet& facet : change.opened) {
    sides_.emplace(facet.half_facet, Side{facet.former_mate, original(facet.by)});
    sides_.emplace(facet.former_mate, Side{facet.half_facet, original(facet.by)});
  }
  shut_ = FacetSet::of_lesser(change.shut);
  return change;
}

template <int D>
void Incision<D>::forget_shut(const FacetSet& facets) {
  shut_ = shut_ - facets;
}

template <int D>
std::vector<VertexId> canonical(const Incision<D>& incision) {
  const Complex<D>& k = incision.complex();
  struct Copy {
    VertexId original;
    CornerId least;
    VertexId vertex;
  };
  std::vector<Copy> copies;
  const auto originals = static_cast<std::uint32_t>(incision.original_vertex_count());
  for (std::uint32_t v = originals; v < k.vertex_count(); ++v) {
    const std::vector<CornerId> around = star(k, VertexId{v});
    if (around.empty()) continue;
    copies.push_back({incision.original(VertexId{v}),
                      *std::min_element(around.begin(), around.end()), VertexId{v}});
  }
  std::sort(copies.begin(), copies.end(), [](const Copy& a, const Copy& b) {
    return a.original != b.original ? a.original < b.original : a.least < b.least;
  });
  std::vector<VertexId> number(k.vertex_count(), VertexId{detail::kNone});
  for (std::uint32_t v = 0; v < originals; ++v) number[v] = VertexId{v};
  std::uint32_t next = originals;
  for (const Copy& copy : copies) number[copy.vertex.value] = VertexId{next++};
  return number;
}

#define CLEAVE_INSTANTIATE(D) \
  template class Incision<D>; \
  template std::vector<VertexId> canonical<D>(const Incision<D>&);
CLEAVE_INSTANTIATE(1)
CLEAVE_INSTANTIATE(2)
CLEAVE_INSTANTIATE(3)
CLEAVE_INSTANTIATE(4)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::topology
