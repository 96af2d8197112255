#include <CLI/CLI.hpp>

#include "check_report.hpp"
#include "choice.hpp"
#include "commands.hpp"
#include "error.hpp"
#include "mesh_file.hpp"
#include "progress.hpp"

namespace cleave::app {
namespace {

struct CheckOptions {
  std::vector<std::string> meshes;
  topology::Level required = topology::Level::cut_regular;
  std::string json;
  bool quiet = false;
};

constexpr std::size_t kShownPerRule = 20;

// 0: no finding is an error; 1: some are; 3: some mesh cannot be read, and no JSON is written.
int check_meshes(const CheckOptions& options) {
  std::vector<CheckReport> reports;
  int status = kFine;
  Progress progress(2 * options.meshes.size(), options.quiet);
  for (const std::string& path : options.meshes) {
    const int outcome = guarded([&] {
      progress.stage("reading " + path);
      const Mesh mesh = read_mesh(path);
      progress.stage("checking " + path);
      reports.push_back(check_mesh(mesh, options.required));
      progress.clear();
      for (const std::string& note : mesh.dropped) warn(note);
      if (options.json != "-") print(text_of(reports.back(), kShownPerRule, !options.quiet));
      return reports.back().errors() == 0 ? kFine : kFindings;
    });
    status = std::max(status, outcome);
  }
  if (status <= kFindings && !options.json.empty()) write_report(options.json, json_of(reports));
  return status;
}

}  // namespace

void add_check_command(CLI::App& cleave, Action& chosen) {
  auto* check = cleave.add_subcommand(
      "check", "Says of meshes what is wrong with them, with the witness of each finding");
  auto options = std::make_shared<CheckOptions>();
  check->add_option("MESH", options->meshes, "Mesh files: .mesh, .msh, .vtu, .vtk")
      ->required()
      ->option_text("FILE..");
  add_choice<topology::Level>(*check, "--require", options->required,
                              {{"pseudo-manifold", topology::Level::pseudo_manifold},
                               {"cut-regular", topology::Level::cut_regular},
                               {"edge-regular", topology::Level::edge_regular},
                               {"manifold", topology::Level::manifold}},
                              "What is below this level is an error, what is above it a warning: "
                              "pseudo-manifold, cut-regular (default), edge-regular or manifold")
      ->option_text("LEVEL");
  check
      ->add_option("--json", options->json, "Write all findings to this file; - is standard output")
      ->option_text("FILE");
  check->add_flag("--quiet", options->quiet, "No progress bar and no summary; findings only");
  check->footer(
      "Exit status: 0 no errors; 1 errors found; 2 wrong usage; 3 a file cannot be read.\n"
      "Examples:\n"
      "  cleave check liver.mesh\n"
      "  cleave check --require manifold --json report.json part-*.msh");
  check->callback([options, &chosen] {
    refuse_report_onto(options->json, options->meshes);
    chosen = [options] { return check_meshes(*options); };
  });
}

}  // namespace cleave::app
