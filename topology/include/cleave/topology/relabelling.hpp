#pragma once
#include <cstddef>
#include <vector>

#include "cleave/topology/ids.hpp"

namespace cleave::topology {

/// A corner that got another vertex.
struct RenamedCorner {
  CornerId corner;
  VertexId from, to;
  friend bool operator==(const RenamedCorner&, const RenamedCorner&) = default;
};

/// A new vertex and the vertex it copies. Its id may be that of a copy that ceased to exist
/// earlier.
struct Split {
  VertexId vertex, parent;
  friend bool operator==(const Split&, const Split&) = default;
};

/// A copy that ceased to exist, and the vertex its corners have now.
struct Merge {
  VertexId vertex, into;
  friend bool operator==(const Merge&, const Merge&) = default;
};

/// A facet that is boundary now: its two half-facets, mates until now, and a vertex of the complex
/// before the change that separates them (T3): the least one.
struct OpenedFacet {
  HalfFacetId half_facet, former_mate;  // half_facet < former_mate
  VertexId by;
  friend bool operator==(const OpenedFacet&, const OpenedFacet&) = default;
};

/// What a change of a complex did: a value, proportional to the change. The only message a cut or a
/// stitch sends; whoever keeps data on vertices, corners or facets reads it and follows. A cut
/// splits and opens, a stitch merges and closes.
struct Relabelling {
  std::size_t vertices_before = 0, vertices_after = 0;  // bounds on vertex ids
  std::vector<RenamedCorner> corners;                   // ascending by corner
  std::vector<Split> splits;                            // ascending by vertex
  std::vector<Merge> merges;                            // ascending by vertex
  std::vector<OpenedFacet> opened;                      // ascending by half_facet
  std::vector<OpenedFacet> closed;  // interior again: as the way back opens them
  std::vector<HalfFacetId>
      shut;  // scored facets that are interior: the lesser half-facets, ascending

  /// Says that nothing changes, in a complex whose vertex ids are below `vertices`. Keeps the
  /// memory.
  void clear(std::size_t vertices = 0);

  /// The vertex that `vertex` copies, or `vertex` itself if it is no copy made by this change.
  VertexId parent(VertexId vertex) const;

  /// The vertex that `vertex`, one of before, is merged into, or `vertex` itself. Time:
  /// logarithmic.
  VertexId merged(VertexId vertex) const;
};

/// The change back: splits become merges, opened facets closed ones, and the other way round. It
/// says nothing of shut facets, since `change` does not know which were scored before.
Relabelling inverse(const Relabelling& change);

}  // namespace cleave::topology
