#pragma once
#include <cstddef>
#include <vector>

#include "cleave/topology/unglue.hpp"
#include "verify_scratch.hpp"

namespace cleave::topology::detail {

/// The memory that a cut works in, kept from one cut to the next so that a series of cuts soon asks
/// the heap for nothing. It holds nothing that a later cut reads.
struct UnglueScratch {
  /// A class of corners that gets a copy of its vertex: corners[first .. last) are in it.
  struct Copy {
    VertexId parent;
    CornerId least;
    std::size_t first, last;
  };
  /// A corner of a star, and the half-facet of its cell through which the walk came; the corner
  /// itself, where the walk began.
  struct Reached {
    CornerId corner;
    HalfFacetId through;
  };

  std::vector<VertexId> vertices;    // of the cut's facets
  std::vector<Reached> star;         // of the vertex under way
  std::vector<CornerId> candidates;  // of that star, beyond severed facets
  std::vector<Copy> copies;
  std::vector<CornerId> corners;  // of all copies
  VerifyScratch verify;
  std::vector<VertexId> spare_vertices;
  std::vector<CornerId> spare_corners;
};

/// unglue, whose new vertices take the ids of `heap` first, in working memory of the caller; what
/// `change` held is overwritten. After an exception `change` holds anything.
template <int D>
void unglue_with_ids(Complex<D>& k, const FacetSet& cut, Verify verify, std::vector<VertexId>& heap,
                     UnglueScratch& scratch, Relabelling& change);

}  // namespace cleave::topology::detail
