#include "cleave/topology/incision.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <utility>

#include "dimensions.hpp"
#include "free_ids.hpp"
#include "incision_memory.hpp"
#include "make_room.hpp"

namespace cleave::topology {
namespace {

template <int D>
using Access = detail::ComplexAccess<D>;

/// The lesser half-facets of all opened facets, ascending. Each has a copy on one side at least.
template <int D>
std::vector<HalfFacetId> opened_half_facets(const Complex<D>& k, std::size_t originals) {
  std::vector<HalfFacetId> opened;
  const auto& mates = Access<D>::mates(k);
  for (auto v = static_cast<Index>(originals); v < k.vertex_count(); ++v)
    for (const CornerId corner : star(k, VertexId{v}))
      for (int i = 0; i <= D; ++i) {
        const auto h = half_facet<D>(cell_of<D>(corner), i);
        if (h == corner) continue;
        if (const auto mate = detail::former_mate(mates, h)) opened.push_back(std::min(h, *mate));
      }
  std::sort(opened.begin(), opened.end());
  opened.erase(std::unique(opened.begin(), opened.end()), opened.end());
  return opened;
}

}  // namespace

template <int D>
Incision<D>::Incision(Complex<D> original)
    : complex_(std::move(original)), original_vertex_count_(complex_.vertex_count()) {
  detail::ComplexAccess<D>::forget_former_mates(complex_);
}

template <int D>
std::vector<OpenedFacet> Incision<D>::opened() const {
  std::vector<OpenedFacet> opened;
  for (const HalfFacetId half_facet : opened_half_facets(complex_, original_vertex_count_)) {
    const HalfFacetId mate = *detail::former_mate(Access<D>::mates(complex_), half_facet);
    const Facet<D> one = complex_.facet(half_facet), other = complex_.facet(mate);
    std::optional<VertexId> by;
    for (const VertexId v : one)
      if (std::find(other.begin(), other.end(), v) == other.end() && (!by || original(v) < *by))
        by = original(v);
    opened.push_back({half_facet, mate, by.value()});
  }
  return opened;
}

template <int D>
FacetSet Incision<D>::scored() const {
  return FacetSet::of_lesser(opened_half_facets(complex_, original_vertex_count_)) | shut_;
}

template <int D>
FacetSet Incision<D>::facets(std::span<const HalfFacetId> half_facets) const {
  FacetSet result;
  facets(half_facets, result);
  return result;
}

template <int D>
void Incision<D>::facets(std::span<const HalfFacetId> half_facets, FacetSet& facets) const {
  const auto& mates = Access<D>::mates(complex_);
  detail::refill(facets, [&](std::vector<HalfFacetId>& lesser) {
    lesser.reserve(half_facets.size());
    for (const HalfFacetId h : half_facets) {
      if (h.value >= mates.size()) throw NotInterior(h);
      auto mate = complex_.mate(h);
      if (!mate) mate = detail::former_mate(mates, h);
      if (!mate) throw NotInterior(h);
      lesser.push_back(std::min(h, *mate));
    }
  });
}

template <int D>
Relabelling Incision<D>::cut(const FacetSet& facets, Verify verify) {
  Relabelling change;
  cut(facets, change, verify);
  return change;
}

template <int D>
void Incision<D>::cut(const FacetSet& facets, Relabelling& change, Verify verify) {
  const auto& mates = Access<D>::mates(complex_);
  std::vector<HalfFacetId>& added = memory_.get().asked;
  detail::select(facets.half_facets(), mates, added, [&](HalfFacetId h) {
    if (h.value >= mates.size()) throw NotInterior(h);
    return !detail::former_mate(mates, h) && !shut_.contains(h);
  });
  done_.make_room(added.size());
  score(added, change, verify);
  record(added, true);
}

template <int D>
void Incision<D>::score(std::span<const HalfFacetId> facets, Relabelling& change, Verify verify) {
  Memory& memory = memory_.get();
  detail::refill(memory.cut, [&](std::vector<HalfFacetId>& cut) {
    const auto shut = shut_.half_facets();
    std::set_union(facets.begin(), facets.end(), shut.begin(), shut.end(), std::back_inserter(cut));
  });

  // All memory first, so that the records cannot miss what the complex has undergone.
  detail::make_room(original_of_copy_, 2 * static_cast<std::size_t>(D) * memory.cut.size());
  detail::refill(memory.shut, [&](auto& shut) { shut.reserve(memory.cut.size()); });
  detail::unglue_with_ids(complex_, memory.cut, verify, free_, memory.unglue, change);

  original_of_copy_.resize(change.vertices_after - original_vertex_count_);
  for (const Split& split : change.splits)
    original_of_copy_[split.vertex.value - original_vertex_count_] = original(split.parent);
  detail::refill(memory.shut, [&](auto& shut) { shut = change.shut; });
  std::swap(shut_, memory.shut);
}

template <int D>
void Incision<D>::forget_shut(const FacetSet& facets) {
  stitch(facets & shut_, Verify::none);
}

template <int D>
void Incision<D>::record(std::span<const HalfFacetId> facets, bool scored) {
  if (facets.empty()) return;
  done_.push({facets, scored});
  done_.keep_latest(most_steps_);
  undone_.clear();
}

template <int D>
void Incision<D>::repeat(detail::StepStack& from, detail::StepStack& to, bool forwards,
                         Relabelling& change, Verify verify) {
  if (from.empty())
    throw std::logic_error(forwards ? "there is no step to be done again"
                                    : "there is no step to be taken back");
  const detail::StepStack::Step step = from.top();
  to.make_room(step.facets.size());
  if (step.scored == forwards)
    score(step.facets, change, verify);
  else
    take_back(step.facets, change, verify);
  to.push(step);
  from.pop();
}

template <int D>
Relabelling Incision<D>::undo(Verify verify) {
  Relabelling change;
  undo(change, verify);
  return change;
}

template <int D>
void Incision<D>::undo(Relabelling& change, Verify verify) {
  repeat(done_, undone_, false, change, verify);
}

template <int D>
Relabelling Incision<D>::redo(Verify verify) {
  Relabelling change;
  redo(change, verify);
  return change;
}

template <int D>
void Incision<D>::redo(Relabelling& change, Verify verify) {
  repeat(undone_, done_, true, change, verify);
}

template <int D>
void Incision<D>::forget_steps() {
  done_.clear();
  undone_.clear();
}

template <int D>
void Incision<D>::keep_steps(std::size_t most) {
  most_steps_ = most;
  done_.keep_latest(most);
  undone_.keep_latest(most);
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
