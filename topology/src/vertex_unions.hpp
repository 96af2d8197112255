#pragma once
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "complex_access.hpp"
#include "hash_bits.hpp"

namespace cleave::topology::detail {

/// Which vertices become one: a union-find on those it has been told of, which are numbered 0, 1,
/// .. in that order, and found by a hash table with open addressing, at most half full. Of united
/// vertices the one whose class has the least corner stays.
class VertexUnions {
 public:
  struct Node {
    VertexId vertex;
    CornerId least;  // of the vertex' class
    Index towards;   // a node of the same union, nearer to the one that stays
  };

  /// The number of `vertex`, new or not; `least` is the least corner of its class.
  Index node(VertexId vertex, CornerId least) {
    Index& slot = slots_[slot_of(vertex)];
    if (slot != kNone) return slot;
    const auto made = static_cast<Index>(nodes_.size());
    nodes_.push_back({vertex, least, made});
    slot = made;
    if (2 * nodes_.size() > slots_.size()) grow();
    return made;
  }

  void unite(Index a, Index b) {
    a = root(a);
    b = root(b);
    if (nodes_[b].least < nodes_[a].least) std::swap(a, b);
    nodes_[b].towards = a;
  }

  /// The vertex that stays of those united with this one.
  VertexId stays(Index node) { return nodes_[root(node)].vertex; }

  const std::vector<Node>& nodes() const { return nodes_; }

 private:
  Index root(Index node) {
    while (nodes_[node].towards != node)
      node = nodes_[node].towards = nodes_[nodes_[node].towards].towards;
    return node;
  }

  std::size_t slot_of(VertexId vertex) const {
    std::size_t slot = hash_bits(vertex.value, bits_);
    while (slots_[slot] != kNone && nodes_[slots_[slot]].vertex != vertex)
      slot = (slot + 1) & (slots_.size() - 1);
    return slot;
  }
  void grow() {
    slots_.assign(2 * slots_.size(), kNone);
    ++bits_;
    for (Index n = 0; n < nodes_.size(); ++n) slots_[slot_of(nodes_[n].vertex)] = n;
  }

  int bits_ = 6;
  std::vector<Index> slots_ = std::vector<Index>(std::size_t{1} << bits_, kNone);
  std::vector<Node> nodes_;
};

}  // namespace cleave::topology::detail
