#pragma once
#include <filesystem>
#include <string>

namespace cleave::app {

/// The folder a run writes into. Files are written to a hidden folder `.cleave-PROCESS.tmp` inside
/// it first; commit() moves them to their place, all or none, replacing those of the same names and
/// leaving other files alone. Without commit, what was written goes, and the folder too if it was
/// made here. What a run that was killed has left behind goes when the next one begins.
class RunFolder {
 public:
  /// Makes `folder`, with its parents, unless it exists. Throws OutputError if that fails.
  explicit RunFolder(const std::filesystem::path& folder);
  ~RunFolder();
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  /// Where to write the file `name` to.
  std::filesystem::path staged(const std::string& name) const { return staging_ / name; }

  /// Moves all staged files to their place, against the order of their names, so that what
  /// describes a mesh is there before it. A description of groups that an earlier run left beside a
  /// mesh goes if this run's mesh has none. Throws OutputError; then every file that an earlier run
  /// left is as it was.
  void commit();

 private:
  std::filesystem::path folder_, staging_;
  int lock_ = -1;               // on staging_: says that it is in use
  std::filesystem::path made_;  // the topmost folder made here; empty: none
};

}  // namespace cleave::app
