#pragma once
#include <filesystem>
#include <string>

#include "files/group_integers.hpp"
#include "mesh.hpp"

namespace cleave::app {

enum class VtkFormat { kXml, kLegacy };  // .vtu and .vtk

/// Reads an unstructured grid of vertices, lines, triangles and tetrahedra through VTK; numbers are
/// places, from 0 on. Integer cell data `group` (else `medit:ref`, `gmsh:physical`,
/// `CellEntityIds`) become groups, other numeric data fields. Everything VTK complains about,
/// warnings too, becomes an InputError; nothing is printed.
Mesh read_vtk(const std::filesystem::path& path, VtkFormat format);

/// The bytes of a mesh as VTK file: points as doubles, cell data `group`, fields. Highest dimension
/// first, unless the elements' numbers say how a VTK file had them. `integers` receives what
/// `group` means. Data is binary (base64 in .vtu), without compression. Throws OutputError.
std::string write_vtk(const Mesh& mesh, VtkFormat format, GroupIntegers& integers);

}  // namespace cleave::app
