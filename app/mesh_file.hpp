#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "mesh.hpp"
#include "mesh_formats.hpp"
#include "progress.hpp"

namespace cleave::app {

class OutputFiles;

/// Reads a mesh file; the extension names the format: `.mesh` (Medit), `.msh` (gmsh 2.2 and 4.1,
/// text and binary), `.node` or `.ele` (TetGen and Triangle, with what lies beside it), `.inp`
/// (Abaqus), `.vtu` and `.vtk` (VTK unstructured grids); `.mesh.gz`, `.msh.gz` and `.inp.gz` are
/// the same, compressed by gzip. Names of groups are taken from `PATH.groups.json` where the format
/// has none and that file lies beside the mesh. Throws InputError (file, line where the format has
/// lines, the file's own numbers, what to do) for everything that is not a mesh of edges, triangles
/// or tetrahedra in that format. Whether the mesh is any good (repeated cells, coordinates that are
/// not finite, ...) is not its business. Cost: linear in the file, which is mapped or read once;
/// memory is bounded by the file's size, whatever counts it claims. `how_far` is told how much of
/// the file is read (not of VTK's formats).
Mesh read_mesh(const std::filesystem::path& path, const HowFar& how_far = {});

/// How a .vtu file holds its arrays: as text, as bytes behind the XML (raw), or as base64 digits,
/// plain or compressed (zlib).
enum class VtuEncoding { kText, kRaw, kBase64, kZlib };

/// Choices that a format leaves; those that are empty follow the mesh, or what is usual.
struct WriteOptions {
  std::optional<MshVersion> msh_version = {};  // .msh; else the mesh's
  std::optional<bool> binary = {};             // .msh: else the mesh's form; .vtk: else true
  std::optional<VtuEncoding> encoding = {};    // .vtu; else kBase64
};

/// Throws InputError for an option that the format of `path` does not have, and for an extension
/// that is not known or ends in `.gz` (compress what was written).
void require_options_fit(const std::filesystem::path& path, const WriteOptions& options);

/// Writes a mesh in the format of the extension, completely or not at all (see OutputFiles); order,
/// tuples and, where the format has them, numbers are kept: `.msh` keeps the numbers of vertices
/// and elements as long as they are distinct and positive, `.inp` if they have at most nine digits
/// besides; the others number by place, `.node` from 0 or 1 as the mesh does. What a format cannot
/// hold is left out: see losses.hpp. Groups of a format with one integer per element that have
/// names, or overlap, are described in `PATH.groups.json`, which is removed when there is nothing
/// to describe. The same mesh gives the same bytes: no date, path or version is written. Throws
/// InputError as require_options_fit does, OutputError for everything else.
void write_mesh(const std::filesystem::path& path, const Mesh& mesh,
                const WriteOptions& options = {});

/// The same as a part of `files`: nothing appears before files.commit().
void write_mesh(OutputFiles& files, const std::filesystem::path& path, const Mesh& mesh,
                const WriteOptions& options = {});

}  // namespace cleave::app
