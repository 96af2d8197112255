#pragma once
#include <string>
#include <vector>

#include "finding.hpp"

namespace cleave::app::test {

/// An SVG of all cells of a small mesh, a little apart from each other, with the numbers of its
/// vertices and cells. What the witnesses of `findings` name is coloured: cells orange, vertices,
/// edges and facets red. `arrows`: with the sense in which each cell (D = 2) lists its vertices. A
/// mesh in a plane z = constant is seen from above, another obliquely. A vertex that has no place
/// is put somewhere, with a question mark. The same arguments give the same bytes.
std::string rule_picture(const Mesh& mesh, const std::vector<Finding>& findings, bool arrows);

}  // namespace cleave::app::test
