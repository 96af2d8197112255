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

/// A new vertex and the vertex it copies.
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

/// What a change of a complex did: a value, proportional to the change. The only message a cut
/// sends; whoever keeps data on vertices, corners or facets reads it and follows.
struct Relabelling {
  std::size_t vertices_before = 0, vertices_after = 0;  // bounds on vertex ids
  std::vector<RenamedCorner> corners;                   // ascending by corner
  std::vector<Split> splits;                            // ascending by vertex
  std::vector<Merge> merges;                            // ascending by vertex
  std::vector<OpenedFacet> opened;                      // ascending by half_facet
  std::vector<HalfFacetId>
      shut;  // facets asked for that stay interior: the lesser half-facets, ascending

  /// The vertex that `vertex` copies, or `vertex` itself if it is no copy made by this change.
  VertexId parent(VertexId vertex) const;
};

}  // namespace cleave::topology
