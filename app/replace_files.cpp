#include "replace_files.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <set>
#include <system_error>
#include <vector>

#include "error.hpp"

namespace cleave::app {
namespace {

/// Makes renames survive a power cut. Some file systems cannot, which is no error of ours.
void sync_folder(const std::filesystem::path& folder) {
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  fsync(descriptor);
  close(descriptor);
}

/// What stands at a path now, under a second name until this object goes.
class Backup {
 public:
  explicit Backup(const std::filesystem::path& of) : of_(of) {
    struct stat status {};
    existed_ = lstat(of.c_str(), &status) == 0;
    if (!existed_) return;
    const auto name = temporary_name(of);
    watch_ = std::make_unique<WatchedTemporary>(name.string());
    if (link(of.c_str(), name.c_str()) == 0) name_ = name;
  }
  ~Backup() {
    if (!name_.empty()) unlink(name_.c_str());
  }
  Backup(const Backup&) = delete;
  Backup& operator=(const Backup&) = delete;

  /// Puts it back. Where no second name could be made, nothing can be done.
  void restore() {
    if (!existed_) {
      unlink(of_.c_str());
    } else if (!name_.empty() && rename(name_.c_str(), of_.c_str()) == 0) {
      name_.clear();
    }
  }

 private:
  std::filesystem::path of_, name_;
  std::unique_ptr<WatchedTemporary> watch_;
  bool existed_ = false;
};

bool replace(const Replacement& step) {
  if (!step.from.empty()) return rename(step.from.c_str(), step.to.c_str()) == 0;
  return unlink(step.to.c_str()) == 0 || errno == ENOENT;
}

}  // namespace

std::filesystem::path folder_of(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

std::filesystem::path temporary_name(const std::filesystem::path& target) {
  static std::atomic<unsigned> count{0};
  return folder_of(target) /
         (".cleave-" + std::to_string(getpid()) + "-" + std::to_string(count++) + ".tmp");
}

std::filesystem::path behind_links(const std::filesystem::path& path) {
  std::filesystem::path file = path;
  std::error_code error;
  for (int links = 0; links < 40 && std::filesystem::is_symlink(file, error); ++links) {
    const auto next = std::filesystem::read_symlink(file, error);
    if (error) break;
    file = file.parent_path() / next;
  }
  return file;
}

void cannot_write(const std::filesystem::path& shown, int error_number) {
  std::string what =
      "cannot write '" + shown.string() + "': " + std::generic_category().message(error_number);
  if (error_number == ENOSPC || error_number == EDQUOT)
    what += "; free some space or write elsewhere, no partial file is left";
  if (error_number == ENOENT) what += "; no files can be made in this folder, write elsewhere";
  if (error_number == EISDIR) what += "; give the name of a file in it";
  throw OutputError(what);
}

void replace_together(std::span<const Replacement> replacements) {
  // The last step needs no way back: if it fails, it has changed nothing.
  std::vector<std::unique_ptr<Backup>> backups;
  for (std::size_t i = 0; i + 1 < replacements.size(); ++i)
    backups.push_back(std::make_unique<Backup>(replacements[i].to));
  for (std::size_t i = 0; i < replacements.size(); ++i) {
    if (replace(replacements[i])) continue;
    const int error_number = errno;
    for (std::size_t done = i; done-- > 0;) backups[done]->restore();
    cannot_write(replacements[i].shown, error_number);
  }
  std::set<std::filesystem::path> folders;
  for (const Replacement& step : replacements) folders.insert(folder_of(step.to));
  for (const auto& folder : folders) sync_folder(folder);
}

}  // namespace cleave::app
