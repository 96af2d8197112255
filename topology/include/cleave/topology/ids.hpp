#pragma once
#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>

/// The numbers everything else speaks of: vertices, cells, half-facets and corners.
namespace cleave::topology {

/// What ids count with: 32 bits, or 64 if the library is built with CLEAVE_ID_BITS=64 (a setting of
/// CMake, which whoever links the library gets too).
#if defined(CLEAVE_ID_BITS) && CLEAVE_ID_BITS == 64
using Index = std::uint64_t;
#else
using Index = std::uint32_t;
#endif

inline constexpr int kIdBits = 8 * static_cast<int>(sizeof(Index));

/// No id has this value: it stands for "none".
inline constexpr Index kNoIndex = static_cast<Index>(-1);

/// An index with a type of its own, so that a cell cannot be taken for a vertex.
template <class Tag>
struct Id {
  Index value = 0;
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
  return {cell.value * static_cast<Index>(D + 1) + static_cast<Index>(i)};
}

/// The cell a half-facet (or corner) belongs to.
template <int D>
constexpr CellId cell_of(HalfFacetId h) {
  return {h.value / static_cast<Index>(D + 1)};
}

/// The local index i in 0..D of a half-facet (or corner).
template <int D>
constexpr int local_index(HalfFacetId h) {
  return static_cast<int>(h.value % static_cast<Index>(D + 1));
}

}  // namespace cleave::topology

template <class Tag>
struct std::hash<cleave::topology::Id<Tag>> {
  std::size_t operator()(cleave::topology::Id<Tag> id) const noexcept {
    return std::hash<cleave::topology::Index>{}(id.value);
  }
};
