#pragma once
#include <filesystem>
#include <string>

#include "files/group_integers.hpp"
#include "mesh.hpp"
#include "mesh_file.hpp"

namespace cleave::app {

enum class VtkFormat { kXml, kLegacy };  // .vtu and .vtk

/// Reads an unstructured grid of vertices, lines, triangles and tetrahedra of first or second order
/// through VTK; numbers are places, from 0 on. Quadrangles in a mesh of triangles and wedges in one
/// of tetrahedra are cohesive elements and must have no thickness. Integer cell data `group` (else
/// `medit:ref`, `gmsh:physical`, `CellEntityIds`) become groups; other numeric data become fields
/// of points, of cells, and of facets where these have values that are not NaN (-1 for integers).
/// Everything VTK complains about, warnings too, becomes an InputError; nothing is printed.
Mesh read_vtk(const std::filesystem::path& path, VtkFormat format);

/// The bytes of a mesh as VTK file: points as doubles, cell data `group`, fields (a field of cells
/// and one of facets with the same name and components are one array; entries without a value are
/// NaN, or -1 in an array of integers). Highest dimension first, cohesive elements last, unless the
/// elements' numbers say how a VTK file had them. `integers` receives what `group` means. Throws
/// OutputError, also for values that are not finite in the text form of .vtk.
std::string write_vtu(const Mesh& mesh, VtuEncoding encoding, GroupIntegers& integers);
std::string write_vtk(const Mesh& mesh, bool binary, GroupIntegers& integers);

}  // namespace cleave::app
