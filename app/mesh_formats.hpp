#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace cleave::app {

enum class MeshFormat { kMedit, kGmsh, kTetgen, kAbaqus, kVtu, kVtk };

/// The format that the extension of `path` names; upper and lower case are the same, and a further
/// extension `.gz` is passed over. Throws InputError, with the extensions there are, if it names
/// none.
MeshFormat format_of(const std::filesystem::path& path);

/// The same for a file that is to be written. Throws InputError for a compressed one, too.
MeshFormat output_format_of(const std::filesystem::path& path);

/// What a format is called: "Medit", "gmsh", ..
const char* name_of(MeshFormat format);

/// The extensions with their formats, for help texts and messages: ".mesh (Medit), .msh (gmsh),
/// ..".
std::string mesh_extensions();

/// Whether the format holds names and overlaps of groups itself. For others OUT.groups.json does.
bool has_group_names(MeshFormat format);

/// Where the names of groups go when the format of `mesh_path` cannot hold them; beside a
/// compressed file the name is that of the file within, beside TetGen's that of the .node file.
std::filesystem::path groups_path(const std::filesystem::path& mesh_path);

/// All files that the mesh at `path` may consist of: `path` itself, what lies beside it, and
/// OUT.groups.json. Any extension is accepted.
std::vector<std::string> mesh_files(const std::filesystem::path& path);

}  // namespace cleave::app
