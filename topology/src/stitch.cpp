#include <algorithm>
#include <array>
#include <unordered_map>
#include <utility>

#include "cleave/topology/incision.hpp"
#include "dimensions.hpp"
#include "facet_mates.hpp"
#include "flood.hpp"
#include "free_ids.hpp"
#include "make_room.hpp"
#include "vertex_unions.hpp"

namespace cleave::topology {
namespace {

/// Which vertices become one when opened facets of an incision are taken back. Classes of corners
/// merge only across these facets: one that is shut joins no classes that were apart (T8).
template <int D>
class Merging {
 public:
  explicit Merging(const Incision<D>& incision) : incision_(incision) {}

  /// Unites the vertices on the two sides of a facet.
  void across(const detail::FacetMates& facet) {
    const Complex<D>& k = incision_.complex();
    Separated separated;
    separated.fill(detail::kNone);
    const Facet<D> one = k.facet(facet.lesser), other = k.facet(facet.greater);
    for (std::size_t i = 0; i < one.size(); ++i) {
      const VertexId twin = counterpart(one[i], other);
      if (twin == one[i]) continue;
      separated[i] = unions_.node(one[i], *k.a_corner(one[i]));
      unions_.unite(separated[i], unions_.node(twin, *k.a_corner(twin)));
    }
    separated_.push_back(separated);
  }

  /// The vertices that cease to exist, ascending.
  std::vector<Merge> merges() {
    std::vector<Merge> merges;
    for (Index n = 0; n < unions_.nodes().size(); ++n) {
      const VertexId vertex = unions_.nodes()[n].vertex;
      if (const VertexId stays = unions_.stays(n); stays != vertex)
        merges.push_back({vertex, stays});
    }
    std::sort(merges.begin(), merges.end(),
              [](const Merge& a, const Merge& b) { return a.vertex < b.vertex; });
    return merges;
  }

  /// The least of the vertices that stay at which the n-th facet was separated.
  VertexId was_separated_by(std::size_t n) {
    VertexId least{detail::kNone};
    for (const Index node : separated_[n])
      if (node != detail::kNone) least = std::min(least, unions_.stays(node));
    return least;
  }

 private:
  /// The vertex of the other side that is a copy of the same original.
  VertexId counterpart(VertexId vertex, const Facet<D>& other) const {
    if (std::find(other.begin(), other.end(), vertex) != other.end()) return vertex;
    const VertexId original = incision_.original(vertex);
    return *std::find_if(other.begin(), other.end(),
                         [&](VertexId v) { return incision_.original(v) == original; });
  }

  /// For each vertex of a facet its node, or none if it has the same copy on both sides.
  using Separated = std::array<Index, static_cast<std::size_t>(D)>;

  const Incision<D>& incision_;
  detail::VertexUnions unions_;
  std::vector<Separated> separated_;  // of each facet
};

using FormerMates = std::unordered_map<HalfFacetId, HalfFacetId>;

std::vector<detail::FacetMates> opened_among(const FacetSet& facets,
                                             const FormerMates& former_mates) {
  std::vector<detail::FacetMates> opened;
  opened.reserve(std::min(facets.size(), former_mates.size()));
  for (const HalfFacetId h : facets.half_facets()) {
    const auto mate = former_mates.find(h);
    if (mate != former_mates.end() && h < mate->second) opened.push_back({h, mate->second});
  }
  return opened;
}

/// One run of a stitch on the complex of an incision. The classes of corners that lose their vertex
/// are flooded and renamed first, then the facets taken back get their mates again, and so do
/// others that no vertex separates any more. Until the caller is content, `roll_back` gives the
/// complex back as it was.
template <int D>
class Stitching {
  using Access = detail::ComplexAccess<D>;

 public:
  Stitching(Complex<D>& k, const Incision<D>& incision, const FormerMates& former_mates)
      : k_(k),
        incision_(incision),
        former_mates_(former_mates),
        cells_(Access::cells(k)),
        mates_(Access::mates(k)),
        old_vertex_count_(k.vertex_count()) {}

  Relabelling run(const std::vector<detail::FacetMates>& taken_back) {
    Relabelling change;
    change.vertices_before = old_vertex_count_;
    Merging<D> merging(incision_);
    for (const detail::FacetMates& facet : taken_back) merging.across(facet);
    change.merges = merging.merges();
    change.closed.reserve(taken_back.size());
    for (std::size_t n = 0; n < taken_back.size(); ++n)
      change.closed.push_back(
          {taken_back[n].lesser, taken_back[n].greater, merging.was_separated_by(n)});
    merged_.reserve(change.merges.size());

    rename(change);
    for (const detail::FacetMates& facet : taken_back) close(facet);
    close_others(change);
    free_vertices();
    change.vertices_after = k_.vertex_count();
    return change;
  }

  void roll_back() noexcept {
    Access::resize_vertices(k_, old_vertex_count_);  // there is room for them still
    for (const Class& c : merged_) {
      Access::set_a_corner(k_, c.vertex, c.least);
      for (std::size_t n = c.first; n < c.last; ++n) vertex(corners_[n]) = c.vertex;
    }
    for (const detail::FacetMates& facet : closed_) detail::sever(mates_, facet);
  }

 private:
  /// Corners first .. last of corners_ had this vertex.
  struct Class {
    VertexId vertex;
    CornerId least;
    std::size_t first, last;
  };

  VertexId& vertex(CornerId corner) {
    return cells_[cell_of<D>(corner).value][static_cast<std::size_t>(local_index<D>(corner))];
  }

  void rename(Relabelling& change) {
    for (const Merge& merge : change.merges) {
      const CornerId start = *k_.a_corner(merge.vertex);
      merged_.push_back({merge.vertex, start, corners_.size(), corners_.size()});
      // A renamed corner is found no more by its old vertex, so each one reached is new.
      detail::flood<D>(cells_, mates_, start, merge.vertex, corners_, [&](CornerId corner) {
        vertex(corner) = merge.into;
        merged_.back().last = corners_.size();
        return true;
      });
    }
    change.corners.reserve(corners_.size());
    for (const Class& c : merged_)
      for (std::size_t n = c.first; n < c.last; ++n)
        change.corners.push_back({corners_[n], c.vertex, vertex(corners_[n])});
    std::sort(change.corners.begin(), change.corners.end(),
              [](const RenamedCorner& a, const RenamedCorner& b) { return a.corner < b.corner; });
  }

  void close(const detail::FacetMates& facet) {
    closed_.push_back(facet);
    detail::join(mates_, facet);
  }

  /// Facets that are scored still, and that no vertex separates any more. One of their corners has
  /// been renamed.
  void close_others(Relabelling& change) {
    const std::size_t taken_back = closed_.size();
    for (std::size_t n = 0; n < change.corners.size(); ++n) {
      const CellId cell = cell_of<D>(change.corners[n].corner);
      if (n != 0 && cell == cell_of<D>(change.corners[n - 1].corner)) continue;  // looked at
      for (int i = 0; i <= D; ++i) {
        const HalfFacetId h = half_facet<D>(cell, i);
        if (detail::is_mate(mates_[h.value])) continue;
        const auto former = former_mates_.find(h);
        if (former == former_mates_.end() || !same_vertices(h, former->second)) continue;
        close({std::min(h, former->second), std::max(h, former->second)});
      }
    }
    for (std::size_t n = taken_back; n < closed_.size(); ++n) {
      const auto [lesser, greater] = closed_[n];
      change.closed.push_back({lesser, greater, was_separated_by(closed_[n], change)});
      change.shut.push_back(lesser);
    }
    std::sort(
        change.closed.begin(), change.closed.end(),
        [](const OpenedFacet& a, const OpenedFacet& b) { return a.half_facet < b.half_facet; });
    std::sort(change.shut.begin(), change.shut.end());
  }

  bool same_vertices(HalfFacetId one, HalfFacetId other) const {
    const Facet<D> a = k_.facet(one), b = k_.facet(other);
    return std::all_of(a.begin(), a.end(),
                       [&](VertexId v) { return std::find(b.begin(), b.end(), v) != b.end(); });
  }

  /// The least vertex of a facet that had different corners before.
  VertexId was_separated_by(const detail::FacetMates& facet, const Relabelling& change) const {
    const auto before = [&](CellId cell, VertexId v) {
      const CornerId corner = *detail::corner_at<D>(cells_, cell, v);
      const auto at = std::lower_bound(
          change.corners.begin(), change.corners.end(), corner,
          [](const RenamedCorner& renamed, CornerId c) { return renamed.corner < c; });
      return at != change.corners.end() && at->corner == corner ? at->from : v;
    };
    VertexId least{detail::kNone};
    for (const VertexId v : k_.facet(facet.lesser))
      if (before(cell_of<D>(facet.lesser), v) != before(cell_of<D>(facet.greater), v))
        least = std::min(least, v);
    return least;
  }

  void free_vertices() {
    for (const Class& c : merged_) Access::set_a_corner(k_, c.vertex, CornerId{detail::kNone});
    std::size_t bound = old_vertex_count_;
    while (bound > incision_.original_vertex_count() &&
           !k_.a_corner({static_cast<Index>(bound - 1)}))
      --bound;
    Access::resize_vertices(k_, bound);
  }

  Complex<D>& k_;
  const Incision<D>& incision_;
  const FormerMates& former_mates_;
  std::vector<Cell<D>>& cells_;
  std::vector<HalfFacetId>& mates_;
  const std::size_t old_vertex_count_;
  std::vector<Class> merged_;
  std::vector<CornerId> corners_;  // of all merged classes, one after the other
  std::vector<detail::FacetMates> closed_;
};

}  // namespace

template <int D>
std::vector<Merge> Incision<D>::planned_merges(const FacetSet& facets) const {
  Merging<D> merging(*this);
  for (const detail::FacetMates& facet : opened_among(facets, former_mates_)) merging.across(facet);
  return merging.merges();
}

template <int D>
Relabelling Incision<D>::take_back(const FacetSet& facets, Verify verify) {
  Stitching<D> stitching(complex_, *this, former_mates_);
  Relabelling change;
  FacetSet shut;
  try {
    change = stitching.run(opened_among(facets, former_mates_));
    const FacetSet closed_others = FacetSet::of_lesser(change.shut);
    if (verify != Verify::none) verify_touched(complex_, closed_others, change);
    if (verify == Verify::all) verify_all(complex_);
    shut = (shut_ - facets) | closed_others;
    detail::make_room(free_, change.merges.size());
  } catch (...) {
    stitching.roll_back();
    throw;
  }
  // Nothing below throws.
  shut_ = std::move(shut);
  for (const OpenedFacet& facet : change.closed) {
    former_mates_.erase(facet.half_facet);
    former_mates_.erase(facet.former_mate);
  }
  for (const Merge& merge : change.merges)
    if (merge.vertex.value < change.vertices_after) detail::set_free(free_, merge.vertex);
  original_of_copy_.resize(change.vertices_after - original_vertex_count_);
  return change;
}

template <int D>
Relabelling Incision<D>::stitch(const FacetSet& facets, Verify verify) {
  std::vector<HalfFacetId> scored;
  for (const HalfFacetId h : facets.half_facets()) {
    const auto mate = former_mates_.find(h);
    if (mate != former_mates_.end() ? h < mate->second : shut_.contains(h)) scored.push_back(h);
  }
  Step step{FacetSet::of_lesser(std::move(scored)), false};
  detail::make_room(done_, 1);
  Relabelling change = take_back(step.facets, verify);
  record(std::move(step));
  return change;
}

#define CLEAVE_INSTANTIATE(D)                                                     \
  template std::vector<Merge> Incision<D>::planned_merges(const FacetSet&) const; \
  template Relabelling Incision<D>::take_back(const FacetSet&, Verify);           \
  template Relabelling Incision<D>::stitch(const FacetSet&, Verify);
CLEAVE_FOR_EACH_DIMENSION(CLEAVE_INSTANTIATE)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::topology
