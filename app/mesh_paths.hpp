#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace cleave::app {

/// The files that arguments of a command stand for.
struct MeshPaths {
  std::vector<std::string> files;  // as messages name them
  std::size_t excluded = 0;        // left out by a pattern
};

/// Each of `arguments` in its order: a file stands for itself, a folder for the mesh files (by
/// their extension) in it and in the folders below, ordered by their paths. Names that begin with a
/// dot are left out below a folder; symbolic links to folders are not followed. A file that comes
/// twice is taken once. Throws InputError for a folder that cannot be read or has no mesh file.
MeshPaths find_meshes(const std::vector<std::string>& arguments,
                      const std::function<bool(const std::filesystem::path&)>& excluded);

}  // namespace cleave::app
