#include "run_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <set>
#include <system_error>
#include <vector>

#include "error.hpp"
#include "mesh_file.hpp"
#include "replace_files.hpp"

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

// Takes the lock that says that a staging folder is in use. Returns its descriptor; -1: another
// process has it, or there are no such locks here.
int lock(const std::filesystem::path& staging) {
  const int descriptor = open(staging.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0 || flock(descriptor, LOCK_EX | LOCK_NB) == 0) return descriptor;
  close(descriptor);
  return -1;
}

bool is_staging(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  std::error_code error;
  return name.rfind(".cleave-", 0) == 0 && path.extension() == ".tmp" &&
         std::filesystem::is_directory(path, error) && !std::filesystem::is_symlink(path, error);
}

// Removes the staging folders of processes that were killed.
void remove_abandoned(const std::filesystem::path& folder) {
  std::error_code error;
  std::vector<std::filesystem::path> found;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
    if (is_staging(entry->path())) found.push_back(entry->path());
  for (const auto& staging : found) {
    const int descriptor = lock(staging);
    if (descriptor < 0) continue;
    std::filesystem::remove_all(staging, error);
    close(descriptor);
  }
}

}  // namespace

RunFolder::RunFolder(const std::filesystem::path& folder)
    : folder_(folder), made_(topmost_missing(folder)) {
  std::error_code error;
  if (folder.empty()) throw OutputError("cannot write: the name of the output folder is empty");
  if (made_.empty() && !std::filesystem::is_directory(folder_, error))
    throw OutputError("cannot write into '" + folder_.string() +
                      "': it is no folder; give another one");
  remove_abandoned(folder_);
  staging_ = folder_ / (".cleave-" + std::to_string(getpid()) + ".tmp");
  std::filesystem::create_directories(staging_, error);
  if (error) {
    if (!made_.empty()) {
      std::error_code ignored;
      std::filesystem::remove_all(made_, ignored);
    }
    throw OutputError("cannot write into '" + folder_.string() + "': " + error.message());
  }
  lock_ = lock(staging_);
}

RunFolder::~RunFolder() {
  if (lock_ >= 0) close(lock_);
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
  std::vector<Replacement> replacements;
  const auto move_in = [&](const std::filesystem::path& from, const std::filesystem::path& name) {
    replacements.push_back({from, folder_ / name, folder_ / name});
  };
  for (auto name = names.rbegin(); name != names.rend(); ++name) move_in(staging_ / *name, *name);
  for (const auto& name : names)
    if (name.extension() == ".vtu" && names.count(groups_path(name)) == 0)
      move_in({}, groups_path(name));
  replace_together(replacements);
  made_.clear();
}

}  // namespace cleave::app
