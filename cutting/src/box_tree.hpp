#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "cleave/cutting/predicates.hpp"

namespace cleave::cutting::detail {

/// Makes `box` the least box that holds both.
template <int D>
void include(Box<D>& box, const Box<D>& other) {
  for (std::size_t i = 0; i < box.low.size(); ++i) {
    box.low[i] = std::min(box.low[i], other.low[i]);
    box.high[i] = std::max(box.high[i], other.high[i]);
  }
}

/// Finds the boxes that a simplex may meet. A binary tree over the boxes, halved at the median
/// along the longest side; it keeps the boxes of its nodes only, so up to kLeaf boxes are reported
/// together. Memory for D = 3: 20 to 40 bytes per box, and 16 more while it is built.
template <int D>
class BoxTree {
 public:
  BoxTree() = default;

  /// Time: O(n log n).
  explicit BoxTree(std::span<const Box<D>> boxes) {
    std::vector<Item> items(boxes.size());
    for (topology::Index i = 0; i < items.size(); ++i) items[i] = {rough_middle(boxes[i]), i};
    if (!items.empty()) build(boxes, items, 0, items.size());
    items_.reserve(items.size());
    for (const Item& item : items) items_.push_back(item.box);
  }

  /// Calls visit(i) for every box i that `simplex` may meet, and for some of their neighbours.
  template <class Visit>
  void visit_near(const SweptSimplex<D>& simplex, Visit&& visit) const {
    std::size_t at = 0;
    while (at < nodes_.size()) {
      const Node& node = nodes_[at];
      if (!simplex.may_meet(node.box)) {
        at = node.next;
        continue;
      }
      if (is_leaf(node.last - node.first))
        for (std::size_t i = node.first; i < node.last; ++i) visit(items_[i]);
      ++at;
    }
  }

 private:
  static constexpr std::size_t kLeaf = 8;

  /// Nodes stand in the order of a walk from the root, so the one to go on with below `box` is the
  /// next in line, and `next` is the one to go on with beside it.
  struct Node {
    Box<D> box;
    topology::Index first, last, next;
  };

  using Rough = std::array<float, static_cast<std::size_t>(D)>;

  /// A box while the tree is built. Where its middle is needs no precision: it decides the shape of
  /// the tree, not what is in a node.
  struct Item {
    Rough middle;
    topology::Index box;
  };

  static bool is_leaf(std::size_t count) { return count <= kLeaf; }

  static Rough rough_middle(const Box<D>& box) {
    constexpr double kMost = std::numeric_limits<float>::max();
    Rough middle;
    for (std::size_t i = 0; i < middle.size(); ++i)
      middle[i] =
          static_cast<float>(std::clamp(0.5 * box.low[i] + 0.5 * box.high[i], -kMost, kMost));
    return middle;
  }

  /// Appends the nodes over items [first, last), and puts these in order. Returns their box.
  Box<D> build(std::span<const Box<D>> boxes, std::vector<Item>& items, std::size_t first,
               std::size_t last) {
    const std::size_t self = nodes_.size();
    nodes_.emplace_back();
    Box<D> box = boxes[items[first].box];
    if (is_leaf(last - first)) {
      for (std::size_t i = first + 1; i < last; ++i) include(box, boxes[items[i].box]);
    } else {
      const std::size_t half = first + (last - first) / 2;
      const std::span<Item> range = std::span(items).subspan(first, last - first);
      const std::size_t axis = longest_side(range);
      std::nth_element(
          range.begin(), range.begin() + static_cast<std::ptrdiff_t>(half - first), range.end(),
          [axis](const Item& a, const Item& b) { return a.middle[axis] < b.middle[axis]; });
      box = build(boxes, items, first, half);
      include(box, build(boxes, items, half, last));
    }
    nodes_[self] = {box, static_cast<topology::Index>(first), static_cast<topology::Index>(last),
                    static_cast<topology::Index>(nodes_.size())};
    return box;
  }

  /// The axis along which the middles reach farthest.
  static std::size_t longest_side(std::span<const Item> items) {
    Rough low = items.front().middle, high = low;
    for (const Item& item : items)
      for (std::size_t i = 0; i < low.size(); ++i) {
        low[i] = std::min(low[i], item.middle[i]);
        high[i] = std::max(high[i], item.middle[i]);
      }
    std::size_t axis = 0;
    for (std::size_t i = 1; i < low.size(); ++i)
      if (high[i] - low[i] > high[axis] - low[axis]) axis = i;
    return axis;
  }

  std::vector<topology::Index> items_;
  std::vector<Node> nodes_;
};

}  // namespace cleave::cutting::detail
