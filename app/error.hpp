#pragma once
#include <stdexcept>
#include <string>

namespace cleave::app {

/// Exit statuses of the command, the same for every subcommand.
enum ExitStatus { kFine = 0, kFindings = 1, kUsage = 2, kBadInput = 3, kBroken = 4 };

/// Input that is missing, unreadable or invalid for the request: what, where, what to do. main()
/// prints it to stderr and exits with kBadInput; nothing has been written then.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Output that cannot be written: what, where, why. main() prints it to stderr and exits with
/// kBadInput; no partial file is left.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace cleave::app
