#pragma once
#include <algorithm>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "cleave/topology/ids.hpp"

/// Ids of copies that ceased to exist, to be used again: a heap, least id first, without
/// repetitions. Those below the bound on ids are exactly the unused ids of copies; those above it
/// were dropped with the end of the range. Ids are added at the end only when no other is free, so
/// an id never gets into the heap twice.
namespace cleave::topology::detail {

/// Requires room for one more. Does not throw.
inline void set_free(std::vector<VertexId>& heap, VertexId id) {
  heap.push_back(id);
  std::push_heap(heap.begin(), heap.end(), std::greater<>());
}

/// Hands out new ids, ascending: first the least free ones, then those from the bound on. What was
/// handed out stays behind the heap until `keep`, so that it can be given back without memory.
class NewIds {
 public:
  NewIds(std::vector<VertexId>& heap, Index bound)
      : heap_(heap), bound_(bound), free_(heap.size()), reused_(heap.size()) {}

  /// Does not throw.
  VertexId next() {
    if (free_ != 0 && heap_.front().value >= bound_) free_ = 0;  // none of them is an id
    if (free_ == 0) return {bound_++};
    std::pop_heap(heap_.begin(), at(free_), std::greater<>());
    reused_ = --free_;
    return heap_[reused_];
  }

  /// All ids are below this number.
  Index bound() const { return bound_; }
  std::span<const VertexId> reused() const { return std::span(heap_).subspan(reused_); }

  /// What was handed out is in use.
  void keep() noexcept { heap_.resize(free_); }

  void give_back() noexcept {
    if (free_ < reused_) heap_.erase(heap_.begin(), at(reused_));
    std::make_heap(heap_.begin(), heap_.end(), std::greater<>());
    free_ = reused_ = heap_.size();
  }

 private:
  std::vector<VertexId>::iterator at(std::size_t n) {
    return heap_.begin() + static_cast<std::ptrdiff_t>(n);
  }

  std::vector<VertexId>& heap_;
  Index bound_;
  std::size_t free_;    // the first of heap_, which are a heap
  std::size_t reused_;  // from here on
};

}  // namespace cleave::topology::detail
