#pragma once
#include <vector>

#include "cleave/cutting/select.hpp"
#include "cleave/topology/incision.hpp"

namespace cleave::cutting {

/// What a stroke did. Facets are named by the lesser half-facet of the complex as it was before.
struct StrokeResult {
  /// One per step that changed the choice of a facet, in order. Their `shut` lists all facets of
  /// the incision that are shut, those of earlier strokes among them.
  std::vector<topology::Relabelling> changes;

  /// The facets that the stroke scored and did not take back, opened and shut; also those among
  /// them that an earlier stroke had scored already.
  topology::FacetSet scored;

  /// Those of `except` that some step chose, or chose no longer; the stroke left them alone.
  topology::FacetSet excepted;
};

/// Cuts along `sweep`, step by step, opening at once what can be opened. What is open is frozen; a
/// facet that this stroke scored and that is shut is taken back when a later step no longer chooses
/// it (dual_edge: chooses it again, so that crossings count in pairs). So a blade that met no facet
/// twice and is drawn back along its path leaves the cut it made and adds nothing. Nothing is
/// carried from one stroke to the next; facets that other strokes left shut stay scored. Facets of
/// `except` are left as they are, whichever step chooses them.
///
/// `points` has one entry per vertex of the incision's complex, in rest coordinates, and is
/// extended for copies. Throws std::invalid_argument for bad points or a bad sweep, as Selector and
/// require_valid do, and then nothing has changed; else as Incision::cut, and then some steps are
/// done, and `points` fit the complex as it is. Time: that of a Selector, plus per step that of
/// `toggle` and of the cut.
template <int D>
StrokeResult cut_along(topology::Incision<D>& incision, std::vector<Point<D>>& points,
                       const Sweep<D>& sweep, SelectOptions options = {},
                       topology::Verify verify = topology::Verify::touched,
                       const topology::FacetSet& except = {});

}  // namespace cleave::cutting
