#pragma once
#include <boost/graph/adjacency_iterator.hpp>
#include <boost/iterator/iterator_facade.hpp>
#include <cstddef>
#include <utility>

#include "cleave/topology/complex.hpp"
#include "cleave/topology/graph_traits.hpp"
#include "cleave/topology/id_range.hpp"

namespace cleave::topology {

/// The dual graph of a complex, for the Boost Graph Library: vertices are its cells, edges its
/// interior facets. Undirected, without loops or parallel edges. A view of one pointer: it follows
/// every change of the complex, which must outlive it and stay where it is.
/// Models VertexListGraph, IncidenceGraph, AdjacencyGraph and EdgeListGraph.
template <int D>
class DualGraph {
 public:
  explicit DualGraph(const Complex<D>& k) : k_(&k) {}
  explicit DualGraph(Complex<D>&&) = delete;  // a view of a temporary

  const Complex<D>& complex() const { return *k_; }

 private:
  const Complex<D>* k_;
};

/// An interior facet, crossed from one of its cells into the other.
struct DualEdge {
  HalfFacetId from, to;  // mates

  /// The same facet, whichever way it is crossed.
  friend bool operator==(const DualEdge& a, const DualEdge& b) {
    return a.from == b.from || a.from == b.to;
  }
};

/// Goes through the interior ones of the half-facets first .. last-1; the lesser of two mates only
/// if `each_facet_once`.
template <int D>
class DualEdgeIterator : public boost::iterator_facade<DualEdgeIterator<D>, DualEdge,
                                                       boost::forward_traversal_tag, DualEdge> {
 public:
  DualEdgeIterator() = default;
  DualEdgeIterator(const Complex<D>& k, Index first, Index last, bool each_facet_once)
      : k_(&k), h_{first}, last_(last), each_facet_once_(each_facet_once) {
    skip();
  }

 private:
  friend class boost::iterator_core_access;
  DualEdge dereference() const { return {h_, *k_->mate(h_)}; }
  bool equal(const DualEdgeIterator& other) const { return h_ == other.h_; }
  void increment() {
    ++h_.value;
    skip();
  }
  void skip() {
    while (h_.value < last_ && !stops_here()) ++h_.value;
  }
  bool stops_here() const {
    const auto mate = k_->mate(h_);
    return mate && (!each_facet_once_ || h_ < *mate);
  }

  const Complex<D>* k_ = nullptr;
  HalfFacetId h_;
  Index last_ = 0;
  bool each_facet_once_ = false;
};

/// What boost::graph_traits reads.
template <int D>
struct DualGraphTraits : UndirectedGraphTraits<CellId, DualEdge> {
  using out_edge_iterator = DualEdgeIterator<D>;
  using edge_iterator = DualEdgeIterator<D>;
  using adjacency_iterator =
      typename boost::adjacency_iterator_generator<DualGraph<D>, CellId, out_edge_iterator>::type;
};

template <int D>
CellId source(const DualEdge& edge, const DualGraph<D>&) {
  return cell_of<D>(edge.from);
}

template <int D>
CellId target(const DualEdge& edge, const DualGraph<D>&) {
  return cell_of<D>(edge.to);
}

template <int D>
auto vertices(const DualGraph<D>& g) {
  return id_range<CellId>(g.complex().cell_count());
}

template <int D>
std::size_t num_vertices(const DualGraph<D>& g) {
  return g.complex().cell_count();
}

/// The interior facets of `cell`, crossed out of it.
template <int D>
auto out_edges(CellId cell, const DualGraph<D>& g) {
  const Index first = half_facet<D>(cell, 0).value, last = first + D + 1;
  return std::pair(DualEdgeIterator<D>(g.complex(), first, last, false),
                   DualEdgeIterator<D>(g.complex(), last, last, false));
}

template <int D>
std::size_t out_degree(CellId cell, const DualGraph<D>& g) {
  const auto [first, last] = out_edges(cell, g);
  return static_cast<std::size_t>(std::distance(first, last));
}

template <int D>
auto adjacent_vertices(CellId cell, const DualGraph<D>& g) {
  using Iterator = typename DualGraphTraits<D>::adjacency_iterator;
  const auto [first, last] = out_edges(cell, g);
  return std::pair(Iterator(first, &g), Iterator(last, &g));
}

/// Every interior facet once, from its lesser half-facet.
template <int D>
auto edges(const DualGraph<D>& g) {
  const auto last = static_cast<Index>(g.complex().half_facet_count());
  return std::pair(DualEdgeIterator<D>(g.complex(), 0, last, true),
                   DualEdgeIterator<D>(g.complex(), last, last, true));
}

/// The number of interior facets. Time: linear.
template <int D>
std::size_t num_edges(const DualGraph<D>& g) {
  const auto [first, last] = edges(g);
  return static_cast<std::size_t>(std::distance(first, last));
}

template <int D>
IdIndexMap<CellId> get(boost::vertex_index_t, const DualGraph<D>&) {
  return {};
}

template <int D>
std::size_t get(boost::vertex_index_t, const DualGraph<D>&, CellId cell) {
  return cell.value;
}

}  // namespace cleave::topology

template <int D>
struct boost::graph_traits<cleave::topology::DualGraph<D>> : cleave::topology::DualGraphTraits<D> {
};

template <int D>
struct boost::property_map<cleave::topology::DualGraph<D>, boost::vertex_index_t>
    : cleave::topology::VertexIndexMap<cleave::topology::CellId> {};
