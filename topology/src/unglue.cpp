#include "cleave/topology/unglue.hpp"

#include <algorithm>
#include <stdexcept>

#include "cleave/topology/violation.hpp"
#include "dimensions.hpp"
#include "facet_mates.hpp"
#include "flood.hpp"
#include "free_ids.hpp"

namespace cleave::topology {
namespace {

/// One run of Algorithm 3 on the vertices of a cut. The cut's mates are severed first; then each
/// class of corners is flooded and given a provisional vertex, which also marks its corners as
/// visited; then the classes get their final vertices and the facets that stayed shut their mates.
/// As long as the run lasts, the verification at its end included, `roll_back` gives the complex
/// back as it was.
template <int D>
class Ungluing {
  using Access = detail::ComplexAccess<D>;

 public:
  Ungluing(Complex<D>& k, const FacetSet& cut, std::vector<VertexId>& free_ids)
      : k_(k),
        cut_(cut),
        cells_(Access::cells(k)),
        mates_(Access::mates(k)),
        old_vertex_count_(static_cast<Index>(k.vertex_count())),
        new_ids_(free_ids, old_vertex_count_) {
    severed_.reserve(cut.size());
    for (const HalfFacetId h : cut.half_facets()) {
      if (h.value >= mates_.size() || !detail::is_mate(mates_[h.value]) || mates_[h.value] < h)
        throw NotInterior(h);
      severed_.push_back({h, mates_[h.value]});
    }
  }

  Relabelling run(Verify verify) {
    try {
      sever();
      find_classes();
      Relabelling change = commit();
      if (verify != Verify::none) verify_touched(k_, cut_, change);
      if (verify == Verify::all) verify_all(k_);
      return change;
    } catch (...) {
      roll_back();
      throw;
    }
  }

 private:
  /// Corners first .. last of corners_ share a vertex after the cut.
  struct Class {
    VertexId parent;
    CornerId least;
    std::size_t first, last;
    VertexId vertex;
    CornerId named;  // the corner that the parent named before the cut
  };

  void sever() {
    for (const detail::FacetMates& facet : severed_) detail::sever(mates_, facet);
  }

  VertexId& vertex(CornerId corner) {
    return cells_[cell_of<D>(corner).value][static_cast<std::size_t>(local_index<D>(corner))];
  }

  /// Every class borders a facet of the cut, since the star was one part before.
  void find_classes() {
    for (const detail::FacetMates& facet : severed_)
      for (const HalfFacetId side : {facet.lesser, facet.greater})
        for (int i = 0; i <= D; ++i)
          if (i != local_index<D>(side)) find_class(half_facet<D>(cell_of<D>(side), i));
  }

  void find_class(CornerId start) {
    const VertexId parent = vertex(start);
    if (parent.value >= old_vertex_count_) return;  // visited: provisional
    if (old_vertex_count_ + classes_.size() >= detail::kNone)
      throw std::length_error("the cut needs more vertices than " + std::to_string(kIdBits) +
                              "-bit ids can number");
    const VertexId provisional{old_vertex_count_ + static_cast<Index>(classes_.size())};
    const CornerId named = *k_.a_corner(parent);
    classes_.push_back({parent, start, corners_.size(), corners_.size(), provisional, named});
    // A visited corner is found no more by its old vertex, so each one reached is new.
    detail::flood<D>(cells_, mates_, start, parent, corners_, [&](CornerId corner) {
      vertex(corner) = provisional;
      classes_.back().last = corners_.size();
      classes_.back().least = std::min(classes_.back().least, corner);
      return true;
    });
  }

  Relabelling commit() {
    Relabelling change;
    change.vertices_before = old_vertex_count_;
    tell_opened_from_shut(change);

    std::sort(classes_.begin(), classes_.end(), [](const Class& a, const Class& b) {
      return a.parent != b.parent ? a.parent < b.parent : a.least < b.least;
    });
    std::size_t copies = 0, renamed = 0;
    for (std::size_t n = 1; n < classes_.size(); ++n) {
      if (classes_[n - 1].parent != classes_[n].parent) continue;
      ++copies;
      renamed += classes_[n].last - classes_[n].first;
    }
    change.splits.reserve(copies);
    change.corners.reserve(renamed);
    new_ids_.make_room(copies);
    for (std::size_t n = 0; n < classes_.size(); ++n) {
      Class& c = classes_[n];
      c.vertex = c.parent;
      if (n == 0 || classes_[n - 1].parent != c.parent) continue;
      c.vertex = new_ids_.next();
      change.splits.push_back({c.vertex, c.parent});
    }
    change.vertices_after = new_ids_.bound();
    Access::resize_vertices(k_, change.vertices_after);

    // Nothing below throws.
    for (const Class& c : classes_) {
      Access::set_a_corner(k_, c.vertex, c.least);
      for (std::size_t n = c.first; n < c.last; ++n) {
        vertex(corners_[n]) = c.vertex;
        if (c.vertex != c.parent) change.corners.push_back({corners_[n], c.parent, c.vertex});
      }
    }
    std::sort(change.corners.begin(), change.corners.end(),
              [](const RenamedCorner& a, const RenamedCorner& b) { return a.corner < b.corner; });
    auto shut = change.shut.begin();
    for (const detail::FacetMates& facet : severed_) {
      if (shut == change.shut.end() || *shut != facet.lesser) continue;
      detail::join(mates_, facet);
      ++shut;
    }
    return change;
  }

  /// By the provisional vertices (T3).
  void tell_opened_from_shut(Relabelling& change) const {
    change.opened.reserve(severed_.size());
    change.shut.reserve(severed_.size());
    for (const detail::FacetMates& facet : severed_)
      if (const auto by = separator(facet))
        change.opened.push_back({facet.lesser, facet.greater, *by});
      else
        change.shut.push_back(facet.lesser);
  }

  /// The least vertex of a severed facet whose corners in the two cells are of different classes.
  std::optional<VertexId> separator(const detail::FacetMates& facet) const {
    const auto parent = [&](VertexId v) {
      return v.value < old_vertex_count_ ? v : classes_[v.value - old_vertex_count_].parent;
    };
    std::optional<VertexId> least;
    const Cell<D>& one = cells_[cell_of<D>(facet.lesser).value];
    const Cell<D>& other = cells_[cell_of<D>(facet.greater).value];
    for (std::size_t i = 0; i < one.size(); ++i) {
      if (static_cast<int>(i) == local_index<D>(facet.lesser)) continue;
      const VertexId old = parent(one[i]);
      for (const VertexId w : other)
        if (w != one[i] && parent(w) == old && (!least || old < *least)) least = old;
    }
    return least;
  }

  void roll_back() noexcept {
    for (const Class& c : classes_) {
      for (std::size_t n = c.first; n < c.last; ++n) vertex(corners_[n]) = c.parent;
      Access::set_a_corner(k_, c.parent, c.named);
    }
    for (const VertexId id : new_ids_.reused())
      Access::set_a_corner(k_, id, CornerId{detail::kNone});
    new_ids_.give_back();
    for (const detail::FacetMates& facet : severed_) detail::join(mates_, facet);
    Access::resize_vertices(k_, old_vertex_count_);
  }

  Complex<D>& k_;
  const FacetSet& cut_;
  std::vector<Cell<D>>& cells_;
  std::vector<HalfFacetId>& mates_;
  const Index old_vertex_count_;
  detail::NewIds new_ids_;
  std::vector<detail::FacetMates> severed_;
  std::vector<Class> classes_;
  std::vector<CornerId> corners_;  // of all classes, one after the other
};

}  // namespace

template <int D>
Relabelling unglue(Complex<D>& k, const FacetSet& cut, Verify verify) {
  std::vector<VertexId> none;
  return detail::unglue_with_ids(k, cut, verify, none);
}

template <int D>
Relabelling detail::unglue_with_ids(Complex<D>& k, const FacetSet& cut, Verify verify,
                                    std::vector<VertexId>& heap) {
  return Ungluing<D>(k, cut, heap).run(verify);
}

#define CLEAVE_INSTANTIATE(D)                                                           \
  template Relabelling unglue<D>(Complex<D>&, const FacetSet&, Verify);                 \
  template Relabelling detail::unglue_with_ids<D>(Complex<D>&, const FacetSet&, Verify, \
                                                  std::vector<VertexId>&);
CLEAVE_FOR_EACH_DIMENSION(CLEAVE_INSTANTIATE)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::topology
