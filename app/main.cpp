#include <CLI/CLI.hpp>
#include <iostream>

#include "commands.hpp"
#include "error.hpp"

/// cleave -- see docs/command-line.md. Exit status: 0 fine; 1 findings; 2 usage; 3 input missing,
/// unreadable or invalid for the request; 4 a defect of ours.
int main(int argc, char** argv) {
  using namespace cleave::app;
  CLI::App cleave{"Splits simplicial meshes along their own facets, and checks them"};
  cleave.name("cleave");
  cleave.set_version_flag("--version", "cleave " CLEAVE_VERSION);
  cleave.require_subcommand(1);
  cleave.footer("`cleave COMMAND --help` shows the options of a command, with examples.");
  Action chosen;
  add_check_command(cleave, chosen);
  add_cut_command(cleave, chosen);
  add_run_command(cleave, chosen);
  try {
    cleave.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return cleave.exit(e, std::cout, std::cerr) == 0 ? kFine : kUsage;
  }
  return guarded(chosen);
}
