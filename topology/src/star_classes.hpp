#pragma once
#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "complex_access.hpp"
#include "unglue_scratch.hpp"

namespace cleave::topology::detail {

/// Finds the classes of corners at one vertex after another when facets of the complex have been
/// severed (Algorithm 5 driving step 2 of Algorithm 3), and renames those that get a copy.
///
/// The star of the vertex was one part before, so a walk from its least corner that notes what lies
/// beyond severed facets comes past all classes: first that of the least corner, which keeps the
/// vertex, then the others. A corner that was reached is marked by another vertex in its place, so
/// that one comparison tells where the vertex is in a cell and whether that is new.
template <int D>
class StarClasses {
  using Reached = UnglueScratch::Reached;

 public:
  StarClasses(std::vector<Cell<D>>& cells, const std::vector<HalfFacetId>& mates, Index first_copy,
              UnglueScratch& scratch)
      : cells_(cells.data()), mates_(mates.data()), first_copy_(first_copy), scratch_(scratch) {
    make_room(0);
  }

  /// Gives each class of corners at `vertex` but that of its least corner, `least`, the next
  /// provisional vertex, in the order of their least corners. Throws std::bad_alloc; `roll_back`
  /// is due then.
  void split(VertexId vertex, CornerId least) {
    parent_ = vertex;
    reached_ = candidates_ = 0;
    flood(least, VertexId{kNone});
    const std::size_t kept = reached_, first_new = scratch_.copies.size();
    for (std::size_t n = 0; n < candidates_; ++n)
      if (this->vertex(scratch_.candidates[n]) == vertex) add_copy(scratch_.candidates[n]);
    if (scratch_.copies.size() - first_new > 1) order_copies(first_new);
    for (std::size_t n = 0; n < kept; ++n) this->vertex(scratch_.star[n].corner) = vertex;
    reached_ = 0;
  }

  /// Gives all corners the vertex back that they had. The corners of copies may have been sorted.
  void roll_back() noexcept {
    for (std::size_t n = 0; n < reached_; ++n) vertex(scratch_.star[n].corner) = parent_;
    for (const CornerId corner : scratch_.corners)
      if (const VertexId v = vertex(corner); v >= provisional(0))
        vertex(corner) = scratch_.copies[v.value - first_copy_].parent;
  }

 private:
  VertexId& vertex(CornerId corner) {
    return cells_[cell_of<D>(corner).value][static_cast<std::size_t>(local_index<D>(corner))];
  }

  VertexId provisional(std::size_t copy) const { return {first_copy_ + static_cast<Index>(copy)}; }

  void add_copy(CornerId start) {
    const std::size_t copy = scratch_.copies.size(), from = reached_;
    if (copy >= kNone - first_copy_)
      throw std::length_error("the cut needs more vertices than " + std::to_string(kIdBits) +
                              "-bit ids can number");
    const std::size_t first = scratch_.corners.size();
    CornerId least = flood(start, provisional(copy));
    scratch_.corners.resize(first + reached_ - from);
    for (std::size_t n = from; n < reached_; ++n)
      scratch_.corners[first + n - from] = scratch_.star[n].corner;
    scratch_.copies.push_back({parent_, least, first, scratch_.corners.size()});
  }

  void order_copies(std::size_t first) {
    std::sort(scratch_.copies.begin() + static_cast<std::ptrdiff_t>(first), scratch_.copies.end(),
              [](const auto& a, const auto& b) { return a.least < b.least; });
    for (std::size_t i = first; i < scratch_.copies.size(); ++i)
      for (std::size_t n = scratch_.copies[i].first; n < scratch_.copies[i].last; ++n)
        vertex(scratch_.corners[n]) = provisional(i);
  }

  /// Adds the class of `start` to the star, marks it, and returns its least corner. What the loop
  /// uses are copies, which can stay in registers.
  CornerId flood(CornerId start, const VertexId mark) {
    Cell<D>* const cells = cells_;
    const HalfFacetId* const mates = mates_;
    const VertexId parent = parent_;
    std::size_t next = reached_, reached = reached_, candidates = candidates_;
    if (reached >= room_) make_room(reached);
    Reached* star = scratch_.star.data();
    HalfFacetId* beyond = scratch_.candidates.data();
    vertex(start) = mark;
    star[reached++] = {start, start};
    CornerId least = start;
    for (; next < reached; ++next) {
      if (reached >= room_) {
        reached_ = reached;
        make_room(reached);
        star = scratch_.star.data();
        beyond = scratch_.candidates.data();
      }
      const CornerId corner = star[next].corner;
      const HalfFacetId through = star[next].through;
      least = std::min(least, corner);
      const HalfFacetId first = half_facet<D>(cell_of<D>(corner), 0);
      for (HalfFacetId h = first; h.value <= first.value + D; ++h.value) {
        if (h == corner || h == through) continue;
        const Index entry = mates[h.value].value;
        if (entry == kNone) continue;
        const HalfFacetId across{entry & ~kSevered};
        Cell<D>& cell = cells[cell_of<D>(across).value];
        for (std::size_t i = 0; i <= D; ++i) {
          if (cell[i] != parent) continue;
          const CornerId there = half_facet<D>(cell_of<D>(across), static_cast<int>(i));
          if (entry < kSevered) {
            cell[i] = mark;
            star[reached++] = {there, across};
          } else {
            beyond[candidates++] = there;
          }
          break;
        }
      }
    }
    reached_ = reached;
    candidates_ = candidates;
    return least;
  }

  /// For what a corner can add to those reached, and for candidates beyond each of its facets.
  void make_room(std::size_t reached) {
    constexpr std::size_t kLeast = 256;
    const std::size_t most = std::max(kLeast, 2 * (reached + D + 1));
    if (scratch_.star.size() < most) scratch_.star.resize(most);
    if (scratch_.candidates.size() < D * most) scratch_.candidates.resize(D * most);
    room_ = scratch_.star.size() - D - 1;
  }

  Cell<D>* const cells_;
  const HalfFacetId* const mates_;
  const Index first_copy_;
  UnglueScratch& scratch_;
  VertexId parent_{};  // whose star is under way
  std::size_t reached_ = 0, candidates_ = 0;
  std::size_t room_ = 0;  // corners reached at which more is made
};

}  // namespace cleave::topology::detail
