#pragma once
#include "cut_output.hpp"

namespace cleave::app {

/// Fills output.mesh.periodic: the pairs of body.mesh as they are after the cut that made `output`,
/// whose points and cells are there already.
/// A periodicity of entities of dimension D-1 identifies boundary facets: the facet whose vertices
/// are v, .. with the one whose vertices are their masters, if both are on the boundary of the
/// file's cells. Such facets map the corners (and nodes of second order) of one cell to those of
/// the other, and so copies to copies. The pairs of the output are these. Periodicities of lower
/// dimension follow: a copy of v and a copy of its master are a pair if facets identify them,
/// directly or by way of others. A copy that is on no identified facet is in no pair, which is
/// warned about.
/// Throws InputError if the copies do not correspond one to one, as when one side is cut where the
/// other is not: the message names the vertices and the fewest facets that mend that vertex.
/// Time: linear in the cells for each periodicity, and sorting its facets.
template <int D>
void carry_periodic(const Body<D>& body, const topology::Incision<D>& incision, CutOutput& output);

}  // namespace cleave::app
