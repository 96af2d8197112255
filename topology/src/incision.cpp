#include "cleave/topology/incision.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include "complex_access.hpp"
#include "dimensions.hpp"
#include "free_ids.hpp"
#include "make_room.hpp"

namespace cleave::topology {
template <int D>
Incision<D>::Incision(Complex<D> original)
    : complex_(std::move(original)), original_vertex_count_(complex_.vertex_count()) {
  detail::ComplexAccess<D>::forget_former_mates(complex_);
}

template <int D>
VertexId Incision<D>::original(VertexId vertex) const {
  return vertex.value < original_vertex_count_
             ? vertex
             : original_of_copy_[vertex.value - original_vertex_count_];
}

template <int D>
std::vector<OpenedFacet> Incision<D>::opened() const {
  std::vector<OpenedFacet> opened;
  opened.reserve(former_mates_.size() / 2);
  for (const auto& [half_facet, mate] : former_mates_) {
    if (mate < half_facet) continue;
    const Facet<D> one = complex_.facet(half_facet), other = complex_.facet(mate);
    std::optional<VertexId> by;
    for (const VertexId v : one)
      if (std::find(other.begin(), other.end(), v) == other.end() && (!by || original(v) < *by))
        by = original(v);
    opened.push_back({half_facet, mate, by.value()});
  }
  std::sort(opened.begin(), opened.end(),
            [](const OpenedFacet& a, const OpenedFacet& b) { return a.half_facet < b.half_facet; });
  return opened;
}

template <int D>
FacetSet Incision<D>::scored() const {
  std::vector<HalfFacetId> scored(shut_.half_facets().begin(), shut_.half_facets().end());
  for (const auto& [half_facet, mate] : former_mates_)
    if (half_facet < mate) scored.push_back(half_facet);
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
      const auto former = former_mates_.find(h);
      if (former == former_mates_.end()) throw NotInterior(h);
      lesser.push_back(std::min(h, former->second));
    }
  }
  return FacetSet::of_lesser(std::move(lesser));
}

template <int D>
Relabelling Incision<D>::cut(const FacetSet& facets, Verify verify) {
  std::vector<HalfFacetId> added;
  for (const HalfFacetId h : facets.half_facets())
    if (!former_mates_.contains(h) && !shut_.contains(h)) added.push_back(h);
  Step step{FacetSet::of_lesser(std::move(added)), true};
  detail::make_room(done_, 1);
  Relabelling change = score(step.facets, verify);
  record(std::move(step));
  return change;
}

template <int D>
Relabelling Incision<D>::score(const FacetSet& facets, Verify verify) {
  const FacetSet asked = shut_ | facets;
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
    detail::make_room(original_of_copy_, 2 * static_cast<std::size_t>(D) * asked.size());
    for (const HalfFacetId h : asked.half_facets()) {
      const HalfFacetId mate = *complex_.mate(h);
      former_mates_.emplace(h, mate);
      former_mates_.emplace(mate, h);
    }
    change = detail::unglue_with_ids(complex_, asked, verify, free_);
  } catch (...) {
    for (const HalfFacetId h : asked.half_facets()) forget_mates(h);
    throw;
  }
  original_of_copy_.resize(change.vertices_after - original_vertex_count_);
  for (const Split& split : change.splits)
    original_of_copy_[split.vertex.value - original_vertex_count_] = original(split.parent);
  for (const HalfFacetId h : change.shut) forget_mates(h);
  shut.assign(change.shut.begin(), change.shut.end());
  shut_ = FacetSet::of_lesser(std::move(shut));
  return change;
}

template <int D>
void Incision<D>::forget_mates(HalfFacetId half_facet) {
  const auto former = former_mates_.find(half_facet);
  if (former == former_mates_.end()) return;
  const HalfFacetId mate = former->second;
  former_mates_.erase(former);
  former_mates_.erase(mate);
}

template <int D>
void Incision<D>::forget_shut(const FacetSet& facets) {
  stitch(facets & shut_, Verify::none);
}

template <int D>
void Incision<D>::record(Step step) {
  if (step.facets.empty()) return;
  done_.push_back(std::move(step));
  undone_.clear();
}

template <int D>
Relabelling Incision<D>::repeat(std::vector<Step>& from, std::vector<Step>& to, bool forwards,
                                Verify verify) {
  if (from.empty())
    throw std::logic_error(forwards ? "there is no step to be done again"
                                    : "there is no step to be taken back");
  detail::make_room(to, 1);
  const Step& step = from.back();
  Relabelling change =
      step.scored == forwards ? score(step.facets, verify) : take_back(step.facets, verify);
  to.push_back(std::move(from.back()));
  from.pop_back();
  return change;
}

template <int D>
Relabelling Incision<D>::undo(Verify verify) {
  return repeat(done_, undone_, false, verify);
}

template <int D>
Relabelling Incision<D>::redo(Verify verify) {
  return repeat(undone_, done_, true, verify);
}

template <int D>
void Incision<D>::forget_steps() {
  done_ = {};
  undone_ = {};
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
  const auto originals = static_cast<Index>(incision.original_vertex_count());
  for (Index v = originals; v < k.vertex_count(); ++v) {
    const std::vector<CornerId> around = star(k, VertexId{v});
    if (around.empty()) continue;
    copies.push_back({incision.original(VertexId{v}),
                      *std::min_element(around.begin(), around.end()), VertexId{v}});
  }
  std::sort(copies.begin(), copies.end(), [](const Copy& a, const Copy& b) {
    return a.original != b.original ? a.original < b.original : a.least < b.least;
  });
  std::vector<VertexId> number(k.vertex_count(), VertexId{detail::kNone});
  for (Index v = 0; v < originals; ++v) number[v] = VertexId{v};
  Index next = originals;
  for (const Copy& copy : copies) number[copy.vertex.value] = VertexId{next++};
  return number;
}

#define CLEAVE_INSTANTIATE(D) \
  template class Incision<D>; \
  template std::vector<VertexId> canonical<D>(const Incision<D>&);
CLEAVE_FOR_EACH_DIMENSION(CLEAVE_INSTANTIATE)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::topology
