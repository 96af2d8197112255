#include "run_folder.hpp"

#include <unistd.h>

#include <set>
#include <system_error>

#include "error.hpp"
#include "mesh_file.hpp"

namespace cleave::app {
namespace {

// The topmost folder that create_directories(folder) would make; empty: none.
std::filesystem::path topmost_missing(std::filesystem::path folder) {
  std::filesystem::path missing;
  std::error_code error;
  while (!folder.empty() && !std::filesystem::exists(folder, error)) {
    missing = folder;
    folder = folder.parent_path();
  }
  return missing;
}

}  // namespace

RunFolder::RunFolder(const std::filesystem::path& folder)
    : folder_(folder), made_(topmost_missing(folder)) {
  std::error_code error;
  if (folder.empty()) throw OutputError("cannot write: the name of the output folder is empty");
  if (made_.empty() && !std::filesystem::is_directory(folder_, error))
    throw OutputError("cannot write into '" + folder_.string() +
                      "': it is no folder; give another one");
  staging_ = folder_ / (".cleave-" + std::to_string(getpid()) + ".tmp");
  std::filesystem::create_directories(staging_, error);
  if (error) {
    if (!made_.empty()) {
      std::error_code ignored;
      std::filesystem::remove_all(made_, ignored);
    }
    throw OutputError("cannot write into '" + folder_.string() + "': " + error.message());
  }
}

RunFolder::~RunFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(staging_, ignored);
  if (!made_.empty()) std::filesystem::remove_all(made_, ignored);
}

void RunFolder::commit() {
  std::set<std::filesystem::path> names;
  for (const auto& entry : std::filesystem::directory_iterator(staging_))
    names.insert(entry.path().filename());
  for (const auto& name : names) {
    std::error_code ignored;
    if (std::filesystem::is_directory(folder_ / name, ignored))
      throw OutputError("cannot write '" + (folder_ / name).string() +
                        "': it is a folder; move it away, or write into another one");
  }
  for (const auto& name : names) {
    std::error_code error;
    const std::filesystem::path described = groups_path(name);
    if (name.extension() == ".vtu" && names.count(described) == 0)
      std::filesystem::remove(folder_ / described, error);
    if (!error) std::filesystem::rename(staging_ / name, folder_ / name, error);
    if (error)
      throw OutputError("cannot write '" + (folder_ / name).string() + "': " + error.message());
  }
  made_.clear();
}

}  // namespace cleave::app
