#include "cleave/topology/unglue.hpp"

#include <algorithm>
#include <stdexcept>

#include "cleave/topology/violation.hpp"
#include "flood.hpp"

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
  Ungluing(Complex<D>& k, const FacetSet& cut)
      : k_(k),
        cut_(cut),
        cells_(Access::cells(k)),
        mates_(Access::mates(k)),
        old_vertex_count_(static_cast<std::uint32_t>(k.vertex_count())) {
    severed_.reserve(cut.size());
    for (const HalfFacetId h : cut.half_facets()) {
      if (h.value >= mates_.size() || mates_[h.value].value == detail::kNone || mates_[h.value] < h)
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
  struct Mates {
    HalfFacetId lesser, greater;
  };
  /// Corners first .. last of corners_ share a vertex after the cut.
  struct Class {
    VertexId parent;
    CornerId least;
    std::size_t first, last;
    VertexId vertex;
    CornerId named;  // the corner that the parent named before the cut
  };

  void sever() {
    for (const Mates& facet : severed_)
      mates_[facet.lesser.value] = mates_[facet.greater.value] = HalfFacetId{detail::kNone};
  }

  VertexId& vertex(CornerId corner) {
    return cells_[cell_of<D>(corner).value][static_cast<std::size_t>(local_index<D>(corner))];
  }

  /// Every class borders a facet of the cut, since the star was one part before.
  void find_classes() {
    for (const Mates& facet : severed_)
      for (const HalfFacetId side : {facet.lesser, facet.greater})
        for (int i = 0; i <= D; ++i)
          if (i != local_index<D>(side)) find_class(half_facet<D>(cell_of<D>(side), i));
  }

  void find_class(CornerId start) {
    const VertexId parent = vertex(start);
    if (parent.value >= old_vertex_count_) return;  // visited: provisional
    if (old_vertex_count_ + classes_.size() >= detail::kNone)
      throw std::length_error("the cut needs more vertices than 32-bit ids can number");
    const VertexId provisional{old_vertex_count_ + static_cast<std::uint32_t>(classes_.size())};
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
    std::sort(classes_.begin(), classes_.end(), [](const Class& a, const Class& b) {
      return a.parent != b.parent ? a.parent < b.parent : a.least < b.least;
    });
    Relabelling change;
    change.vertices_before = old_vertex_count_;
    std::size_t renamed = 0;
    for (std::size_t n = 0; n < classes_.size(); ++n) {
      Class& c = classes_[n];
      if (n == 0 || classes_[n - 1].parent != c.parent) {
        c.vertex = c.parent;
        continue;
      }
      c.vertex = {old_vertex_count_ + static_cast<std::uint32_t>(change.splits.size())};
      change.splits.push_back({c.vertex, c.parent});
      renamed += c.last - c.first;
    }
    change.vertices_after = old_vertex_count_ + change.splits.size();
    change.corners.reserve(renamed);
    change.opened.reserve(severed_.size());
    change.shut.reserve(severed_.size());
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
    for (const Mates& facet : severed_) {
      if (const auto by = separator(facet, change)) {
        change.opened.push_back({facet.lesser, facet.greater, *by});
      } else {
        mates_[facet.lesser.value] = facet.greater;
        mates_[facet.greater.value] = facet.lesser;
        change.shut.push_back(facet.lesser);
      }
    }
    return change;
  }

  /// The least vertex of a severed facet whose corners in the two cells differ now (T3).
  std::optional<VertexId> separator(const Mates& facet, const Relabelling& change) const {
    const auto parent = [&](VertexId v) {
      return v.value < old_vertex_count_ ? v : change.splits[v.value - old_vertex_count_].parent;
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
    for (const Mates& facet : severed_) {
      mates_[facet.lesser.value] = facet.greater;
      mates_[facet.greater.value] = facet.lesser;
    }
    Access::resize_vertices(k_, old_vertex_count_);
  }

  Complex<D>& k_;
  const FacetSet& cut_;
  std::vector<Cell<D>>& cells_;
  std::vector<HalfFacetId>& mates_;
  const std::uint32_t old_vertex_count_;
  std::vector<Mates> severed_;
  std::vector<Class> classes_;
  std::vector<CornerId> corners_;  // of all classes, one after the other
};

}  // namespace

template <int D>
Relabelling unglue(Complex<D>& k, const FacetSet& cut, Verify verify) {
  return Ungluing<D>(k, cut).run(verify);
}

template Relabelling unglue<1>(Complex<1>&, const FacetSet&, Verify);
template Relabelling unglue<2>(Complex<2>&, const FacetSet&, Verify);
template Relabelling unglue<3>(Complex<3>&, const FacetSet&, Verify);
template Relabelling unglue<4>(Complex<4>&, const FacetSet&, Verify);

}  // namespace cleave::topology
