#pragma once
#include <algorithm>

#include "cleave/topology/complex.hpp"

namespace cleave::topology::detail {

/// Calls visit(h) for the interior half-facets of `cell` that contain `vertex`: the steps from the
/// cell within the star of the vertex.
template <int D, class Visit>
void for_each_step(const Complex<D>& k, VertexId vertex, CellId cell, Visit visit) {
  for (int i = 0; i <= D; ++i) {
    const HalfFacetId h = half_facet<D>(cell, i);
    if (k.vertex(h) == vertex) continue;  // corner and half-facet are opposite: h lacks the vertex
    if (k.is_interior(h)) visit(h);
  }
}

/// The name of the facet of `h`, which is interior, in a FacetSet.
template <int D>
HalfFacetId lesser(const Complex<D>& k, HalfFacetId h) {
  return std::min(h, *k.mate(h));
}

}  // namespace cleave::topology::detail
