#pragma once
#include <boost/iterator/iterator_facade.hpp>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "cleave/topology/complex.hpp"
#include "cleave/topology/graph_traits.hpp"
#include "cleave/topology/id_range.hpp"

namespace cleave::topology {

/// The graph of vertices and 1-simplices of a complex, for the Boost Graph Library. Undirected,
/// without loops or parallel edges; a vertex that no cell uses has no edge. A snapshot: it does not
/// follow later cuts. Held: 8 bytes per edge, 4 per vertex.
/// Models VertexListGraph, IncidenceGraph, AdjacencyGraph and EdgeListGraph.
class VertexGraph {
 public:
  /// Time: O(n log n) in the number n of (cell, 1-simplex) pairs. Throws std::length_error if the
  /// 1-simplices do not fit numbers of the width of ids.
  template <int D>
  explicit VertexGraph(const Complex<D>& k);

  std::size_t vertex_count() const { return offsets_.size() - 1; }
  std::size_t edge_count() const { return neighbours_.size() / 2; }

  /// The vertices that share a 1-simplex with `vertex`, ascending.
  std::span<const VertexId> neighbours(VertexId vertex) const {
    const Index first = offsets_[vertex.value], last = offsets_[vertex.value + 1];
    return std::span(neighbours_).subspan(first, last - first);
  }

 private:
  std::vector<Index> offsets_;        // into neighbours_, one more than vertices
  std::vector<VertexId> neighbours_;  // twice as many as edges
};

/// A 1-simplex, walked from one of its vertices to the other.
struct VertexEdge {
  VertexId from, to;

  /// The same 1-simplex, whichever way it is walked.
  friend bool operator==(const VertexEdge& a, const VertexEdge& b) {
    return (a.from == b.from && a.to == b.to) || (a.from == b.to && a.to == b.from);
  }
};

/// Goes through the edges at one vertex.
class OutEdgeIterator
    : public boost::iterator_facade<OutEdgeIterator, VertexEdge, boost::random_access_traversal_tag,
                                    VertexEdge> {
 public:
  OutEdgeIterator() = default;
  OutEdgeIterator(VertexId from, const VertexId* to) : from_(from), to_(to) {}

 private:
  friend class boost::iterator_core_access;
  VertexEdge dereference() const { return {from_, *to_}; }
  bool equal(const OutEdgeIterator& other) const { return to_ == other.to_; }
  void increment() { ++to_; }
  void decrement() { --to_; }
  void advance(std::ptrdiff_t n) { to_ += n; }
  std::ptrdiff_t distance_to(const OutEdgeIterator& other) const { return other.to_ - to_; }

  VertexId from_;
  const VertexId* to_ = nullptr;
};

/// Goes through all edges, each once, from its lesser vertex.
class VertexEdgeIterator : public boost::iterator_facade<VertexEdgeIterator, VertexEdge,
                                                         boost::forward_traversal_tag, VertexEdge> {
 public:
  VertexEdgeIterator() = default;
  VertexEdgeIterator(const VertexGraph& g, VertexId from) : g_(&g), from_(from) { skip(); }

 private:
  friend class boost::iterator_core_access;
  VertexEdge dereference() const { return {from_, g_->neighbours(from_)[at_]}; }
  bool equal(const VertexEdgeIterator& other) const {
    return from_ == other.from_ && at_ == other.at_;
  }
  void increment() {
    ++at_;
    skip();
  }
  void skip() {
    for (; from_.value < g_->vertex_count(); ++from_.value, at_ = 0)
      for (const auto to = g_->neighbours(from_); at_ < to.size(); ++at_)
        if (from_ < to[at_]) return;
  }

  const VertexGraph* g_ = nullptr;
  VertexId from_;
  std::size_t at_ = 0;
};

inline VertexId source(const VertexEdge& edge, const VertexGraph&) { return edge.from; }
inline VertexId target(const VertexEdge& edge, const VertexGraph&) { return edge.to; }
inline auto vertices(const VertexGraph& g) { return id_range<VertexId>(g.vertex_count()); }
inline std::size_t num_vertices(const VertexGraph& g) { return g.vertex_count(); }
inline std::size_t num_edges(const VertexGraph& g) { return g.edge_count(); }

inline auto adjacent_vertices(VertexId vertex, const VertexGraph& g) {
  const auto to = g.neighbours(vertex);
  return std::pair(to.data(), to.data() + to.size());
}

inline auto out_edges(VertexId vertex, const VertexGraph& g) {
  const auto [first, last] = adjacent_vertices(vertex, g);
  return std::pair(OutEdgeIterator(vertex, first), OutEdgeIterator(vertex, last));
}

inline std::size_t out_degree(VertexId vertex, const VertexGraph& g) {
  return g.neighbours(vertex).size();
}

inline auto edges(const VertexGraph& g) {
  const VertexId end{static_cast<Index>(g.vertex_count())};
  return std::pair(VertexEdgeIterator(g, {0}), VertexEdgeIterator(g, end));
}

inline IdIndexMap<VertexId> get(boost::vertex_index_t, const VertexGraph&) { return {}; }
inline std::size_t get(boost::vertex_index_t, const VertexGraph&, VertexId vertex) {
  return vertex.value;
}

}  // namespace cleave::topology

template <>
struct boost::graph_traits<cleave::topology::VertexGraph>
    : cleave::topology::UndirectedGraphTraits<cleave::topology::VertexId,
                                              cleave::topology::VertexEdge> {
  using out_edge_iterator = cleave::topology::OutEdgeIterator;
  using edge_iterator = cleave::topology::VertexEdgeIterator;
  using adjacency_iterator = const cleave::topology::VertexId*;
};

template <>
struct boost::property_map<cleave::topology::VertexGraph, boost::vertex_index_t>
    : cleave::topology::VertexIndexMap<cleave::topology::VertexId> {};
