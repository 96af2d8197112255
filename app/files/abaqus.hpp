#pragma once
#include "files/input_text.hpp"
#include "files/text_output.hpp"
#include "mesh.hpp"

namespace cleave::app {

/// Reads an Abaqus input file: *NODE, *ELEMENT (simplices of first and second order and cohesive
/// elements COH3D6, COH2D4), *NSET, *ELSET and *SURFACE of element faces. Numbers are the file's.
/// A node set is a group of vertices, an element set a group of each dimension it has elements of,
/// a surface a group of facets: those that are no elements of the file become elements, with the
/// side that was named on the minus side. A set and a surface of one name are one group; sets
/// marked internal only serve surfaces. A name of digits gives the group's integer, others are
/// counted. One part and one instance of it at rest are accepted. Keywords that do not concern the
/// mesh are passed over and counted in Mesh::dropped; those that would make or move parts of the
/// mesh unseen (*INCLUDE, *NGEN, ..) are refused. Throws InputError (file and line).
Mesh read_abaqus(const InputText& text);

/// Writes an Abaqus input file: all elements with their numbers (if these are distinct over all
/// dimensions and have at most nine digits, else counted from 1 on), a set per name of groups, and
/// a surface per facet group, on the minus side of its facets. Throws OutputError for a group whose
/// name the format cannot hold.
void write_abaqus(TextOutput& out, const Mesh& mesh);

/// The corners of the sides S1, S2, .. of a cell, in the order that has the cell on the side its
/// normal points to.
inline constexpr int kAbaqusSides[4][4][3] = {
    {}, {}, {{0, 1}, {1, 2}, {2, 0}}, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}};

/// The greatest number of a node or element.
inline constexpr std::uint64_t kAbaqusGreatest = 999999999;

}  // namespace cleave::app
