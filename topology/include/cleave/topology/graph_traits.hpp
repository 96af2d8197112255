#pragma once
#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <cstddef>
#include <cstdint>

#include "cleave/topology/id_range.hpp"

namespace cleave::topology {

/// What boost::graph_traits reads of any graph here: undirected, without loops or parallel edges,
/// with vertices that are ids. Its kinds of iterators are added by each graph.
template <class Vertex, class Edge>
struct UndirectedGraphTraits {
  using vertex_descriptor = Vertex;
  using edge_descriptor = Edge;
  using directed_category = boost::undirected_tag;
  using edge_parallel_category = boost::disallow_parallel_edge_tag;
  // NOLINTNEXTLINE(readability-identifier-naming): the name boost::graph_traits asks for
  struct traversal_category : boost::vertex_list_graph_tag,
                              boost::incidence_graph_tag,
                              boost::adjacency_graph_tag,
                              boost::edge_list_graph_tag {};
  using vertex_iterator = IdIterator<Vertex>;
  using vertices_size_type = std::size_t;
  using edges_size_type = std::size_t;
  using degree_size_type = std::size_t;
  static constexpr Vertex null_vertex() { return {kNoIndex}; }
};

/// What boost::property_map reads of the numbers of vertices.
template <class Vertex>
struct VertexIndexMap {
  using type = IdIndexMap<Vertex>;
  using const_type = type;
};

}  // namespace cleave::topology
