#pragma once
#include <variant>
#include <vector>

#include "cleave/topology/complex.hpp"
#include "cleave/topology/violation.hpp"

namespace cleave::topology {

/// The half-facets without mate, ascending. Time: linear.
template <int D>
std::vector<HalfFacetId> boundary(const Complex<D>& k);

/// The boundary as a complex of its own. Cell c of it is half-facet half_facets[c] of the whole,
/// with the orientation the whole induces; vertex v of it is vertex vertices[v] of the whole.
template <int D>
struct BoundaryComplex {
  Complex<D - 1> complex;
  std::vector<HalfFacetId> half_facets;
  std::vector<VertexId> vertices;
};

/// The boundary of `k` where it is a cut-regular pseudo-manifold, else what keeps it from being one
/// (a boundary that touches itself in a ridge or a vertex); ids of the violations are those that
/// the boundary would have. It is closed: every facet of it is interior (T10). D >= 2. Time:
/// linear.
template <int D>
requires(D >= 2) std::variant<BoundaryComplex<D>, std::vector<Violation>> boundary_complex(
    const Complex<D>& k);

}  // namespace cleave::topology
