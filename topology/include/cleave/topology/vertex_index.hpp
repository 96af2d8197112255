#pragma once
#include <cassert>
#include <cstddef>
#include <span>
#include <vector>

#include "cleave/topology/complex.hpp"

namespace cleave::topology {

/// The corners of all vertices in one array, for who visits many stars: `star` gathers one star at
/// a time, this only looks it up. A snapshot: it knows nothing of later cuts, and does not need the
/// complex once it is made.
/// Time to make it: linear. Memory: an id per corner and one per vertex (D = 3: 16 bytes per cell
/// and 4 per vertex). Const members may be called from several threads at once.
template <int D>
class VertexIndex {
 public:
  /// Of no vertices.
  VertexIndex() = default;
  explicit VertexIndex(const Complex<D>& k);

  std::size_t vertex_count() const { return first_.empty() ? 0 : first_.size() - 2; }

  /// The corners at `vertex`, ascending: those of `star`, in another order. None if no cell uses
  /// it.
  std::span<const CornerId> operator[](VertexId vertex) const {
    assert(vertex.value < vertex_count());
    const Index first = first_[vertex.value], last = first_[vertex.value + 1];
    return {corners_.data() + first, last - first};
  }

 private:
  std::vector<Index> first_;  // of each vertex, in `corners_`; then, twice, their number
  std::vector<CornerId> corners_;
};

}  // namespace cleave::topology
