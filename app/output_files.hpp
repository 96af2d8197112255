#pragma once
#include <deque>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "output_file.hpp"

namespace cleave::app {

/// Output files that belong together (a mesh, the names of its groups, a report): either all of
/// them appear, or none, and what stood at their names before is still there. Only a process that
/// is killed outright while commit() renames them can leave some new and the others old; no file is
/// partial then either, and since they appear in the reverse order, whatever describes a file and
/// was added after it is there before it.
class OutputFiles {
 public:
  /// `hashed`: `sha256` is to be called.
  explicit OutputFiles(bool hashed = false) : hashed_(hashed) {}

  /// A further file, to be written by the caller. The reference stays valid. Throws as OutputFile.
  OutputFile& add(const std::filesystem::path& target);

  /// A file that is to be gone when the others appear. It need not be there.
  void remove(const std::filesystem::path& target);

  /// The files so far, with the SHA-256 of what was written to each. Call once; what is written to
  /// these files later is not in it.
  std::vector<std::pair<std::filesystem::path, std::string>> sha256();

  /// Brings all files to the disk, then makes them appear, the last one added first, then removes
  /// what is to go. Call once, as the last thing. Throws OutputError.
  void commit();

 private:
  bool hashed_;
  std::deque<std::pair<std::filesystem::path, Sha256>> digests_;
  std::deque<OutputFile> files_;
  std::vector<std::filesystem::path> gone_;
};

}  // namespace cleave::app
