#pragma once
#include <filesystem>

#include "files/group_integers.hpp"
#include "files/input_text.hpp"
#include "files/text_output.hpp"
#include "mesh.hpp"

namespace cleave::app {

/// The files of one mesh: points, cells, facets of tetrahedra, edges.
struct TetgenPaths {
  std::filesystem::path node, ele, face, edge;
};

/// The files that belong together with `path`, which names one of them.
TetgenPaths tetgen_paths(const std::filesystem::path& path);

/// The same, as texts; the last two may be absent.
struct TetgenTexts {
  const InputText& node;
  const InputText& ele;
  const InputText* face = nullptr;
  const InputText* edge = nullptr;
};

/// Reads the files of TetGen (tetrahedra with 4 or 10 nodes) and of Triangle (3 or 6 nodes, points
/// of 2 coordinates). Vertices and elements of each kind are numbered from 0 or from 1 on, as the
/// .node file does. A boundary marker is the group of a vertex, facet or edge, 0 none; the first
/// attribute of the cells is their group if it is an integer everywhere; other attributes are
/// fields, attribute_1 and so on. What TetGen appends to rows of faces and edges for -nn, their
/// neighbours, is passed over. Each file must hold exactly what its first line promises and end
/// with a line end, so that a truncated one is noticed. Throws InputError (file and line).
Mesh read_tetgen(const TetgenTexts& texts);

/// The same from the disk: .node and .ele must be there, .face and .edge are read if they are.
Mesh read_tetgen(const std::filesystem::path& path);

/// The files to write. Those of faces and edges are null for a mesh without any; facets of
/// triangles are edges.
struct TetgenOutputs {
  TextOutput &node, &ele;
  TextOutput *face = nullptr, *edge = nullptr;
};

/// Throws OutputError for what the format cannot hold at all: cells that are edges, triangles out
/// of the plane z = 0.
void require_tetgen_can_hold(const Mesh& mesh);

/// Writes a mesh of triangles or tetrahedra that the format can hold; returns what markers and
/// attributes mean. Numbers start from 0 if the mesh's first vertex is number 0, else from 1.
GroupIntegers write_tetgen(const TetgenOutputs& out, const Mesh& mesh);

}  // namespace cleave::app
