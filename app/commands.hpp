#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the library has this name
class App;
}

/// The subcommands. Each function adds one to `cleave`; when the command line asks for it, `chosen`
/// is what to do: it returns the exit status, or throws what `guarded` explains.
namespace cleave::app {

using Action = std::function<int()>;

void add_certify_command(CLI::App& cleave, Action& chosen);
void add_check_command(CLI::App& cleave, Action& chosen);
void add_convert_command(CLI::App& cleave, Action& chosen);
void add_cut_command(CLI::App& cleave, Action& chosen);
void add_info_command(CLI::App& cleave, Action& chosen);
void add_run_command(CLI::App& cleave, Action& chosen);
void add_reduce_command(CLI::App& cleave, Action& chosen);
void add_stitch_command(CLI::App& cleave, Action& chosen);

/// Does `action` and turns what it throws into a message on stderr and an exit status: InputError,
/// OutputError, too many cells and too little memory into kBadInput; anything else, which is a
/// defect of ours, into kBroken.
int guarded(const Action& action);

/// Why an action did not come to its end.
struct Failure {
  int status;        // the exit status
  std::string text;  // what, where, what to do
};

/// Does `action`; what it throws, as `guarded` sees it.
std::optional<Failure> attempt(const std::function<void()>& action);

/// Prints "cleave: error: .." on stderr and returns the status.
int complain(const Failure& failure);

/// Prints "cleave: warning: .." on stderr.
void warn(const std::string& text);

/// Prints "cleave: .." on stderr: what a user should know and need not heed.
void note(const std::string& text);

/// Throws CLI::ValidationError if `report`, where `option` of a command is to write `what`, is one
/// of `files`, which the command reads or writes. Empty names and "-" are no files.
void refuse_report_onto(const std::string& report, const std::vector<std::string>& files,
                        const std::string& option = "--json", const std::string& what = "report");

/// Writes `text` to the file at `path`, completely or not at all; "-" is standard output. Throws
/// OutputError.
void write_report(const std::string& path, const std::string& text);

/// Writes `text` to standard output; throws OutputError if not all of it arrives.
void print(const std::string& text);

}  // namespace cleave::app
