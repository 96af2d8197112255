#pragma once
#include "files/group_integers.hpp"
#include "files/input_text.hpp"
#include "files/text_output.hpp"
#include "mesh.hpp"

namespace cleave::app {

/// Reads a Medit file (text, MeshVersionFormatted 1 to 4, Dimension 2 or 3). Numbers are places,
/// from 1 on, per kind of element. The reference of an element is its group, 0 none; a vertex with
/// a reference becomes an element of dimension 0. Sections that say nothing about the elements
/// (Corners, Ridges, Normals, ...) are skipped; elements that are no linear simplices are refused.
/// The file must end with the keyword End, so that a truncated one is noticed.
Mesh read_medit(const InputText& text);

/// Writes a Medit file; returns what its references mean (see GroupIntegers).
GroupIntegers write_medit(TextOutput& out, const Mesh& mesh);

}  // namespace cleave::app
