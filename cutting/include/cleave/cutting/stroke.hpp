#pragma once
#include <vector>

#include "cleave/cutting/select.hpp"
#include "cleave/topology/incision.hpp"

namespace cleave::cutting {

/// What a stroke did.
struct StrokeResult {
  std::vector<topology::Relabelling> changes;  // one per step that scored or took back a facet, in order
  topology::FacetSet scored;  // all facets the stroke scored and left scored, opened and shut, named by
                              // the lesser half-facet of the complex as it was before the stroke
};

/// Cuts along `sweep`, step by step, opening each step's facets at once (definition D2): a facet this
/// stroke left shut toggles with each later step that chooses it, an opened one is frozen, so a blade
/// drawn back along its path leaves the cut it made and adds nothing. Nothing is carried from one
/// stroke to the next; facets other strokes left shut stay scored.
/// `points` has one entry per vertex of the incision's complex and is extended for copies.
template <int D>
StrokeResult cut_along(topology::Incision<D>& incision, std::vector<Point<D>>& points,
                       const Sweep<D>& sweep, SelectOptions options = {},
                       topology::Verify verify = topology::Verify::touched);

}  // namespace cleave::cutting
