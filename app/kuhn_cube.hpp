#pragma once
#include "mesh.hpp"
#include "scene.hpp"

namespace cleave::app {

/// The mesh of a CubeSpec: vertices and cells numbered from 0, x fastest; six tetrahedra per small
/// box, all around its diagonal from the least to the greatest vertex (Kuhn), positively oriented.
/// Throws InputError if there are too many cells for the ids. Time: linear.
Mesh kuhn_cube(const CubeSpec& spec);

}  // namespace cleave::app
