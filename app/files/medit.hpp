#pragma once
#include <cstddef>

#include "files/group_integers.hpp"
#include "files/input_text.hpp"
#include "files/text_output.hpp"
#include "mesh.hpp"

namespace cleave::app {

/// Reads a Medit file (text, MeshVersionFormatted 1 to 4, Dimension 2 or 3). Numbers are places,
/// from 1 on, per kind of element. The reference of an element is its group, 0 none; a vertex with
/// a reference becomes an element of dimension 0. Sections that say nothing about the elements
/// (Corners, Ridges, Normals, ...) are skipped; elements that are no simplices of order 1 or 2 are
/// refused. Nodes of second order come in libMeshb's order, by edges (0,1) (1,2) (2,0) (0,3) (1,3)
/// (2,3).
/// The file must end with the keyword End, so that a truncated one is noticed.
Mesh read_medit(const InputText& text);

/// The place in Elements::midside of the i-th node of second order in a file.
constexpr std::size_t medit_midside(std::size_t dimension, std::size_t i) {
  constexpr std::size_t kTriangle[] = {0, 2, 1};
  constexpr std::size_t kTetrahedron[] = {0, 3, 1, 2, 4, 5};
  return dimension == 3 ? kTetrahedron[i] : dimension == 2 ? kTriangle[i] : i;
}

/// Writes a Medit file; returns what its references mean (see GroupIntegers).
GroupIntegers write_medit(TextOutput& out, const Mesh& mesh);

}  // namespace cleave::app
