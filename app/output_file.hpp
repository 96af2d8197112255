#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "error.hpp"
#include "replace_files.hpp"
#include "sha256.hpp"
#include "temporaries.hpp"

namespace cleave::app {

/// One output file that is either written completely or not at all. The bytes go to a file in the
/// target's folder that has no name (or, where the file system has no such files, a temporary one);
/// commit() flushes it to the disk, gives it a temporary name and renames it. A destructor without
/// commit, an error, SIGINT, SIGTERM and SIGHUP remove the temporary name, and what stood at the
/// target before is still there. An existing file keeps its permissions; a symbolic link keeps
/// pointing at the file, which is replaced. A target that is a device or a pipe is written
/// directly. Every system call is checked: each failure (disk full, no such folder, ...) throws
/// OutputError with the target and the reason.
class OutputFile {
 public:
  explicit OutputFile(const std::filesystem::path& target);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Appends. Buffered: an error may show up in a later call, in commit() at the latest.
  void write(std::string_view bytes);

  /// What is written from now on is added to `digest` too, which must outlive it.
  void digest_into(Sha256& digest) { digest_ = &digest; }

  /// Makes the file appear under its name. Call once, as the last thing.
  void commit();

 private:
  friend class OutputFiles;

  void open_temporary();
  bool open_unnamed();
  void open_in_place();
  void write_out(std::string_view bytes);
  std::optional<Replacement> finish();
  void give_name();
  void close_descriptor();
  void discard();
  void forget_temporary();
  [[noreturn]] void fail(int error_number);

  std::filesystem::path shown_;      // as the caller named it, for messages
  std::filesystem::path target_;     // links resolved
  std::filesystem::path temporary_;  // empty: it has no name, or is written in place, or committed
  std::unique_ptr<WatchedTemporary> watch_;
  int descriptor_ = -1;
  bool in_place_ = false;
  Sha256* digest_ = nullptr;
  std::string buffer_;
};

/// Writes a whole file in the manner of OutputFile.
void write_file(const std::filesystem::path& target, std::string_view bytes);

}  // namespace cleave::app
