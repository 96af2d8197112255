#pragma once
#include <string>

#include "body.hpp"
#include "cleave/topology/incision.hpp"
#include "parts.hpp"
#include "scene.hpp"

namespace cleave::app {

/// What a stroke of a scene did to an incision.
struct SceneStroke {
  topology::Relabelling change;  // all its steps as one
  topology::FacetSet requested;  // of the body at rest
  std::size_t not_interior = 0;  // facets asked for that the body at rest has on its boundary
  std::size_t steps = 0;         // of a blade
};

/// Makes the stroke `spec` in `incision`, which was made from body.complex; every change is
/// verified on what it touched. `points` (rest, one per vertex) is extended for copies. What
/// selects and what cuts is booked in `parts`. Throws InputError for an unknown group, vertex or
/// facet.
SceneStroke make_stroke(const StrokeSpec& spec, const std::string& source, const Body<3>& body,
                        topology::Incision<3>& incision, std::vector<std::array<double, 3>>& points,
                        Parts& parts);

/// Changes made one after the other as one change: a corner renamed several times goes from its
/// first vertex to its last, and copies of copies are copies of the vertex there was before. Vertex
/// ids were below `vertices_before`, which matters if there are no changes. Merges are not
/// composed.
topology::Relabelling composed(const std::vector<topology::Relabelling>& changes,
                               std::size_t vertices_before);

}  // namespace cleave::app
