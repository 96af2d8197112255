#include <CLI/CLI.hpp>
#include <iostream>
#include <sstream>
#include <string>

#include "cleave/topology/ids.hpp"
#include "commands.hpp"
#include "error.hpp"

namespace {

// Says what is wrong with the command line.
int wrong_usage(const CLI::App& cleave, const CLI::ParseError& error) {
  const auto commands = cleave.get_subcommands();
  const auto rest = cleave.remaining();
  std::cerr << "cleave: error: ";
  if (commands.empty() && !rest.empty()) {
    std::cerr << "there is no command '" << rest.front() << "'; there are ";
    const char* before = "";
    for (const CLI::App* command : cleave.get_subcommands([](const CLI::App*) { return true; })) {
      std::cerr << before << command->get_name();
      before = ", ";
    }
    std::cerr << '\n';
  } else {
    std::cerr << error.what() << '\n';
  }
  std::cerr << "`cleave " << (commands.empty() ? "" : commands.front()->get_name() + " ")
            << "--help` shows what can be given\n";
  return cleave::app::kUsage;
}

}  // namespace

/// cleave -- see docs/command-line.md. Exit status: 0 fine; 1 findings; 2 usage; 3 input missing,
/// unreadable or invalid for the request; 4 a defect of ours.
int main(int argc, char** argv) {
  using namespace cleave::app;
  CLI::App cleave{"Splits simplicial meshes along their own facets, and checks them"};
  cleave.name("cleave");
  cleave.set_version_flag("--version", "cleave " CLEAVE_VERSION ", " +
                                           std::to_string(cleave::topology::kIdBits) + "-bit ids");
  cleave.require_subcommand(1);
  cleave.footer("`cleave COMMAND --help` shows the options of a command, with examples.");
  Action chosen;
  add_check_command(cleave, chosen);
  add_convert_command(cleave, chosen);
  add_cut_command(cleave, chosen);
  add_stitch_command(cleave, chosen);
  add_certify_command(cleave, chosen);
  add_info_command(cleave, chosen);
  add_run_command(cleave, chosen);
  add_reduce_command(cleave, chosen);
  try {
    cleave.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() != 0) return wrong_usage(cleave, e);
    return guarded([&] {  // --help, --version
      std::ostringstream text;
      cleave.exit(e, text, text);
      print(text.str());
      return static_cast<int>(kFine);
    });
  }
  return guarded(chosen);
}
