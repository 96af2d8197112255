#pragma once
#include <string>

namespace cleave::app {

/// The name of a temporary file that is removed if SIGINT, SIGTERM or SIGHUP ends the process while
/// this object lives. The first one made installs the handlers, for those signals whose action is
/// still the default; they remove every live name and let the signal end the process as usual.
/// Up to 16 names at a time are watched, further ones are simply not.
class WatchedTemporary {
 public:
  explicit WatchedTemporary(const std::string& path);
  ~WatchedTemporary();
  WatchedTemporary(const WatchedTemporary&) = delete;
  WatchedTemporary& operator=(const WatchedTemporary&) = delete;

 private:
  int slot_;  // -1: not watched
};

/// While true, those signals wipe the line of the terminal on stderr that the process has drawn.
void watch_line(bool drawn);

/// Makes the process end with a message and the exit status of an unreadable file when a mapped
/// file turns out to be shorter than it was (SIGBUS).
void watch_mapped_input();

}  // namespace cleave::app
