#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "finding.hpp"
#include "mesh.hpp"

/// Nodes of second order: each sits on an edge, and is a function of it.
namespace cleave::app {

/// How many edges a simplex of this dimension has, and where the edge between its local vertices
/// i < j is among them, as Elements::midside orders them.
constexpr std::size_t edges_of_simplex(std::size_t dimension) {
  return dimension * (dimension + 1) / 2;
}
constexpr std::size_t edge_index(std::size_t dimension, std::size_t i, std::size_t j) {
  return i * (2 * dimension + 1 - i) / 2 + (j - i - 1);
}

/// Stands in Elements::midside for a node that is missing.
constexpr Index kNoNode = topology::kNoIndex;

/// For each of mesh.points: whether it is a node of second order, and no corner of an element.
std::vector<bool> edge_nodes(const Mesh& mesh);

/// What keeps the nodes of `mesh` from being a function of its edges, each an error of the rule
/// `bad-edge-node`: elements with and elements without nodes, a node that is missing, a node that
/// is also a corner, a node on two edges, an edge with two nodes. None for a mesh of first order.
/// Time: linear, and sorting the edges.
std::vector<Finding> check_edge_nodes(const Mesh& mesh);

}  // namespace cleave::app
