#pragma once
#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "star_steps.hpp"

namespace cleave::topology::detail {

/// The least number of facets that, closed to passage, keep some cells around a vertex apart from
/// others: a maximum flow in the dual graph of the star, one unit through each facet, by shortest
/// augmenting paths (Edmonds & Karp).
template <int D>
class LeastCut {
 public:
  LeastCut(const Complex<D>& k, VertexId vertex) : k_(k), vertex_(vertex) {}

  /// The lesser half-facets of a smallest set, ascending: of all such sets the one nearest to
  /// `from`. Nothing if it takes more than `limit` facets. Facets for which barred(lesser
  /// half-facet) is true are closed already. `from` and `to` are disjoint.
  template <class Barred>
  std::optional<std::vector<HalfFacetId>> between(std::span<const CellId> from,
                                                  std::span<const CellId> to, std::size_t limit,
                                                  Barred barred) {
    flow_.clear();
    const std::unordered_set<CellId> ends(to.begin(), to.end());
    for (std::size_t units = 0;; ++units) {
      const auto end = search(from, ends, barred);
      if (!end) break;
      if (units == limit) return std::nullopt;
      augment(*end);
    }
    std::vector<HalfFacetId> cut;
    for (const auto& [cell, entered] : entered_by_)
      for_each_step(k_, vertex_, cell, [&](HalfFacetId h) {
        if (entered_by_.contains(cell_of<D>(*k_.mate(h))) || barred(lesser(k_, h))) return;
        cut.push_back(lesser(k_, h));
      });
    std::sort(cut.begin(), cut.end());
    return cut;
  }

 private:
  static constexpr HalfFacetId kStart{kNoIndex};

  /// Breadth first over facets that let one more unit through; returns the first of `ends` reached.
  template <class Barred>
  std::optional<CellId> search(std::span<const CellId> from, const std::unordered_set<CellId>& ends,
                               Barred barred) {
    entered_by_.clear();
    std::vector<CellId> queue(from.begin(), from.end());
    for (const CellId cell : from) entered_by_.emplace(cell, kStart);
    for (std::size_t next = 0; next < queue.size(); ++next) {
      const CellId cell = queue[next];
      if (ends.contains(cell)) return cell;
      for_each_step(k_, vertex_, cell, [&](HalfFacetId h) {
        if (flow_.contains(h) || barred(lesser(k_, h))) return;
        const CellId across = cell_of<D>(*k_.mate(h));
        if (entered_by_.emplace(across, h).second) queue.push_back(across);
      });
    }
    return std::nullopt;
  }

  void augment(CellId end) {
    for (HalfFacetId h = entered_by_.at(end); h != kStart; h = entered_by_.at(cell_of<D>(h)))
      if (flow_.erase(*k_.mate(h)) == 0) flow_.insert(h);  // against a unit: both are saved
  }

  const Complex<D>& k_;
  VertexId vertex_;
  std::unordered_set<HalfFacetId> flow_;                // a unit leaves the cell of each through it
  std::unordered_map<CellId, HalfFacetId> entered_by_;  // cells reached, and through what
};

}  // namespace cleave::topology::detail
