#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "mesh.hpp"

namespace cleave::app {

/// A part of a mesh, and where its points were in the whole.
struct SubMesh {
  Mesh mesh;
  std::vector<Index> place;  // in the whole, of each of mesh.points, ascending
};

/// The part of `mesh` that has these cells, given by ascending places, with their vertices and the
/// vertices `loose` (places in mesh.points, in any order). Elements of lower dimension stay when
/// they are faces of these cells, those of dimension 0 when their vertex stays; groups as far as
/// their elements stay, and not at all without any; periodic pairs and cohesive elements when all
/// their vertices stay. Order, tuples and the file's numbers are kept. Time: linear in the mesh,
/// and sorting the faces of the part.
SubMesh sub_mesh(const Mesh& mesh, std::span<const Index> cells, std::span<const Index> loose = {});

}  // namespace cleave::app
