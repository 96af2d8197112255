#pragma once
#include <array>
#include <boost/functional/hash.hpp>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "element_images.hpp"

namespace cleave::app {

/// The nodes of second order after a cut. A node is a function of its edge: cells share it after
/// the cut exactly if they shared it before and the edge has the same two vertices in both. Of the
/// images of an edge, that of the least cell keeps the node; the others get copies, numbered by
/// (original node, least cell). Empty for a mesh of first order.
template <int D>
class NodeImages {
 public:
  /// `images[k]` are those of the elements of dimension k, k < D. `place_of_node` is the place in
  /// the output of each point of the file that is a node in use; copies get the places from
  /// `first_copy` on. Requires that check_edge_nodes finds nothing. Time: linear in the cells that
  /// the cut touched, and sorting them.
  NodeImages(const Renaming<D>& renaming, const std::array<Images, 3>& images,
             std::vector<Index> place_of_node, Index first_copy);

  bool second_order() const { return !place_of_node_.empty(); }

  /// The place in the output of the node that was `node` in the file, on the edge that is between
  /// the places `a` and `b` of the output now.
  Index on_edge(Index node, Index a, Index b) const;

  /// For the element that has these nodes in the file, and these vertices in the output.
  std::vector<Index> of_element(std::span<const Index> nodes,
                                std::span<const Index> vertices) const;

  /// The node on the edge of `cell` between the file places `a` and `b`, in the output.
  Index in_cell(topology::CellId cell, Index a, Index b) const;

  /// All places in the output that `node`, a place in the file, has now; none if it is no node.
  std::vector<Index> places(Index node) const;

  /// The nodes of the file that the copies copy, in the order of their places; ascending.
  const std::vector<Index>& parents() const { return parents_; }

 private:
  const Renaming<D>* renaming_;
  std::vector<Index> place_of_node_;  // kNoPlace: not in use, or no node
  Index first_copy_;
  std::unordered_map<std::pair<Index, Index>, Index, boost::hash<std::pair<Index, Index>>>
      node_on_;  // of the edges that the cut touched, by their ends in ascending order
  std::vector<Index> parents_;
};

/// For each point of the file that is a node of an element with corners in use alone (`in_use` per
/// point of the file): true.
std::vector<bool> nodes_in_use(const Mesh& mesh, const std::vector<bool>& in_use);

}  // namespace cleave::app
