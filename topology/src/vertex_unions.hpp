#pragma once
#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "cleave/topology/relabelling.hpp"
#include "complex_access.hpp"
#include "hash_bits.hpp"

namespace cleave::topology::detail {

/// Which copies become one, with each other or with the vertex they are copies of: a union-find on
/// those it has been told of, which are numbered 0, 1, .. in that order, and found by a hash table
/// with open addressing, at most half full. The original stays, if it is one of the united; else
/// the copy whose class has the least corner.
class VertexUnions {
 public:
  /// The number of `copy`, new or not; `least()` is the least corner of its class.
  template <class Least>
  Index node(VertexId copy, Least least) {
    Index& slot = slots_[slot_of(copy)];
    if (slot != kNone) return slot;
    const auto made = static_cast<Index>(nodes_.size());
    nodes_.push_back({copy, made, copy, least()});
    slot = made;
    if (2 * nodes_.size() > used_slots()) grow();
    return made;
  }

  void unite(Index a, Index b) {
    a = root(a);
    b = root(b);
    if (nodes_[b].least < nodes_[a].least) std::swap(a, b);
    nodes_[b].towards = a;
  }

  /// The class of the original has the least corner of all.
  void unite_with_original(Index node, VertexId original) {
    Node& top = nodes_[root(node)];
    top.stays = original;
    top.least = CornerId{0};
  }

  /// Fills `merges` with the vertices that cease to exist, ascending.
  void list_merges(std::vector<Merge>& merges) {
    merges.clear();
    for (Index n = 0; n < nodes_.size(); ++n)
      if (const VertexId stays = nodes_[root(n)].stays; stays != nodes_[n].vertex)
        merges.push_back({nodes_[n].vertex, stays});
    const auto by_vertex = [](const Merge& a, const Merge& b) { return a.vertex < b.vertex; };
    if (!std::is_sorted(merges.begin(), merges.end(), by_vertex))
      std::sort(merges.begin(), merges.end(), by_vertex);
  }

  /// Keeps the memory. Time: linear in what it has been told since the last time.
  void clear() {
    std::fill_n(slots_.begin(), used_slots(), kNone);
    bits_ = kLeastBits;
    nodes_.clear();
  }

  void reserve(std::size_t copies) {
    nodes_.reserve(copies);
    std::size_t slots = used_slots();
    while (slots < 2 * copies + 2) slots *= 2;
    if (slots_.size() < slots) slots_.resize(slots, kNone);
  }

 private:
  static constexpr int kLeastBits = 6;

  struct Node {
    VertexId vertex;
    Index towards;   // a node of the same union, nearer to the root
    VertexId stays;  // of a root: the vertex that the united become
    CornerId least;  // of a root: the least corner of the class of `stays`
  };

  Index root(Index node) {
    while (nodes_[node].towards != node)
      node = nodes_[node].towards = nodes_[nodes_[node].towards].towards;
    return node;
  }

  std::size_t used_slots() const { return std::size_t{1} << bits_; }

  std::size_t slot_of(VertexId vertex) const {
    std::size_t slot = hash_bits(vertex.value, bits_);
    while (slots_[slot] != kNone && nodes_[slots_[slot]].vertex != vertex)
      slot = (slot + 1) & (used_slots() - 1);
    return slot;
  }
  void grow() {
    if (slots_.size() < 2 * used_slots()) slots_.resize(2 * used_slots(), kNone);
    std::fill_n(slots_.begin(), used_slots(), kNone);
    ++bits_;
    for (Index n = 0; n < nodes_.size(); ++n) slots_[slot_of(nodes_[n].vertex)] = n;
  }

  int bits_ = kLeastBits;  // of the slots in use; the others are free
  std::vector<Index> slots_ = std::vector<Index>(std::size_t{1} << kLeastBits, kNone);
  std::vector<Node> nodes_;
};

}  // namespace cleave::topology::detail
