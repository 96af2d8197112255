#pragma once
#include <vector>

#include "finding.hpp"

namespace cleave::app {

/// A cell whose least height is below this part of its longest edge usually counts as flat: what is
/// computed from its shape in double precision has few right digits left.
constexpr double kFlatRatio = 1e-10;

/// What is wrong with the coordinates of `mesh`, each rule by ascending number:
/// not-finite    a vertex has a coordinate that is NaN or infinite;
/// inverted-cell a cell's tuple has negative volume (D = 3), or negative area (D = 2, in a plane
///               z = constant);
/// flat-cell     a cell's volume (area, length) is exactly zero, or its least height is below
///               `flat_ratio` of its longest edge; such a cell is not reported as inverted.
/// Signs are exact on the doubles of the file. Cells that name a vertex twice or have coordinates
/// that are not finite are left to the other rules. Time: linear.
std::vector<Finding> check_geometry(const Mesh& mesh, double flat_ratio = kFlatRatio);

}  // namespace cleave::app
