#pragma once
#include <boost/iterator/iterator_facade.hpp>
#include <cstddef>
#include <iterator>
#include <span>

#include "cleave/topology/complex.hpp"
#include "cleave/topology/id_range.hpp"
#include "cleave/topology/range.hpp"

/// What a complex has, as ranges: nothing is stored, each value is made when it is asked for, in
/// ascending order, and a loop costs what one over the plain arrays costs
/// (tests/bench/range_bench.cpp). They show the complex as it is, after a cut too, which may move
/// what iterators point to. So they are made anew after a change, and the complex must outlive
/// them.
namespace cleave::topology {

/// Models std::ranges::random_access_range, as do all ranges below that leave nothing out.
template <class AnId>
using IdRange = Range<IdIterator<AnId>>;

template <class AnId>
IdRange<AnId> ids(Index first, Index last) {
  return {IdIterator<AnId>({first}), IdIterator<AnId>({last})};
}

template <int D>
IdRange<CellId> cells(const Complex<D>& k) {
  return ids<CellId>(0, static_cast<Index>(k.cell_count()));
}

/// All ids below vertex_count(); some may be used by no cell.
template <int D>
IdRange<VertexId> vertices(const Complex<D>& k) {
  return ids<VertexId>(0, static_cast<Index>(k.vertex_count()));
}

template <int D>
IdRange<HalfFacetId> half_facets(const Complex<D>& k) {
  return ids<HalfFacetId>(0, static_cast<Index>(k.half_facet_count()));
}

template <int D>
IdRange<HalfFacetId> half_facets(const Complex<D>&, CellId cell) {
  return ids<HalfFacetId>(half_facet<D>(cell, 0).value, half_facet<D>(cell, D + 1).value);
}

/// Corners are the half-facets opposite them, by other names.
template <int D>
IdRange<CornerId> corners(const Complex<D>& k) {
  return half_facets(k);
}

template <int D>
IdRange<CornerId> corners(const Complex<D>& k, CellId cell) {
  return half_facets(k, cell);
}

/// Whether an entry of Complex::mates is no mate.
constexpr bool is_boundary(HalfFacetId entry) { return !detail::is_mate(entry); }

/// The D+1 half-facets across those of `cell`, as Complex::mates has them: ask is_boundary of each.
template <int D>
std::span<const HalfFacetId, D + 1> mates(const Complex<D>& k, CellId cell) {
  return k.mates().subspan(half_facet<D>(cell, 0).value).template first<D + 1>();
}

/// Goes through the neighbours of a cell: the cells of mates, but for those on the boundary.
template <int D>
class NeighbourIterator : public boost::iterator_facade<NeighbourIterator<D>, CellId,
                                                        boost::forward_traversal_tag, CellId> {
 public:
  using iterator_concept = std::forward_iterator_tag;

  NeighbourIterator() = default;
  NeighbourIterator(const HalfFacetId* mate, const HalfFacetId* last) : mate_(mate), last_(last) {
    skip();
  }

 private:
  friend class boost::iterator_core_access;
  CellId dereference() const { return cell_of<D>(*mate_); }
  bool equal(const NeighbourIterator& other) const { return mate_ == other.mate_; }
  void increment() {
    ++mate_;
    skip();
  }
  void skip() {
    while (mate_ != last_ && !detail::is_mate(*mate_)) ++mate_;
  }

  const HalfFacetId* mate_ = nullptr;
  const HalfFacetId* last_ = nullptr;
};

/// The cells that share a facet with `cell`, in the order of its half-facets. A forward range.
/// Leaving out the boundary costs half a nanosecond a cell over asking each of mates(k, cell).
template <int D>
Range<NeighbourIterator<D>> neighbours(const Complex<D>& k, CellId cell) {
  const auto across = mates(k, cell);
  const HalfFacetId* last = across.data() + across.size();
  return {NeighbourIterator<D>(across.data(), last), NeighbourIterator<D>(last, last)};
}

/// Which half-facets a range keeps, by their entry in Complex::mates; that of those on the boundary
/// is greater than any half-facet.
namespace keeping {
struct Boundary {
  static bool keeps(HalfFacetId, HalfFacetId mate) { return !detail::is_mate(mate); }
};
struct Interior {
  static bool keeps(HalfFacetId h, HalfFacetId mate) { return h < mate && detail::is_mate(mate); }
};
struct Lesser {
  static bool keeps(HalfFacetId h, HalfFacetId mate) { return h < mate; }
};
}  // namespace keeping

/// Goes through the half-facets that a rule keeps.
template <class Rule>
class KeptIterator : public boost::iterator_facade<KeptIterator<Rule>, HalfFacetId,
                                                   boost::forward_traversal_tag, HalfFacetId> {
 public:
  using iterator_concept = std::forward_iterator_tag;

  KeptIterator() = default;
  KeptIterator(std::span<const HalfFacetId> mates, std::size_t at)
      : mates_(mates.data()), at_(at), last_(mates.size()) {
    skip();
  }

 private:
  friend class boost::iterator_core_access;
  HalfFacetId dereference() const { return {static_cast<Index>(at_)}; }
  bool equal(const KeptIterator& other) const { return at_ == other.at_; }
  void increment() {
    ++at_;
    skip();
  }
  void skip() {
    while (at_ != last_ && !Rule::keeps(dereference(), mates_[at_])) ++at_;
  }

  const HalfFacetId* mates_ = nullptr;
  std::size_t at_ = 0, last_ = 0;
};

template <class Rule, int D>
Range<KeptIterator<Rule>> kept(const Complex<D>& k) {
  return {KeptIterator<Rule>(k.mates(), 0), KeptIterator<Rule>(k.mates(), k.mates().size())};
}

/// The half-facets without mate: what boundary(k) lists. A forward range.
template <int D>
Range<KeptIterator<keeping::Boundary>> boundary_facets(const Complex<D>& k) {
  return kept<keeping::Boundary>(k);
}

/// Every interior facet once, by its lesser half-facet: what FacetSet::all(k) lists. A forward
/// range.
template <int D>
Range<KeptIterator<keeping::Interior>> interior_facets(const Complex<D>& k) {
  return kept<keeping::Interior>(k);
}

/// Every facet once, by its lesser half-facet. A forward range.
template <int D>
Range<KeptIterator<keeping::Lesser>> facets(const Complex<D>& k) {
  return kept<keeping::Lesser>(k);
}

}  // namespace cleave::topology
