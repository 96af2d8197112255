#pragma once
#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "cleave/topology/ids.hpp"

namespace cleave::topology::detail {

/// By which facets the calls of an incision changed its scored set, the latest on top. The facets
/// of all steps stand one after the other, so that a step needs no memory of its own.
class StepStack {
 public:
  struct Step {
    std::span<const HalfFacetId> facets;  // lesser half-facets, ascending
    bool scored;                          // or taken back
  };

  bool empty() const { return steps_.size() == dropped_; }
  std::size_t size() const { return steps_.size() - dropped_; }

  /// Requires that there is one. Valid until the stack changes.
  Step top() const {
    const Entry& entry = steps_.back();
    return {std::span(facets_).subspan(entry.first), entry.scored};
  }

  /// For one more step with that many facets. At least doubles what there is, so that many small
  /// steps cost no more than one large one.
  void make_room(std::size_t facets) {
    grow(facets_, facets);
    grow(steps_, 1);
  }

  /// Requires room. Does not throw.
  void push(Step step) {
    steps_.push_back({facets_.size(), step.scored});
    facets_.insert(facets_.end(), step.facets.begin(), step.facets.end());
  }
  void pop() {
    facets_.resize(steps_.back().first);
    steps_.pop_back();
    if (empty()) clear();
  }

  /// Drops the oldest steps until at most `most` are left. Time: constant per step, and facet,
  /// dropped, amortised.
  void keep_latest(std::size_t most) {
    if (size() <= most) return;
    dropped_ = steps_.size() - most;
    const std::size_t first = empty() ? facets_.size() : steps_[dropped_].first;
    if (2 * first < facets_.size() || 2 * dropped_ < steps_.size()) return;
    facets_.erase(facets_.begin(), facets_.begin() + static_cast<std::ptrdiff_t>(first));
    steps_.erase(steps_.begin(), steps_.begin() + static_cast<std::ptrdiff_t>(dropped_));
    for (Entry& entry : steps_) entry.first -= first;
    dropped_ = 0;
  }

  /// Keeps the memory.
  void clear() {
    facets_.clear();
    steps_.clear();
    dropped_ = 0;
  }

 private:
  struct Entry {
    std::size_t first;  // of its facets
    bool scored;
  };

  template <class T>
  static void grow(std::vector<T>& entries, std::size_t more) {
    const std::size_t needed = entries.size() + more;
    if (entries.capacity() < needed) entries.reserve(std::max(needed, 2 * entries.capacity()));
  }

  std::vector<HalfFacetId> facets_;
  std::vector<Entry> steps_;
  std::size_t dropped_ = 0;  // of steps_, from the first on
};

}  // namespace cleave::topology::detail
