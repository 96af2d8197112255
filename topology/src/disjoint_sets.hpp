#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace cleave::topology::detail {

/// Disjoint sets of 0 .. size-1, joined one pair at a time.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size) : parent_(size), count_(size) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }
  void join(Index a, Index b) {
    a = find(a);
    b = find(b);
    if (a == b) return;
    parent_[std::max(a, b)] = std::min(a, b);
    --count_;
  }
  std::size_t count() const { return count_; }

 private:
  Index find(Index a) {
    while (parent_[a] != a) a = parent_[a] = parent_[parent_[a]];
    return a;
  }

  std::vector<Index> parent_;
  std::size_t count_;
};

}  // namespace cleave::topology::detail
