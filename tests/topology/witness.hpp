#pragma once
#include <string>

#include "cleave/topology/cell_soup.hpp"
#include "cleave/topology/violation.hpp"

namespace cleave::topology {

/// Re-checks a violation by its witness alone, from the definitions and by brute force. Empty if it
/// stands, else what is wrong with the claim. The witness of NotCutRegular, PinchedSimplex,
/// OrientationConflict, NonOrientable and BadVertexLink is judged on a pseudo-manifold only.
template <int D>
std::string refute(const Violation& violation, const CellSoup<D>& soup);

}  // namespace cleave::topology
