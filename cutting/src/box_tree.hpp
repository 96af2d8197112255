#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "cleave/cutting/predicates.hpp"

namespace cleave::cutting::detail {

template <int D>
Point<D> middle(const Box<D>& box) {
  Point<D> p;
  for (std::size_t i = 0; i < p.size(); ++i) p[i] = 0.5 * box.low[i] + 0.5 * box.high[i];
  return p;
}

/// Makes `box` the least box that holds both.
template <int D>
void include(Box<D>& box, const Box<D>& other) {
  for (std::size_t i = 0; i < box.low.size(); ++i) {
    box.low[i] = std::min(box.low[i], other.low[i]);
    box.high[i] = std::max(box.high[i], other.high[i]);
  }
}

/// Finds the boxes that a simplex may meet. A binary tree over the boxes, halved at the median
/// along the longest side; it keeps the boxes of its nodes only, so elements of size up to kLeaf
/// are reported together. Memory for D = 3: 20 to 40 bytes per box, and 50 more while it is built.
template <int D>
class BoxTree {
 public:
  BoxTree() = default;

  /// Time: O(n log n).
  explicit BoxTree(std::span<const Box<D>> boxes) : items_(boxes.size()) {
    std::iota(items_.begin(), items_.end(), 0u);
    if (!items_.empty()) build(boxes, 0, items_.size());
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
    std::uint32_t first, last, next;
  };

  static bool is_leaf(std::size_t count) { return count <= kLeaf; }

  void build(std::span<const Box<D>> boxes, std::size_t first, std::size_t last) {
    const std::size_t self = nodes_.size();
    Box<D> box = boxes[items_[first]];
    Box<D> middles{middle(box), middle(box)};
    for (std::size_t i = first + 1; i < last; ++i) {
      const Box<D>& item = boxes[items_[i]];
      include(box, item);
      include(middles, {middle(item), middle(item)});
    }
    nodes_.push_back({box, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(last), 0});
    if (!is_leaf(last - first)) {
      const std::size_t half = first + (last - first) / 2;
      const std::size_t axis = longest_side(middles);
      std::nth_element(items_.begin() + static_cast<std::ptrdiff_t>(first),
                       items_.begin() + static_cast<std::ptrdiff_t>(half),
                       items_.begin() + static_cast<std::ptrdiff_t>(last),
                       [&](std::uint32_t a, std::uint32_t b) {
                         return middle(boxes[a])[axis] < middle(boxes[b])[axis];
                       });
      build(boxes, first, half);
      build(boxes, half, last);
    }
    nodes_[self].next = static_cast<std::uint32_t>(nodes_.size());
  }

  static std::size_t longest_side(const Box<D>& box) {
    std::size_t axis = 0;
    for (std::size_t i = 1; i < box.low.size(); ++i)
      if (box.high[i] - box.low[i] > box.high[axis] - box.low[axis]) axis = i;
    return axis;
  }

  std::vector<std::uint32_t> items_;
  std::vector<Node> nodes_;
};

}  // namespace cleave::cutting::detail
