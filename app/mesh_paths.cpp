#include "mesh_paths.hpp"

#include <algorithm>
#include <set>
#include <system_error>

#include "error.hpp"
#include "mesh_file.hpp"

namespace cleave::app {
namespace {

namespace fs = std::filesystem;

bool is_hidden(const fs::path& path) {
  const std::string name = path.filename().string();
  return !name.empty() && name.front() == '.';
}

bool is_mesh_path(const fs::path& path) {
  std::error_code ignored;
  if (path.extension() == ".ele" && fs::exists(fs::path(path).replace_extension(".node"), ignored))
    return false;  // the .node file stands for both
  try {
    format_of(path);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

// The mesh files below `folder`, ordered by path.
std::vector<fs::path> meshes_below(const fs::path& folder) {
  std::vector<fs::path> files;
  try {
    for (fs::recursive_directory_iterator at(folder), end; at != end; ++at) {
      std::error_code ignored;
      if (is_hidden(at->path())) {
        at.disable_recursion_pending();
      } else if (at->is_regular_file(ignored) && is_mesh_path(at->path())) {
        files.push_back(at->path());
      }
    }
  } catch (const fs::filesystem_error& e) {
    throw InputError("'" + folder.string() + "': the folder cannot be read: " + e.code().message());
  }
  std::sort(files.begin(), files.end());  // part by part
  return files;
}

}  // namespace

MeshPaths find_meshes(const std::vector<std::string>& arguments,
                      const std::function<bool(const fs::path&)>& excluded) {
  MeshPaths paths;
  std::set<fs::path> known;
  const auto take = [&](const fs::path& file) {
    std::error_code error;
    const fs::path whole = fs::weakly_canonical(file, error);
    if (!known.insert(error ? file : whole).second) return;
    if (excluded(file))
      ++paths.excluded;
    else
      paths.files.push_back(file.string());
  };
  for (const std::string& argument : arguments) {
    std::error_code ignored;
    if (!fs::is_directory(argument, ignored)) {
      take(argument);
      continue;
    }
    const std::vector<fs::path> files = meshes_below(argument);
    if (files.empty())
      throw InputError("'" + argument +
                       "': no file in this folder has the extension of a mesh; name "
                       "files, or another folder");
    for (const fs::path& file : files)
      take(argument == "." ? file.lexically_relative(".") : file.lexically_normal());
  }
  return paths;
}

}  // namespace cleave::app
