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
  std::vector<HalfFacetId> lesser(shut_.half_facets().begin(), shut_.half_facets().end());
  for (const HalfFacetId h : facets.half_facets())
    if (sides_.count(h) == 0) lesser.push_back(h);
  const FacetSet asked = FacetSet::of_lesser(std::move(lesser));
  for (const HalfFacetId h : asked.half_facets()) {
    if (h.value >= complex_.half_facet_count()) throw NotInterior(h);
    const auto mate = complex_.mate(h);
    if (!mate || *mate < h) throw NotInterior(h);
  }

  // All memory first, so that the records cannot miss what the complex has undergone.
  std::vector<HalfFacetId> shut;
  Relabelling change;
  try {
    shut.reserve(asked.size());
    make_room_for_copies(2 * static_cast<std::size_t>(D) * asked.size());
    for (const HalfFacetId h : asked.half_facets()) {
      const HalfFacetId mate = *complex_.mate(h);
      sides_.emplace(h, Side{mate, VertexId{}});
      sides_.emplace(mate, Side{h, VertexId{}});
    }
    change = unglue(complex_, asked, verify);
  } catch (...) {
    for (const HalfFacetId h : asked.half_facets()) forget_sides(h);
    throw;
  }
  for (const Split& split : change.splits) original_of_copy_.push_back(original(split.parent));
  for (const OpenedFacet& facet : change.opened)
    sides_.at(facet.half_facet).by = sides_.at(facet.former_mate).by = original(facet.by);
  for (const HalfFacetId h : change.shut) forget_sides(h);
  shut.assign(change.shut.begin(), change.shut.end());
  shut_ = FacetSet::of_lesser(std::move(shut));
  return change;
}

template <int D>
void Incision<D>::make_room_for_copies(std::size_t copies) {
  const std::size_t needed = original_of_copy_.size() + copies;
  if (original_of_copy_.capacity() < needed)
    original_of_copy_.reserve(std::max(needed, 2 * original_of_copy_.capacity()));
}

template <int D>
void Incision<D>::forget_sides(HalfFacetId half_facet) {
  const auto side = sides_.find(half_facet);
  if (side == sides_.end()) return;
  const HalfFacetId mate = side->second.former_mate;
  sides_.erase(side);
  sides_.erase(mate);
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
