#pragma once
#include <filesystem>
#include <optional>

#include "mesh.hpp"

namespace cleave::app {

class OutputFiles;

enum class MeshFormat { kMedit, kGmsh, kVtu, kVtk };

/// The format that the extension of `path` names; upper and lower case are the same, and a further
/// extension `.gz` is passed over. Throws InputError, with the extensions there are, if it names
/// none.
MeshFormat format_of(const std::filesystem::path& path);

/// The same for a file to write: throws InputError for `.gz` too, which is read and not written.
MeshFormat output_format_of(const std::filesystem::path& path);

/// Reads a mesh file; the extension names the format: `.mesh` (Medit), `.msh` (gmsh 2.2 and 4.1,
/// text and binary), `.vtu` and `.vtk` (VTK unstructured grids); `.mesh.gz` and `.msh.gz` are the
/// same, compressed by gzip. Names of groups are taken from `PATH.groups.json` where the format has
/// none and that file lies beside the mesh.
/// Throws InputError (file, line where the format has lines, the file's own numbers, what to do)
/// for everything that is not a mesh of edges, triangles or tetrahedra in that format. Whether the
/// mesh is any good (repeated cells, coordinates that are not finite, ...) is not its business.
/// Cost: linear in the file, which is mapped or read once; memory is bounded by the file's size,
/// whatever counts it claims.
Mesh read_mesh(const std::filesystem::path& path);

/// Choices that a format leaves; those that are empty follow the mesh, or what is usual.
struct WriteOptions {
  std::optional<MshVersion> msh_version;  // .msh; else the mesh's
  std::optional<bool> binary;             // .msh: else the mesh's form; others have one form
};

/// Writes a mesh in the format of the extension, completely or not at all (see OutputFiles); order,
/// tuples and, where the format has them, numbers are kept: `.msh` keeps the numbers of vertices
/// and elements as long as they are distinct and positive, `.mesh`, `.vtu` and `.vtk` number by
/// place. Groups of a format with one integer per element that have names, or overlap, are
/// described in `PATH.groups.json`, which is removed when there is nothing to describe.
/// The same mesh gives the same bytes: no date, path or version is written.
/// Throws InputError for an extension that is not known or ends in `.gz` (compress what was
/// written), and for an option that the format does not have; OutputError for everything else.
void write_mesh(const std::filesystem::path& path, const Mesh& mesh,
                const WriteOptions& options = {});

/// The same as a part of `files`: nothing appears before files.commit().
void write_mesh(OutputFiles& files, const std::filesystem::path& path, const Mesh& mesh,
                const WriteOptions& options = {});

/// Where the names of groups go when the format of `mesh_path` cannot hold them; beside a
/// compressed file the name is that of the file within.
std::filesystem::path groups_path(const std::filesystem::path& mesh_path);

}  // namespace cleave::app
