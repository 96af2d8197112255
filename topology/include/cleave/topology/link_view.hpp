#pragma once
#include <boost/iterator/iterator_facade.hpp>
#include <cstddef>
#include <iterator>
#include <span>

#include "cleave/topology/complex.hpp"
#include "cleave/topology/range.hpp"

namespace cleave::topology {

/// Goes through the facets opposite some corners; a random-access iterator, for std::ranges too,
/// that makes its values.
template <int D>
class OppositeFacetIterator
    : public boost::iterator_facade<OppositeFacetIterator<D>, Facet<D>,
                                    boost::random_access_traversal_tag, Facet<D>> {
 public:
  using iterator_concept = std::random_access_iterator_tag;

  OppositeFacetIterator() = default;
  OppositeFacetIterator(const Complex<D>& k, const CornerId* corner) : k_(&k), corner_(corner) {}

  Facet<D> operator[](std::ptrdiff_t n) const { return k_->facet(corner_[n]); }

 private:
  friend class boost::iterator_core_access;
  Facet<D> dereference() const { return k_->facet(*corner_); }
  bool equal(const OppositeFacetIterator& other) const { return corner_ == other.corner_; }
  void increment() { ++corner_; }
  void decrement() { --corner_; }
  void advance(std::ptrdiff_t n) { corner_ += n; }
  std::ptrdiff_t distance_to(const OppositeFacetIterator& other) const {
    return other.corner_ - corner_;
  }

  const Complex<D>* k_ = nullptr;
  const CornerId* corner_ = nullptr;
};

/// The facet opposite each of `corners`, in the order of the cells' tuples: of the star of a
/// vertex, its link. Nothing is stored; valid as long as `corners`.
///
///     for (const Facet<3>& triangle : link(k, walker.around(v))) ..
template <int D>
Range<OppositeFacetIterator<D>> link(const Complex<D>& k, std::span<const CornerId> corners) {
  return {OppositeFacetIterator<D>(k, corners.data()),
          OppositeFacetIterator<D>(k, corners.data() + corners.size())};
}

}  // namespace cleave::topology
