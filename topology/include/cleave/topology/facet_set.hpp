#pragma once
#include <cstddef>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "cleave/topology/complex.hpp"

namespace cleave::topology {

/// A half-facet was asked for that has no mate.
class NotInterior : public std::invalid_argument {
 public:
  explicit NotInterior(HalfFacetId h);
  HalfFacetId half_facet;
};

/// Interior facets chosen from a complex: a set, without guarantees on its shape. Each facet is
/// named by the lesser of its two half-facets, so order and repetition do not matter.
class FacetSet {
 public:
  FacetSet() = default;

  /// The facets of these half-facets. Throws NotInterior for one without mate.
  template <int D>
  static FacetSet of(const Complex<D>& k, std::span<const HalfFacetId> half_facets);

  /// Every interior facet of `k`.
  template <int D>
  static FacetSet all(const Complex<D>& k);

  /// The lesser half-facet of each facet, ascending; a temporary set hands them over.
  std::span<const HalfFacetId> half_facets() const& { return facets_; }
  std::vector<HalfFacetId> half_facets() && { return std::move(facets_); }
  std::size_t size() const { return facets_.size(); }
  bool empty() const { return facets_.empty(); }

  /// Whether the facet whose lesser half-facet is `h` is in the set. Time: logarithmic.
  bool contains(HalfFacetId h) const;

  friend FacetSet operator|(const FacetSet& a, const FacetSet& b);  // union
  friend FacetSet operator-(const FacetSet& a, const FacetSet& b);  // difference
  friend FacetSet operator&(const FacetSet& a, const FacetSet& b);  // intersection
  friend FacetSet operator^(const FacetSet& a, const FacetSet& b);  // symmetric difference
  friend bool operator==(const FacetSet&, const FacetSet&) = default;

  /// From lesser half-facets already known as such. Sorts and removes repetitions.
  static FacetSet of_lesser(std::vector<HalfFacetId> lesser);

 private:
  std::vector<HalfFacetId> facets_;
};

}  // namespace cleave::topology
