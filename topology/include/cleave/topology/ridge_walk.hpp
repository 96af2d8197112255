#pragma once
#include <boost/iterator/iterator_facade.hpp>
#include <cassert>
#include <iterator>

#include "cleave/topology/complex.hpp"
#include "cleave/topology/range.hpp"
#include "cleave/topology/ranges.hpp"

namespace cleave::topology {

/// A cell at a ridge (its edge for D = 3, its vertex for D = 2): the two corners that are not on
/// the ridge, which are also the two half-facets of the cell that contain it.
struct AtRidge {
  HalfFacetId enter, leave;
  friend bool operator==(const AtRidge&, const AtRidge&) = default;
};

/// Goes around a ridge from cell to cell, each entered through the facet `enter` and left through
/// `leave`. A forward iterator.
template <int D>
class RidgeIterator : public boost::iterator_facade<RidgeIterator<D>, AtRidge,
                                                    boost::forward_traversal_tag, AtRidge> {
 public:
  using iterator_concept = std::forward_iterator_tag;

  RidgeIterator() = default;
  RidgeIterator(const Complex<D>& k, AtRidge first) : k_(&k), first_(first), at_(first) {}

  /// The cell after `at`; on the boundary, `at` itself.
  static AtRidge next(const Complex<D>& k, AtRidge at) {
    const HalfFacetId mate = k.mates()[at.leave.value];
    if (!detail::is_mate(mate)) return at;
    const VertexId kept = k.vertex(at.enter);  // on the facet crossed, not on the ridge
    const Cell<D>& cell = k.vertices(cell_of<D>(mate));
    int i = 0;
    while (cell[static_cast<std::size_t>(i)] != kept) ++i;
    return {mate, half_facet<D>(cell_of<D>(mate), i)};
  }

 private:
  friend class boost::iterator_core_access;
  AtRidge dereference() const { return at_; }
  bool equal(const RidgeIterator& other) const {
    return k_ == other.k_ && (k_ == nullptr || at_ == other.at_);
  }
  void increment() {
    const AtRidge after = next(*k_, at_);
    const bool stops = after == at_;
    if (stops || after == first_)
      k_ = nullptr;  // the end
    else
      at_ = after;
  }

  const Complex<D>* k_ = nullptr;
  AtRidge first_, at_;
};

/// The cells around the ridge of one cell opposite both `a` and `b`, two of its corners, in the
/// order in which they lie around it: all the way round from that cell on, left through half-facet
/// `a`; or, where they do not close, from boundary to boundary in that direction. They are the star
/// of the ridge, or the part of it that has this cell if the ridge is pinched. A forward range;
/// nothing is stored. Making it costs a walk in the other direction.
template <int D>
requires(D >= 2) Range<RidgeIterator<D>> around_ridge(const Complex<D>& k, CornerId a, CornerId b) {
  assert(cell_of<D>(a) == cell_of<D>(b) && a != b);
  const AtRidge here{b, a};
  AtRidge back{a, b};  // walking the other way
  for (;;) {
    const AtRidge before = RidgeIterator<D>::next(k, back);
    if (before == back) return {RidgeIterator<D>(k, {back.leave, back.enter}), {}};
    back = before;
    if (back == AtRidge{here.leave, here.enter}) return {RidgeIterator<D>(k, here), {}};
  }
}

}  // namespace cleave::topology
