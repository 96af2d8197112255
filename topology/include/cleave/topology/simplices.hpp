#pragma once
#include <boost/iterator/iterator_facade.hpp>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <span>
#include <vector>

#include "cleave/topology/complex.hpp"

namespace cleave::topology {

/// Goes through simplices with the same number of vertices; a random-access iterator, for
/// std::ranges too, that makes its values: spans of their vertices.
class SimplexIterator
    : public boost::iterator_facade<SimplexIterator, std::span<const VertexId>,
                                    boost::random_access_traversal_tag, std::span<const VertexId>> {
 public:
  using iterator_concept = std::random_access_iterator_tag;

  SimplexIterator() = default;
  SimplexIterator(const VertexId* first, std::size_t size) : first_(first), size_(size) {}

  std::span<const VertexId> operator[](std::ptrdiff_t n) const { return *(*this + n); }

 private:
  friend class boost::iterator_core_access;
  std::span<const VertexId> dereference() const { return {first_, size_}; }
  bool equal(const SimplexIterator& other) const { return first_ == other.first_; }
  void increment() { first_ += size_; }
  void decrement() { first_ -= size_; }
  void advance(std::ptrdiff_t n) { first_ += n * static_cast<std::ptrdiff_t>(size_); }
  std::ptrdiff_t distance_to(const SimplexIterator& other) const {
    return (other.first_ - first_) / static_cast<std::ptrdiff_t>(size_);
  }

  const VertexId* first_ = nullptr;
  std::size_t size_ = 1;
};

/// The k-simplices of a complex, 0 <= k <= D, built on demand: every non-empty subset of a cell
/// with k+1 vertices, once. A snapshot: it does not follow later cuts. Simplices are numbered in
/// lexicographic order of their ascending vertices. Spans refer to it and live as long. Models
/// std::ranges::random_access_range: a loop goes through the spans.
template <int D>
class Simplices {
 public:
  /// Time: O(n log n) in the number n of (cell, k-face) pairs; they are kept, for stars. Throws
  /// std::invalid_argument unless 0 <= simplex_dimension <= D, std::length_error if n does not fit
  /// 32 bits.
  Simplices(const Complex<D>& k, int simplex_dimension);

  int dimension() const { return k_; }
  std::size_t count() const { return offsets_.empty() ? 0 : offsets_.size() - 1; }

  /// The k+1 vertices of simplex `i`, ascending.
  std::span<const VertexId> operator[](std::size_t i) const {
    assert(i < count());
    return begin()[static_cast<std::ptrdiff_t>(i)];
  }

  std::size_t size() const { return count(); }
  SimplexIterator begin() const { return {vertices_.data(), vertices_per_simplex()}; }
  SimplexIterator end() const {
    return {vertices_.data() + vertices_.size(), vertices_per_simplex()};
  }

  /// An oriented simplex found: its number, the parity of the tuple asked for relative to ascending
  /// order (+1 even, -1 odd), and a cell that has it.
  struct Found {
    std::size_t index;
    int sign;
    CellId cell;
  };

  /// The simplex with these k+1 vertices in any order; none if the complex has no such simplex.
  /// Time: logarithmic.
  std::optional<Found> find(std::span<const VertexId> tuple) const;
  bool contains(std::span<const VertexId> tuple) const { return find(tuple).has_value(); }

  /// The cells around simplex `i`, ascending.
  std::span<const CellId> star(std::size_t i) const {
    assert(i < count());
    return std::span(cells_).subspan(offsets_[i], offsets_[i + 1] - offsets_[i]);
  }

 private:
  std::size_t vertices_per_simplex() const { return static_cast<std::size_t>(k_) + 1; }

  int k_;
  std::vector<VertexId> vertices_;  // k+1 per simplex
  std::vector<Index> offsets_;      // into cells_, one more than simplices
  std::vector<CellId> cells_;
};

/// A half-facet found by its oriented tuple; sign +1 if the cell induces the orientation of the
/// tuple on it, -1 if it induces the opposite.
struct FoundHalfFacet {
  HalfFacetId half_facet;
  int sign;
};

/// The half-facet with the vertices of `tuple` whose cell induces the tuple's orientation, with
/// sign +1; if only the mate's side exists (boundary), that one with sign -1; none if the complex
/// has no such facet. For D = 1 a tuple has one order, so the sign asked for is explicit; in
/// general `sign` = -1 asks for the reverse of the tuple. Throws std::invalid_argument for another
/// sign. Time: linear in the star of tuple[0].
template <int D>
std::optional<FoundHalfFacet> find_half_facet(const Complex<D>& k, const Facet<D>& tuple,
                                              int sign = 1);

/// The simplices opposite `simplex` in the cells around it: each D-k vertices, ascending, in
/// lexicographic order; for a vertex, the facets of its star opposite it. Empty if it is no simplex
/// of the complex, or a cell. Time: linear in the star of simplex[0], and sorting.
template <int D>
std::vector<std::vector<VertexId>> link(const Complex<D>& k, std::span<const VertexId> simplex);

}  // namespace cleave::topology
