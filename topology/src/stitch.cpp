#include <algorithm>
#include <array>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "cleave/topology/incision.hpp"
#include "dimensions.hpp"
#include "flood.hpp"
#include "free_ids.hpp"
#include "incision_memory.hpp"
#include "make_room.hpp"

namespace cleave::topology {
namespace {

/// Fills `opened` with those of `facets` that an incision has opened.
void find_opened(std::span<const HalfFacetId> facets, const std::vector<HalfFacetId>& mates,
                 std::vector<detail::FacetMates>& opened) {
  opened.clear();
  for (const HalfFacetId h : facets) {
    if (h.value >= mates.size()) continue;
    if (const auto mate = detail::former_mate(mates, h); mate && h < *mate)
      opened.push_back({h, *mate});
  }
}

/// Which vertices become one when `facets` of an incision are taken back. Classes of corners merge
/// only across these facets: one that is shut joins no classes that were apart (T8).
template <int D>
void unite_across(const Incision<D>& incision, std::span<const detail::FacetMates> facets,
                  detail::VertexUnions& unions) {
  const Complex<D>& k = incision.complex();
  const auto is_copy = [&](VertexId v) { return v.value >= incision.original_vertex_count(); };
  const auto node = [&](VertexId v) { return unions.node(v, [&] { return *k.a_corner(v); }); };
  unions.clear();
  for (const detail::FacetMates& facet : facets) {
    const Facet<D> one = k.facet(facet.lesser), other = k.facet(facet.greater);
    for (const VertexId v : one) {
      if (std::find(other.begin(), other.end(), v) != other.end()) continue;
      const VertexId original = incision.original(v);
      const VertexId twin = *std::find_if(
          other.begin(), other.end(), [&](VertexId w) { return incision.original(w) == original; });
      if (!is_copy(v))
        unions.unite_with_original(node(twin), v);
      else if (!is_copy(twin))
        unions.unite_with_original(node(v), twin);
      else
        unions.unite(node(v), node(twin));
    }
  }
}

/// One run of a stitch on the complex of an incision. The classes of corners that lose their vertex
/// are flooded and get provisional vertices, by which it is told which facets close: those taken
/// back, and others that no vertex separates any more. Then the corners get their final vertices
/// and these facets their mates. Until the caller is content, `roll_back` gives the complex back as
/// it was.
template <int D>
class Stitching {
  using Access = detail::ComplexAccess<D>;

 public:
  Stitching(Complex<D>& k, const Incision<D>& incision, detail::IncisionMemory<D>& memory,
            Relabelling& change)
      : k_(k),
        incision_(incision),
        memory_(memory),
        change_(change),
        cells_(Access::cells(k)),
        mates_(Access::mates(k)),
        old_vertex_count_(static_cast<Index>(k.vertex_count())) {
    change.clear(old_vertex_count_);
    memory.corners.clear();
    memory.others.clear();
  }

  /// Takes the facets in memory.taken_back back.
  void run() {
    unite_across<D>(incision_, memory_.taken_back, memory_.unions);
    memory_.unions.list_merges(change_.merges);
    if (change_.merges.size() >= detail::kNone - old_vertex_count_)
      throw std::length_error("the stitch needs more vertices than ids can number");
    for (Index n = 0; n < change_.merges.size(); ++n) find_class(n);
    std::sort(memory_.corners.begin(), memory_.corners.end());
    change_.corners.reserve(memory_.corners.size());
    for (const detail::FacetMates& facet : memory_.taken_back) detail::join(mates_, facet);
    joined_ = true;
    find_others();
    list_closed();

    // Nothing below throws.
    for (const OpenedFacet& facet : change_.closed)
      detail::join(mates_, {facet.half_facet, facet.former_mate});
    rename();
    free_vertices();
  }

  void roll_back() noexcept {
    if (joined_)
      for (const detail::FacetMates& facet : memory_.taken_back) detail::sever(mates_, facet);
    if (!renamed_) {
      for (const CornerId corner : memory_.corners) vertex(corner) = before(vertex(corner));
      return;
    }
    Access::resize_vertices(k_, old_vertex_count_);  // there is room for them still
    for (const OpenedFacet& facet : change_.closed)
      detail::sever(mates_, {facet.half_facet, facet.former_mate});
    for (std::size_t n = change_.corners.size(); n-- > 0;) {  // at last, the least of each class
      vertex(change_.corners[n].corner) = change_.corners[n].from;
      Access::set_a_corner(k_, change_.corners[n].from, change_.corners[n].corner);
    }
  }

 private:
  VertexId& vertex(CornerId corner) {
    return cells_[cell_of<D>(corner).value][static_cast<std::size_t>(local_index<D>(corner))];
  }

  /// Floods the class that the n-th merge is about.
  void find_class(Index n) {
    const VertexId gone = change_.merges[n].vertex, provisional{old_vertex_count_ + n};
    detail::flood<D>(cells_, mates_, *k_.a_corner(gone), gone, memory_.corners,
                     [&](CornerId corner) {
                       // A visited corner is found no more by its old vertex.
                       vertex(corner) = provisional;
                       return true;
                     });
  }

  /// The vertex before and after the stitch of a corner whose vertex is `v` now, maybe provisional.
  VertexId before(VertexId v) const {
    return v.value < old_vertex_count_ ? v : change_.merges[v.value - old_vertex_count_].vertex;
  }
  VertexId after(VertexId v) const {
    return v.value < old_vertex_count_ ? v : change_.merges[v.value - old_vertex_count_].into;
  }

  /// Facets at a renamed corner that are open still: of all others, only these may close.
  void find_others() {
    CellId last{detail::kNone};
    for (const CornerId corner : memory_.corners) {
      const CellId cell = cell_of<D>(corner);
      if (cell == last) continue;
      last = cell;
      for (int i = 0; i <= D; ++i) {
        const auto h = half_facet<D>(cell, i);
        if (const auto mate = detail::former_mate(mates_, h))
          memory_.others.push_back({std::min(h, *mate), std::max(h, *mate)});
      }
    }
  }

  /// The least vertex that a facet has on both sides after the stitch, but not before; none if it
  /// has a vertex that stays separated.
  VertexId joined_by(const detail::FacetMates& facet) const {
    VertexId least{detail::kNone};
    const Facet<D> one = k_.facet(facet.lesser), other = k_.facet(facet.greater);
    for (const VertexId v : one) {
      const VertexId joined = after(v);
      const auto twin =
          std::find_if(other.begin(), other.end(), [&](VertexId w) { return after(w) == joined; });
      if (twin == other.end()) return {detail::kNone};
      if (before(*twin) != before(v)) least = std::min(least, joined);
    }
    return least;
  }

  void list_closed() {
    change_.closed.reserve(memory_.taken_back.size() + memory_.others.size());
    for (const detail::FacetMates& facet : memory_.taken_back)
      change_.closed.push_back({facet.lesser, facet.greater, joined_by(facet)});

    const auto by_lesser = [](const auto& a, const auto& b) { return a.lesser < b.lesser; };
    std::vector<detail::FacetMates>& others = memory_.others;
    std::sort(others.begin(), others.end(), by_lesser);
    change_.shut.reserve(others.size());
    HalfFacetId last{detail::kNone};
    for (const detail::FacetMates& facet : others) {
      if (facet.lesser == last) continue;
      last = facet.lesser;
      const VertexId by = joined_by(facet);
      if (by.value == detail::kNone) continue;
      change_.closed.push_back({facet.lesser, facet.greater, by});
      change_.shut.push_back(facet.lesser);
    }
    if (change_.shut.empty()) return;
    std::sort(
        change_.closed.begin(), change_.closed.end(),
        [](const OpenedFacet& a, const OpenedFacet& b) { return a.half_facet < b.half_facet; });
  }

  void rename() {
    for (const CornerId corner : memory_.corners) {
      VertexId& v = vertex(corner);
      change_.corners.push_back({corner, before(v), after(v)});
      v = after(v);
    }
    renamed_ = true;
  }

  void free_vertices() {
    for (const Merge& merge : change_.merges)
      Access::set_a_corner(k_, merge.vertex, CornerId{detail::kNone});
    std::size_t bound = old_vertex_count_;
    while (bound > incision_.original_vertex_count() &&
           !k_.a_corner({static_cast<Index>(bound - 1)}))
      --bound;
    Access::resize_vertices(k_, bound);
    change_.vertices_after = bound;
  }

  Complex<D>& k_;
  const Incision<D>& incision_;
  detail::IncisionMemory<D>& memory_;
  Relabelling& change_;
  std::vector<Cell<D>>& cells_;
  std::vector<HalfFacetId>& mates_;
  const Index old_vertex_count_;
  bool joined_ = false, renamed_ = false;  // how far the run has come
};

}  // namespace

template <int D>
std::vector<Merge> Incision<D>::planned_merges(const FacetSet& facets) const {
  std::vector<detail::FacetMates> opened;
  find_opened(facets.half_facets(), detail::ComplexAccess<D>::mates(complex_), opened);
  detail::VertexUnions unions;
  unite_across<D>(*this, opened, unions);
  std::vector<Merge> merges;
  unions.list_merges(merges);
  return merges;
}

template <int D>
void Incision<D>::take_back(std::span<const HalfFacetId> facets, Relabelling& change,
                            Verify verify) {
  Memory& memory = memory_.get();
  find_opened(facets, detail::ComplexAccess<D>::mates(complex_), memory.taken_back);
  Stitching<D> stitching(complex_, *this, memory, change);
  try {
    stitching.run();
    detail::refill(memory.cut, [&](auto& shut) { shut = change.shut; });
    if (verify != Verify::none) verify_touched(complex_, memory.cut, change);
    if (verify == Verify::all) verify_all(complex_);
    detail::refill(memory.shut, [&](std::vector<HalfFacetId>& shut) {
      const auto before = shut_.half_facets();
      std::set_difference(before.begin(), before.end(), facets.begin(), facets.end(),
                          std::back_inserter(shut));
      shut.insert(shut.end(), change.shut.begin(), change.shut.end());
    });
    detail::make_room(free_, change.merges.size());
  } catch (...) {
    stitching.roll_back();
    throw;
  }
  // Nothing below throws.
  std::swap(shut_, memory.shut);
  for (const Merge& merge : change.merges)
    if (merge.vertex.value < change.vertices_after) detail::set_free(free_, merge.vertex);
  original_of_copy_.resize(change.vertices_after - original_vertex_count_);
}

template <int D>
Relabelling Incision<D>::stitch(const FacetSet& facets, Verify verify) {
  Relabelling change;
  stitch(facets, change, verify);
  return change;
}

template <int D>
void Incision<D>::stitch(const FacetSet& facets, Relabelling& change, Verify verify) {
  const auto& mates = detail::ComplexAccess<D>::mates(complex_);
  std::vector<HalfFacetId>& scored = memory_.get().asked;
  scored.clear();
  for (const HalfFacetId h : facets.half_facets()) {
    if (h.value >= mates.size()) continue;
    const auto mate = detail::former_mate(mates, h);
    if (mate ? h < *mate : shut_.contains(h)) scored.push_back(h);
  }
  done_.make_room(scored.size());
  take_back(scored, change, verify);
  record(scored, false);
}

#define CLEAVE_INSTANTIATE(D)                                                               \
  template std::vector<Merge> Incision<D>::planned_merges(const FacetSet&) const;           \
  template void Incision<D>::take_back(std::span<const HalfFacetId>, Relabelling&, Verify); \
  template Relabelling Incision<D>::stitch(const FacetSet&, Verify);                        \
  template void Incision<D>::stitch(const FacetSet&, Relabelling&, Verify);
CLEAVE_FOR_EACH_DIMENSION(CLEAVE_INSTANTIATE)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::topology
