#pragma once
#include <cstddef>
#include <string>

namespace cleave::app {

/// Shows on one line of stderr how far a command has come; nothing if stderr is no terminal or the
/// command is to be quiet. The line is wiped when the object goes, and before every message that is
/// printed through `clear`.
class Progress {
 public:
  Progress(std::size_t stages, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// The next of the stages begins.
  void stage(const std::string& what);

  /// Wipes the line, so that something else can be printed.
  void clear();

 private:
  std::size_t stages_, at_ = 0;
  bool shown_;
};

}  // namespace cleave::app
