#pragma once
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "cleave/topology/ids.hpp"

namespace cleave::topology {

namespace detail {
template <int D>
struct ComplexAccess;  // the few functions that build or change a Complex

/// What is kept of a half-facet's mate: the mate; or, with this bit set, the mate that it had until
/// a cut opened the facet; or kNoIndex, which has the bit, too.
inline constexpr Index kSevered = Index{1} << (8 * sizeof(Index) - 1);
constexpr bool is_mate(HalfFacetId entry) { return entry.value < kSevered; }
}  // namespace detail

/// A validated value: a coherently oriented, cut-regular D-pseudo-manifold. Made by `assemble`;
/// changed only by `unglue` and what is built on it, which keep that. Vertices carry no
/// coordinates. Cells and half-facets never change their numbers.
/// Ids given to it must exist: below cell_count(), half_facet_count() or vertex_count(). That is
/// asserted, not checked.
/// Memory for D = 3: 32 bytes per cell, 1 bit for its sign, 4 bytes per vertex.
/// Const members may be called from several threads at once.
template <int D>
class Complex {
  static_assert(D >= 1);

 public:
  static constexpr int dimension = D;

  /// The empty complex.
  Complex() = default;

  std::size_t cell_count() const { return cells_.size(); }
  std::size_t half_facet_count() const { return mates_.size(); }

  /// Vertex ids are below this number. Some may be used by no cell.
  std::size_t vertex_count() const { return a_corner_.size() + a_corner_of_copy_.size(); }

  /// All cells, with their vertices in the order of the file; a temporary complex hands them over.
  std::span<const Cell<D>> cells() const& { return cells_; }
  std::vector<Cell<D>> cells() && { return std::move(cells_); }

  /// The D+1 vertices of `cell`, in the order of the file.
  const Cell<D>& vertices(CellId cell) const {
    assert(cell.value < cells_.size());
    return cells_[cell.value];
  }

  VertexId vertex(CornerId corner) const {
    static_assert(sizeof(Cell<D>) == (D + 1) * sizeof(VertexId));
    assert(corner.value < mates_.size());
    return reinterpret_cast<const VertexId*>(cells_.data())[corner.value];  // without a division
  }

  /// The same facet seen from the other cell; none on the boundary. mate(*mate(h)) == h.
  std::optional<HalfFacetId> mate(HalfFacetId h) const {
    assert(h.value < mates_.size());
    std::optional<HalfFacetId> m(mates_[h.value]);  // so that g++ keeps it in registers
    if (!detail::is_mate(*m)) m.reset();
    return m;
  }

  bool is_interior(HalfFacetId h) const { return mate(h).has_value(); }

  /// The mates of all half-facets, as they lie in memory. A value that is not below
  /// half_facet_count() is no mate: the half-facet is on the boundary.
  std::span<const HalfFacetId> mates() const& { return mates_; }
  std::span<const HalfFacetId> mates() && = delete;  // of a temporary

  /// +1 if the orientation of `cell` is that of its tuple, -1 if it is the reverse.
  int sign(CellId cell) const {
    assert(cell.value < cells_.size());
    return reversed_[cell.value] ? -1 : 1;
  }

  /// The D vertices of half-facet `h` in the order of the cell's tuple.
  Facet<D> facet(HalfFacetId h) const {
    const Cell<D>& cell = vertices(cell_of<D>(h));
    Facet<D> facet{};
    for (std::size_t from = 0, to = 0; from < cell.size(); ++from)
      if (static_cast<int>(from) != local_index<D>(h)) facet[to++] = cell[from];
    return facet;
  }

  /// The orientation that the cell induces on half-facet `h`, relative to the order of facet(h):
  /// sign(cell) * (-1)^i. Mates induce opposite orientations on their common facet.
  int facet_sign(HalfFacetId h) const {
    return local_index<D>(h) % 2 == 0 ? sign(cell_of<D>(h)) : -sign(cell_of<D>(h));
  }

  /// The least corner at `vertex`; none if no cell uses the vertex.
  std::optional<CornerId> a_corner(VertexId vertex) const {
    assert(vertex.value < vertex_count());
    const CornerId corner = vertex.value < a_corner_.size()
                                ? a_corner_[vertex.value]
                                : a_corner_of_copy_[vertex.value - a_corner_.size()];
    if (corner.value == kNone) return std::nullopt;
    return corner;
  }

 private:
  friend struct detail::ComplexAccess<D>;
  static constexpr Index kNone = kNoIndex;

  std::vector<Cell<D>> cells_;
  std::vector<HalfFacetId> mates_;  // see detail::kSevered
  std::vector<bool> reversed_;
  std::vector<CornerId> a_corner_;          // of each vertex that the complex was made with
  std::vector<CornerId> a_corner_of_copy_;  // apart, so that a cut never moves the whole array
};

/// The corners at `vertex`, one per cell of its star, in the order of the flood of Algorithm 5
/// (which reaches the whole star because the complex is cut-regular, T13). Time: linear in the
/// star.
template <int D>
std::vector<CornerId> star(const Complex<D>& k, VertexId vertex);

}  // namespace cleave::topology
