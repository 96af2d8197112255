#pragma once
#include "files/input_text.hpp"
#include "files/text_output.hpp"
#include "mesh.hpp"

namespace cleave::app {

/// Reads a gmsh file, versions 2.2 (and 2.0, 2.1, which differ only in tags that are not needed)
/// and 4.1, text or binary in either order of bytes. Numbers are the file's tags of nodes and
/// elements, up to 64 bits; groups are the physical groups, with their sign dropped. Prisms in a
/// mesh of tetrahedra and quadrangles in one of triangles are cohesive elements and must have no
/// thickness. What of the file has no place in a Mesh is said in Mesh::dropped.
Mesh read_msh(const InputText& text);

struct MshForm {
  MshVersion version;
  bool binary;  // in the machine's order of bytes
};

/// Writes a gmsh file. Numbers are kept if they are distinct and positive (the elements' over all
/// dimensions together) and fit (binary 2.2 has 32 bits), else everything is numbered from 1 on.
/// Version 2.2 repeats an element that is in several groups, as gmsh does. Throws OutputError for a
/// group or field whose name the format cannot hold.
void write_msh(TextOutput& out, const Mesh& mesh, const MshForm& form);

}  // namespace cleave::app
