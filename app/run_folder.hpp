#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace cleave::app {

/// The folder a run writes into. Files are written to a hidden folder inside it first; commit()
/// moves them to their place, replacing those of the same names and leaving other files alone.
/// Without commit, what was written goes, and the folder too if it was made here.
class RunFolder {
 public:
  /// Makes `folder`, with its parents, unless it exists. Throws OutputError if that fails.
  explicit RunFolder(const std::filesystem::path& folder);
  ~RunFolder();
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  /// Where to write the file `name` to. commit() expects it to be there.
  std::filesystem::path staged(const std::string& name);

  /// Moves all files to their place, in the order they were staged. Throws OutputError.
  void commit();

 private:
  std::filesystem::path folder_, staging_;
  std::filesystem::path made_;  // the topmost folder made here; empty: none
  std::vector<std::string> names_;
};

}  // namespace cleave::app
