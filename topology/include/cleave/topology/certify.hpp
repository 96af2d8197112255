#pragma once
#include <optional>
#include <span>
#include <string>

#include "cleave/topology/ids.hpp"

namespace cleave::topology {

/// Why `after` is not unglue(before, cut): the clause that fails and where.
struct Rejection {
  enum class Clause {
    not_comparable,      // (a) different numbers of cells
    no_parent,           // (a) two corners share a vertex after the cut that differ before it
    uncut_mates_apart,   // (b) an uncut facet has lost a vertex
    class_not_connected  // (c) corners share a vertex that no chain of uncut facets connects
  };
  Clause clause;
  CornerId one{},
      other{};  // the corners that show it; for (b) at a vertex of the facet, in its cells
};

std::string describe(const Rejection& rejection);

/// Nothing iff `after` is unglue(before, cut) up to renaming of vertices: (a) same number of cells,
/// and every vertex of `after` comes, position by position, from one vertex of `before`; (b) uncut
/// mates keep their vertices; (c) the corners of each vertex of `after` are connected through uncut
/// facets of `before` that contain its parent. Both arguments are plain tuples, `cut` names facets
/// by any of their half-facets (half-facets of boundary facets are allowed and mean nothing).
/// Shares no code with unglue: it finds the mates of `before` by sorting facets. Requires that no
/// facet of `before` is in three cells. Time: O(n log n) in the cells.
template <int D>
std::optional<Rejection> certify(std::span<const Cell<D>> before, std::span<const HalfFacetId> cut,
                                 std::span<const Cell<D>> after);

}  // namespace cleave::topology
