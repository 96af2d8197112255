#pragma once
#include <chrono>
#include <cstddef>
#include <functional>
#include <string>

namespace cleave::app {

/// Told how far a long piece of work has come, from 0 to 1; may be empty.
using HowFar = std::function<void(double)>;

/// Shows on one line of stderr how far a command has come, with the percentage and, once that can
/// be told, the time left; nothing if stderr is no terminal or the command is to be quiet. The line
/// is wiped when the object goes, when a signal ends the process, and before every message that is
/// printed through `clear`.
class Progress {
 public:
  Progress(std::size_t stages, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// The next of the stages begins. Further ones than were announced may be shown or not: ten a
  /// second are.
  void stage(const std::string& what);

  /// This stage has come so far, from 0 to 1. Drawn at most ten times a second.
  void within(double part);
  HowFar within_stage();

  /// Wipes the line, so that something else can be printed.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  void draw(double done);
  bool drawn_just_now() const;

  std::size_t stages_, at_ = 0;
  bool shown_;
  std::string what_;
  Clock::time_point start_ = Clock::now(), drawn_{};
};

}  // namespace cleave::app
