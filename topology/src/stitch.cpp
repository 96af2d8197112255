#include <algorithm>
#include <array>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "cleave/topology/incision.hpp"
#include "dimensions.hpp"
#include "free_ids.hpp"
#include "incision_memory.hpp"
#include "make_room.hpp"
#include "prefetch.hpp"
#include "sort_ids.hpp"

namespace cleave::topology {
namespace {

/// How many facets, classes or corners ahead memory is asked for.
constexpr std::size_t kAhead = 8;

/// Asks for what is known of both sides of the facet that comes `kAhead` after the n-th.
template <int D>
void prefetch_sides(std::span<const Cell<D>> cells, std::span<const detail::FacetMates> facets,
                    std::size_t n) {
  if (n + kAhead >= facets.size()) return;
  detail::prefetch(cells.data() + cell_of<D>(facets[n + kAhead].lesser).value);
  detail::prefetch(cells.data() + cell_of<D>(facets[n + kAhead].greater).value);
}

/// Fills `opened` with those of `facets` that an incision has opened.
void find_opened(std::span<const HalfFacetId> facets, const std::vector<HalfFacetId>& mates,
                 std::vector<detail::FacetMates>& opened) {
  opened.clear();
  for (std::size_t n = 0; n < facets.size(); ++n) {
    const HalfFacetId h = facets[n];
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
  for (std::size_t n = 0; n < facets.size(); ++n) {
    prefetch_sides<D>(k.cells(), facets, n);
    const Facet<D> one = k.facet(facets[n].lesser), other = k.facet(facets[n].greater);
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
    memory.others.clear();
  }

  /// Takes the facets in memory.taken_back back.
  void run() {
    unite_across<D>(incision_, memory_.taken_back, memory_.unions);
    memory_.unions.list_merges(change_.merges);
    if (change_.merges.size() >= detail::kNone - old_vertex_count_)
      throw std::length_error("the stitch needs more vertices than ids can number");
    for (const detail::FacetMates& facet : memory_.taken_back) detail::join(mates_, facet);
    joined_ = true;
    for (Index n = 0; n < change_.merges.size(); ++n) find_class(n);
    list_corners();
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
      for (std::size_t n = 0; n < reached_; ++n) {
        VertexId& v = vertex(memory_.reached[n].corner);
        v = before(v);
      }
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

  /// Floods the class that the n-th merge is about (Algorithm 5). A corner that was reached has
  /// another vertex, so that one comparison tells where the vertex is in a cell and whether that is
  /// new. What the loop uses are copies, which can stay in registers.
  void find_class(Index n) {
    if (n + kAhead < change_.merges.size()) {
      const CornerId corner = *k_.a_corner(change_.merges[n + kAhead].vertex);
      detail::prefetch(cells_.data() + cell_of<D>(corner).value);
      detail::prefetch(mates_.data() + corner.value);
    }
    Cell<D>* const cells = cells_.data();
    const HalfFacetId* const mates = mates_.data();
    const VertexId gone = change_.merges[n].vertex, provisional{old_vertex_count_ + n};
    const CornerId start = *k_.a_corner(gone);
    std::size_t next = reached_;
    reach(start, start);
    vertex(start) = provisional;
    for (; next < reached_; ++next) {
      const auto [corner, through] = memory_.reached[next];
      const HalfFacetId first = half_facet<D>(cell_of<D>(corner), 0);
      for (HalfFacetId h = first; h.value <= first.value + D; ++h.value) {
        if (h == corner || h == through) continue;
        const HalfFacetId across = mates[h.value];
        if (!detail::is_mate(across)) {
          if (across.value != detail::kNone) memory_.others.push_back(h);
          continue;
        }
        Cell<D>& cell = cells[cell_of<D>(across).value];
        for (std::size_t i = 0; i <= D; ++i) {
          if (cell[i] != gone) continue;
          reach(half_facet<D>(cell_of<D>(across), static_cast<int>(i)), across);
          cell[i] = provisional;
          break;
        }
      }
    }
  }

  /// Before the corner is marked, lest memory ends in between.
  void reach(CornerId corner, HalfFacetId through) {
    if (reached_ == memory_.reached.size())
      memory_.reached.resize(std::max<std::size_t>(256, 2 * reached_));
    memory_.reached[reached_++] = {corner, through};
    detail::prefetch(mates_.data() + corner.value);
  }

  /// The vertex before and after the stitch of a corner whose vertex is `v` now, maybe provisional.
  VertexId before(VertexId v) const {
    return v.value < old_vertex_count_ ? v : change_.merges[v.value - old_vertex_count_].vertex;
  }
  VertexId after(VertexId v) const {
    return v.value < old_vertex_count_ ? v : change_.merges[v.value - old_vertex_count_].into;
  }

  void list_corners() {
    memory_.corners.clear();
    memory_.corners.reserve(reached_);
    for (std::size_t n = 0; n < reached_; ++n) memory_.corners.push_back(memory_.reached[n].corner);
    detail::sort_ids(memory_.corners, memory_.spare);
    change_.corners.reserve(reached_);
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
    for (std::size_t n = 0; n < memory_.taken_back.size(); ++n) {
      prefetch_sides<D>(cells_, memory_.taken_back, n);
      const detail::FacetMates& facet = memory_.taken_back[n];
      change_.closed.push_back({facet.lesser, facet.greater, joined_by(facet)});
    }

    std::vector<HalfFacetId>& others = memory_.others;
    for (HalfFacetId& h : others) h = std::min(h, *detail::former_mate(mates_, h));
    detail::sort_ids(others, memory_.spare);
    others.erase(std::unique(others.begin(), others.end()), others.end());
    change_.shut.reserve(others.size());
    for (const HalfFacetId h : others) {
      const HalfFacetId mate = *detail::former_mate(mates_, h);
      const VertexId by = joined_by({h, mate});
      if (by.value == detail::kNone) continue;
      change_.closed.push_back({h, mate, by});
      change_.shut.push_back(h);
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
  std::size_t reached_ = 0;                // corners of all classes
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
    if (verify != Verify::none)
      detail::verify_touched(complex_, memory.cut, change, memory.unglue.verify);
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
  detail::select(facets.half_facets(), mates, scored, [&](HalfFacetId h) {
    if (h.value >= mates.size()) return false;
    const auto mate = detail::former_mate(mates, h);
    return mate ? h < *mate : shut_.contains(h);
  });
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
