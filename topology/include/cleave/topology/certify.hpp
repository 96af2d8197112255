#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "cleave/topology/ids.hpp"

namespace cleave::topology {

/// Why `after` is not unglue(before, cut): the first clause of `certify` that fails, and where.
struct Rejection {
  enum class Clause { cells, parent, uncut, connected };
  Clause clause;
  CornerId one{},
      other{};  // the corners that show it; for `uncut` at a vertex of the facet, in its cells
};

std::string_view name(Rejection::Clause clause);  // "cells", "parent", ..
std::string describe(const Rejection& rejection);

/// Nothing iff `after` is unglue(before, cut) up to renaming of vertices. The clauses, in the order
/// in which they are tried:
/// - cells: there are as many cells after as before; cell i after is what cell i before became;
/// - parent: corners that share a vertex after shared one before, so every vertex of `after` comes
///   from one vertex of `before`;
/// - uncut: the two cells of a facet that is not in the cut share its vertices still;
/// - connected: corners that share a vertex after are connected by a chain of cells around it, each
///   next to the one before through a facet of `before` that is not in the cut.
/// That these four hold of unglue(before, cut) and of nothing else is proved: proofs/certify.v,
/// certify_sound_complete. This function was written after that model, and shares no code with
/// unglue: it finds the mates of `before` by sorting facets, and passes labels on where unglue
/// floods.
///
/// All three are plain data: tuples of any numbers, which need not be coherent or cut-regular, and
/// half-facets of `before`, any of each facet (those of boundary facets are allowed and mean
/// nothing). Requires that the cells of `before` are sets of D+1 vertices, no two the same, and no
/// facet of `before` is in three of them. Throws std::length_error if ids do not suffice.
/// Time: linear in the cells, and sorting where a facet's least vertex has many facets or the
/// greatest vertex number exceeds the number of corners. Memory, D = 3: 32 bytes per cell and 4 per
/// vertex; 48 per cell where the last clause is in doubt; 48 more where vertices are renumbered.
template <int D>
std::optional<Rejection> certify(std::span<const Cell<D>> before, std::span<const HalfFacetId> cut,
                                 std::span<const Cell<D>> after);

}  // namespace cleave::topology
