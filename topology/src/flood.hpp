#pragma once
#include <optional>
#include <unordered_set>
#include <vector>

#include "cleave/topology/ids.hpp"
#include "complex_access.hpp"

namespace cleave::topology::detail {

/// The corner of `cell` at `vertex`, if it has one.
template <int D>
std::optional<CornerId> corner_at(const std::vector<Cell<D>>& cells, CellId cell, VertexId vertex) {
  for (int i = 0; i <= D; ++i)
    if (cells[cell.value][static_cast<std::size_t>(i)] == vertex) return half_facet<D>(cell, i);
  return std::nullopt;
}

/// Algorithm 5 driving step 2 of Algorithm 3: from corner `start` at `vertex` through the mates of
/// the facets that contain the vertex, as far as `enter(corner)` says that a corner is new (and
/// marks it). `part` receives the corners reached, `start` first.
template <int D, class Enter>
void flood(const std::vector<Cell<D>>& cells, const std::vector<HalfFacetId>& mates, CornerId start,
           VertexId vertex, std::vector<CornerId>& part, Enter enter) {
  part.clear();
  part.push_back(start);
  enter(start);
  for (std::size_t next = 0; next < part.size(); ++next) {
    const CellId cell = cell_of<D>(part[next]);
    for (int j = 0; j <= D; ++j) {
      if (j == local_index<D>(part[next])) continue;  // the facet opposite the vertex
      const HalfFacetId mate = mates[half_facet<D>(cell, j).value];
      if (mate.value == kNone) continue;
      const auto across = corner_at<D>(cells, cell_of<D>(mate), vertex);
      if (across && enter(*across)) part.push_back(*across);
    }
  }
}

/// A set of corners that is small as a rule: a star.
class CornerSet {
 public:
  /// Whether `corner` was not in the set; it is afterwards.
  bool insert(CornerId corner) {
    if (large_.empty()) {
      for (const CornerId c : small_)
        if (c == corner) return false;
      small_.push_back(corner);
      if (small_.size() > kSmall) large_.insert(small_.begin(), small_.end());
      return true;
    }
    return large_.insert(corner).second;
  }
  bool contains(CornerId corner) const {
    if (!large_.empty()) return large_.count(corner) != 0;
    for (const CornerId c : small_)
      if (c == corner) return true;
    return false;
  }
  void clear() {
    small_.clear();
    large_.clear();
  }

 private:
  static constexpr std::size_t kSmall = 64;
  std::vector<CornerId> small_;
  std::unordered_set<CornerId> large_;
};

}  // namespace cleave::topology::detail
