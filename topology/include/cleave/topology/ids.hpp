#pragma once
#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>

/// The numbers everything else speaks of: vertices, cells, half-facets and corners.
namespace cleave::topology {

/// A 32-bit index with a type of its own, so that a cell cannot be taken for a vertex.
template <class Tag>
struct Id {
  std::uint32_t value = 0;
  friend constexpr auto operator<=>(Id, Id) = default;
};

using VertexId = Id<struct VertexTag>;
using CellId = Id<struct CellTag>;

/// Half-facet h = (D+1)*cell + i is the facet of `cell` opposite its i-th vertex, seen from `cell`.
using HalfFacetId = Id<struct HalfFacetTag>;

/// Corner (cell, i) is the i-th vertex of `cell`. It is the same integer as the half-facet opposite
/// it, and that is used: the facet opposite corner h is half-facet h.
using CornerId = HalfFacetId;

/// A cell as a file or a caller gives it: D+1 vertices; the order carries the orientation.
template <int D>
using Cell = std::array<VertexId, static_cast<std::size_t>(D) + 1>;

/// The D vertices of a facet.
template <int D>
using Facet = std::array<VertexId, static_cast<std::size_t>(D)>;

template <int D>
constexpr HalfFacetId half_facet(CellId cell, int i) {
  return {cell.value * static_cast<std::uint32_t>(D + 1) + static_cast<std::uint32_t>(i)};
}

/// The cell a half-facet (or corner) belongs to.
template <int D>
constexpr CellId cell_of(HalfFacetId h) {
  return {h.value / static_cast<std::uint32_t>(D + 1)};
}

/// The local index i in 0..D of a half-facet (or corner).
template <int D>
constexpr int local_index(HalfFacetId h) {
  return static_cast<int>(h.value % static_cast<std::uint32_t>(D + 1));
}

}  // namespace cleave::topology

template <class Tag>
struct std::hash<cleave::topology::Id<Tag>> {
  std::size_t operator()(cleave::topology::Id<Tag> id) const noexcept {
    return std::hash<std::uint32_t>{}(id.value);
  }
};
