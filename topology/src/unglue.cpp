#include "cleave/topology/unglue.hpp"

#include <algorithm>

#include "dimensions.hpp"
#include "facet_mates.hpp"
#include "free_ids.hpp"
#include "prefetch.hpp"
#include "sort_ids.hpp"
#include "star_classes.hpp"
#include "unglue_scratch.hpp"

namespace cleave::topology {
namespace {

/// One run of Algorithm 3 on the vertices of a cut. The cut's mates are severed first; then the
/// classes of corners that need a copy get a provisional vertex, which is the final one unless ids
/// are used again; then the facets that stayed shut get their mates back. As long as the run lasts,
/// the verification at its end included, `roll_back` gives the complex back as it was.
template <int D>
class Ungluing {
  using Access = detail::ComplexAccess<D>;
  using Copy = detail::UnglueScratch::Copy;

 public:
  Ungluing(Complex<D>& k, const FacetSet& cut, std::vector<VertexId>& free_ids,
           detail::UnglueScratch& scratch)
      : k_(k),
        cut_(cut.half_facets()),
        cells_(Access::cells(k)),
        mates_(Access::mates(k)),
        old_vertex_count_(static_cast<Index>(k.vertex_count())),
        scratch_(scratch),
        new_ids_(free_ids, old_vertex_count_),
        classes_(cells_, mates_, old_vertex_count_, scratch) {
    scratch.copies.clear();
    scratch.corners.clear();
    scratch.vertices.clear();
  }

  /// Leaves the complex as it was if it throws.
  void run(const FacetSet& cut, Verify verify, Relabelling& change) {
    try {
      sever();
      find_vertices();
      for (std::size_t n = 0; n < scratch_.vertices.size(); ++n) split(n);
      commit(change);
      if (verify != Verify::none) detail::verify_touched(k_, cut, change, scratch_.verify);
      if (verify == Verify::all) verify_all(k_);
      new_ids_.keep();
    } catch (...) {
      roll_back(change);
      throw;
    }
  }

 private:
  /// How many facets or vertices ahead memory is asked for.
  static constexpr std::size_t kAhead = 8;

  VertexId& vertex(CornerId corner) {
    return cells_[cell_of<D>(corner).value][static_cast<std::size_t>(local_index<D>(corner))];
  }

  /// The former mate of a facet of the cut, which is severed.
  HalfFacetId mate(HalfFacetId h) const { return {mates_[h.value].value & ~detail::kSevered}; }

  void sever() {
    for (; severed_ < cut_.size(); ++severed_) {
      if (severed_ + 2 * kAhead < cut_.size())
        detail::prefetch(mates_.data() + cut_[severed_ + 2 * kAhead].value);
      const HalfFacetId h = cut_[severed_];
      if (h.value >= mates_.size() || !detail::is_mate(mates_[h.value]) || mates_[h.value] < h)
        throw NotInterior(h);
      detail::sever(mates_, {h, mates_[h.value]});
    }
  }

  /// The vertices of the cut's facets, ascending. Each has its corner marked until it is split.
  void find_vertices() {
    std::vector<VertexId>& vertices = scratch_.vertices;
    vertices.resize(cut_.size() * D + 1);
    std::size_t count = 0;
    for (std::size_t n = 0; n < cut_.size(); ++n) {
      if (n + kAhead < cut_.size())
        detail::prefetch(cells_.data() + cell_of<D>(cut_[n + kAhead]).value);
      const HalfFacetId h = cut_[n];
      for (int i = 1; i <= D; ++i) {
        const int at = (local_index<D>(h) + i) % (D + 1);
        const VertexId v = cells_[cell_of<D>(h).value][static_cast<std::size_t>(at)];
        CornerId& corner = Access::a_corner(k_, v);
        vertices[count] = v;
        count += corner.value < kMarked ? 1 : 0;
        corner.value |= kMarked;
      }
    }
    vertices.resize(count);
    detail::sort_ids(vertices, scratch_.spare_vertices);
  }

  void split(std::size_t n) {
    const std::vector<VertexId>& vertices = scratch_.vertices;
    if (n + 2 * kAhead < vertices.size())
      detail::prefetch(&Access::a_corner(k_, vertices[n + 2 * kAhead]));
    if (n + kAhead < vertices.size()) {
      const CornerId corner{Access::a_corner(k_, vertices[n + kAhead]).value & ~kMarked};
      detail::prefetch(cells_.data() + cell_of<D>(corner).value);
      detail::prefetch(mates_.data() + corner.value);
    }
    CornerId& corner = Access::a_corner(k_, vertices[n]);
    corner.value &= ~kMarked;
    classes_.split(vertices[n], corner);
  }

  void commit(Relabelling& change) {
    change.vertices_before = old_vertex_count_;
    change.merges.clear();
    change.closed.clear();
    tell_opened_from_shut(change);

    const std::vector<Copy>& copies = scratch_.copies;
    change.splits.clear();
    change.splits.reserve(copies.size());
    for (const Copy& copy : copies) change.splits.push_back({new_ids_.next(), copy.parent});
    change.vertices_after = new_ids_.bound();
    detail::sort_ids(scratch_.corners, scratch_.spare_corners);
    change.corners.clear();
    change.corners.reserve(scratch_.corners.size());
    Access::resize_vertices(k_, change.vertices_after);

    // Nothing below throws.
    committed_ = true;
    for (std::size_t n = 0; n < copies.size(); ++n)
      Access::set_a_corner(k_, change.splits[n].vertex, copies[n].least);
    for (const CornerId corner : scratch_.corners) {
      const Split& split = change.splits[vertex(corner).value - old_vertex_count_];
      vertex(corner) = split.vertex;
      change.corners.push_back({corner, split.parent, split.vertex});
    }
    for (const HalfFacetId h : change.shut) detail::join(mates_, {h, mate(h)});
  }

  /// By the provisional vertices (T3).
  void tell_opened_from_shut(Relabelling& change) const {
    change.opened.clear();
    change.shut.clear();
    change.opened.reserve(cut_.size());
    change.shut.reserve(cut_.size());
    for (const HalfFacetId h : cut_) {
      const HalfFacetId other = mate(h);
      const VertexId by = separator(h, other);
      if (by.value != detail::kNone)
        change.opened.push_back({h, other, by});
      else
        change.shut.push_back(h);
    }
  }

  /// The least vertex of a severed facet whose corners in the two cells are of different classes,
  /// or kNone.
  VertexId separator(HalfFacetId h, HalfFacetId mate) const {
    VertexId least{detail::kNone};
    const Cell<D>& one = cells_[cell_of<D>(h).value];
    const Cell<D>& other = cells_[cell_of<D>(mate).value];
    for (int i = 1; i <= D; ++i) {
      const VertexId v = one[static_cast<std::size_t>((local_index<D>(h) + i) % (D + 1))];
      bool shared = false;
      for (const VertexId w : other) shared = shared || w == v;
      if (shared) continue;
      const bool copy = v.value >= old_vertex_count_;
      least = std::min(least, copy ? scratch_.copies[v.value - old_vertex_count_].parent : v);
    }
    return least;
  }

  void roll_back(const Relabelling& change) noexcept {
    for (const VertexId v : scratch_.vertices) Access::a_corner(k_, v).value &= ~kMarked;
    if (committed_)
      for (const RenamedCorner& renamed : change.corners) vertex(renamed.corner) = renamed.from;
    else
      classes_.roll_back();
    for (const VertexId id : new_ids_.reused())
      Access::set_a_corner(k_, id, CornerId{detail::kNone});
    new_ids_.give_back();
    while (severed_ > 0) {
      const HalfFacetId h = cut_[--severed_];
      detail::join(mates_, {h, mate(h)});
    }
    Access::resize_vertices(k_, old_vertex_count_);
  }

  /// In the corner that a vertex names: the vertex is in the list.
  static constexpr Index kMarked = detail::kSevered;

  Complex<D>& k_;
  const std::span<const HalfFacetId> cut_;
  std::vector<Cell<D>>& cells_;
  std::vector<HalfFacetId>& mates_;
  const Index old_vertex_count_;
  detail::UnglueScratch& scratch_;
  detail::NewIds new_ids_;
  detail::StarClasses<D> classes_;
  std::size_t severed_ = 0;  // of the cut's facets
  bool committed_ = false;   // the corners have their final vertices
};

}  // namespace

template <int D>
Relabelling unglue(Complex<D>& k, const FacetSet& cut, Verify verify) {
  std::vector<VertexId> none;
  detail::UnglueScratch scratch;
  Relabelling change;
  detail::unglue_with_ids(k, cut, verify, none, scratch, change);
  return change;
}

template <int D>
void detail::unglue_with_ids(Complex<D>& k, const FacetSet& cut, Verify verify,
                             std::vector<VertexId>& heap, UnglueScratch& scratch,
                             Relabelling& change) {
  Ungluing<D>(k, cut, heap, scratch).run(cut, verify, change);
}

#define CLEAVE_INSTANTIATE(D)                                                    \
  template Relabelling unglue<D>(Complex<D>&, const FacetSet&, Verify);          \
  template void detail::unglue_with_ids<D>(Complex<D>&, const FacetSet&, Verify, \
                                           std::vector<VertexId>&, UnglueScratch&, Relabelling&);
CLEAVE_FOR_EACH_DIMENSION(CLEAVE_INSTANTIATE)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::topology
