#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "cleave/topology/unglue.hpp"

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

/// Hands out new ids, ascending: first the least free ones, then those from the bound on.
class NewIds {
 public:
  NewIds(std::vector<VertexId>& heap, Index bound) : heap_(heap), bound_(bound) {}

  void make_room(std::size_t ids) { reused_.reserve(std::min(ids, heap_.size())); }

  /// Requires room for it. Does not throw.
  VertexId next() {
    if (!heap_.empty() && heap_.front().value >= bound_) heap_.clear();
    if (heap_.empty()) return {bound_++};
    std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
    reused_.push_back(heap_.back());
    heap_.pop_back();
    return reused_.back();
  }

  /// All ids are below this number.
  Index bound() const { return bound_; }
  const std::vector<VertexId>& reused() const { return reused_; }

  void give_back() noexcept {
    for (const VertexId id : reused_) set_free(heap_, id);
    reused_.clear();
  }

 private:
  std::vector<VertexId>& heap_;
  Index bound_;
  std::vector<VertexId> reused_;
};

/// unglue, whose new vertices take the ids of `heap` first.
template <int D>
Relabelling unglue_with_ids(Complex<D>& k, const FacetSet& cut, Verify verify,
                            std::vector<VertexId>& heap);

}  // namespace cleave::topology::detail
