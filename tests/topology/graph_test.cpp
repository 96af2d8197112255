#include <gtest/gtest.h>

#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/connected_components.hpp>
#include <boost/graph/graph_concepts.hpp>
#include <iterator>

#include "cleave/topology/dual_graph.hpp"
#include "cleave/topology/pieces.hpp"
#include "cleave/topology/unglue.hpp"
#include "cleave/topology/vertex_graph.hpp"
#include "view_laws.hpp"

namespace cleave::views {
namespace {

template <class Graph>
struct PassesConceptChecks {
  BOOST_CONCEPT_ASSERT((boost::VertexListGraphConcept<Graph>));
  BOOST_CONCEPT_ASSERT((boost::IncidenceGraphConcept<Graph>));
  BOOST_CONCEPT_ASSERT((boost::AdjacencyGraphConcept<Graph>));
  BOOST_CONCEPT_ASSERT((boost::EdgeListGraphConcept<Graph>));
  using Vertex = typename boost::graph_traits<Graph>::vertex_descriptor;
  BOOST_CONCEPT_ASSERT((boost::ReadablePropertyGraphConcept<Graph, Vertex, boost::vertex_index_t>));
};
template struct PassesConceptChecks<DualGraph<1>>;
template struct PassesConceptChecks<DualGraph<2>>;
template struct PassesConceptChecks<DualGraph<3>>;
template struct PassesConceptChecks<DualGraph<4>>;
template struct PassesConceptChecks<VertexGraph>;

/// The ends of every edge as the graph lists them, each pair ascending, the pairs ascending.
template <class Graph>
auto listed_edges(const Graph& g) {
  using Vertex = typename boost::graph_traits<Graph>::vertex_descriptor;
  std::vector<std::pair<Vertex, Vertex>> all;
  const auto [first, last] = edges(g);
  for (auto e = first; e != last; ++e) all.push_back(std::minmax({source(*e, g), target(*e, g)}));
  std::sort(all.begin(), all.end());
  return all;
}

/// The same, gathered from what leaves each vertex; every edge is seen twice.
template <class Graph>
auto incident_edges(const Graph& g) {
  using Vertex = typename boost::graph_traits<Graph>::vertex_descriptor;
  std::vector<std::pair<Vertex, Vertex>> all;
  const auto [begin, end] = vertices(g);
  for (auto v = begin; v != end; ++v) {
    const auto [first, last] = out_edges(*v, g);
    auto neighbour = adjacent_vertices(*v, g).first;
    EXPECT_EQ(std::distance(first, last), static_cast<std::ptrdiff_t>(out_degree(*v, g)));
    for (auto e = first; e != last; ++e, ++neighbour) {
      EXPECT_EQ(source(*e, g), *v);
      EXPECT_EQ(target(*e, g), *neighbour);
      all.push_back(std::minmax({source(*e, g), target(*e, g)}));
    }
    EXPECT_TRUE(neighbour == adjacent_vertices(*v, g).second);
  }
  std::sort(all.begin(), all.end());
  return all;
}

template <class Edges>
Edges twice(const Edges& edges) {
  Edges doubled;
  for (const auto& edge : edges) doubled.insert(doubled.end(), 2, edge);
  return doubled;
}

/// The component of each vertex, by Boost Graph.
template <class Graph>
std::vector<std::size_t> boost_components(const Graph& g) {
  std::vector<std::size_t> of(num_vertices(g));
  boost::connected_components(
      g, boost::make_iterator_property_map(of.begin(), get(boost::vertex_index, g)));
  return of;
}

/// The distance of each vertex from `start`, by Boost Graph.
template <class Graph, class Vertex>
std::vector<int> boost_distances(const Graph& g, Vertex start) {
  std::vector<int> distance(num_vertices(g), 0);
  const auto map = boost::make_iterator_property_map(distance.begin(), get(boost::vertex_index, g));
  boost::breadth_first_search(
      g, start,
      boost::visitor(boost::make_bfs_visitor(boost::record_distances(map, boost::on_tree_edge{}))));
  return distance;
}

template <class Dimension>
class GraphsOf : public ::testing::Test {};
TYPED_TEST_SUITE(GraphsOf, Dimensions);

TYPED_TEST(GraphsOf, DualEdgesAreInteriorFacets) {
  constexpr int D = TypeParam::value;
  for (const auto& k : sample_complexes<D>()) {
    std::vector<std::pair<CellId, CellId>> expected;
    for (const auto& [facet, half_facets] : support::facets_of<D>(k.cells()))
      if (half_facets.size() == 2)
        expected.emplace_back(cell_of<D>(half_facets[0]), cell_of<D>(half_facets[1]));
    std::sort(expected.begin(), expected.end());
    const DualGraph<D> g(k);
    EXPECT_EQ(num_vertices(g), k.cell_count());
    EXPECT_EQ(num_edges(g), expected.size());
    EXPECT_EQ(listed_edges(g), expected);
    EXPECT_EQ(incident_edges(g), twice(expected));
  }
}

TYPED_TEST(GraphsOf, VertexEdgesAreOneSimplices) {
  constexpr int D = TypeParam::value;
  for (const auto& k : sample_complexes<D>()) {
    std::vector<std::pair<VertexId, VertexId>> expected;
    for (const auto& [edge, star] : simplices_by_definition(k, 2))
      expected.emplace_back(edge[0], edge[1]);
    const VertexGraph g(k);
    EXPECT_EQ(num_vertices(g), k.vertex_count());
    EXPECT_EQ(num_edges(g), expected.size());
    EXPECT_EQ(listed_edges(g), expected);
    EXPECT_EQ(incident_edges(g), twice(expected));
  }
}

TYPED_TEST(GraphsOf, ComponentsOfTheDualGraphArePieces) {
  constexpr int D = TypeParam::value;
  for (const auto& k : sample_complexes<D>()) {
    const Pieces expected = pieces(k);
    const auto found = boost_components(DualGraph<D>(k));
    EXPECT_TRUE(
        std::equal(found.begin(), found.end(), expected.of_cell.begin(), expected.of_cell.end()));
  }
}

TYPED_TEST(GraphsOf, TheDualGraphFollowsACutAndTheVertexGraphDoesNot) {
  constexpr int D = TypeParam::value;
  auto k = complex_of<D>(kuhn_cube<D>(2 + (D == 1)));
  const DualGraph<D> dual(k);
  const VertexGraph before(k);
  unglue(k, FacetSet::all(k));
  EXPECT_EQ(num_edges(dual), 0u);
  EXPECT_NE(num_vertices(before), k.vertex_count());
  const auto components = boost_components(VertexGraph(k));
  EXPECT_EQ(static_cast<std::size_t>(std::set(components.begin(), components.end()).size()),
            k.cell_count());
}

TYPED_TEST(GraphsOf, StepsFromTheLeastVertexOfAGridAreItsGreatestCoordinate) {
  constexpr int D = TypeParam::value;
  const auto grid = kuhn_cube<D>(3);
  const auto distance = boost_distances(VertexGraph(complex_of<D>(grid)), VertexId{0});
  for (Index v = 0; v < grid.vertex_count; ++v) {
    const auto point = grid.point({v});
    EXPECT_EQ(distance[v], *std::max_element(point.begin(), point.end()));
  }
}

TEST(DualGraph, StepsAlongASegmentCountItsCells) {
  const auto k = complex_of<1>(kuhn_cube<1>(6));
  EXPECT_EQ(boost_distances(DualGraph<1>(k), CellId{1}), (std::vector<int>{1, 0, 1, 2, 3}));
}

TEST(DualGraph, AnEdgeIsTheSameFromBothEnds) {
  const auto k = complex_of<2>(kuhn_cube<2>(2));
  const DualGraph<2> g(k);
  const DualEdge there = *out_edges(CellId{0}, g).first, back = *out_edges(CellId{1}, g).first;
  EXPECT_TRUE(there == back);
  EXPECT_EQ(source(there, g), target(back, g));
}

TEST(VertexGraph, AnEdgeIsTheSameFromBothEnds) {
  const VertexEdge there{{0}, {1}}, back{{1}, {0}}, other{{1}, {2}};
  EXPECT_TRUE(there == back);
  EXPECT_FALSE(there == other);
}

}  // namespace
}  // namespace cleave::views
