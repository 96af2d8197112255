#include <CLI/CLI.hpp>

#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>

#include "commands.hpp"
#include "error.hpp"
#include "mesh_file.hpp"
#include "output_file.hpp"
#include "progress.hpp"
#include "run_folder.hpp"
#include "run_pipeline.hpp"
#include "scene.hpp"

namespace cleave::app {
namespace {

struct RunOptions {
  std::string scene, folder;
  bool strict = false, quiet = false;
};

void write_vtu(const RunResult& result, RunFolder& folder, Parts& parts) {
  if (result.vtu.empty()) return;
  parts.build("vtu", [&] {
    for (const StateFile& file : result.vtu) write_mesh(folder.staged(file.name), file.mesh);
  });
}

void write_page_file(const RunResult& result, RunFolder& folder, Parts& parts) {
  if (!result.page) return;
  parts.build("page", [&] {
    std::ostringstream page;
    try {
      write_page(page, *result.page);
    } catch (const std::invalid_argument& e) {
      throw InputError(std::string("the page cannot be drawn: ") + e.what());
    }
    write_file(folder.staged(result.report.page), page.str());
  });
}

/// Runs a scene and writes what it leaves. Returns kFine if every solve converged, else kFindings.
int run(const RunOptions& options) {
  const Scene scene = read_scene(options.scene);
  Progress progress(run_stages(scene) + 1, options.quiet);
  RunResult result = run_scene(
      scene, [&](const std::string& what) { progress.stage(what); }, options.strict);
  RunReport& report = result.report;
  progress.stage("writing");
  RunFolder folder(options.folder);
  write_vtu(result, folder, report.parts);
  write_page_file(result, folder, report.parts);
  write_file(folder.staged("summary.json"), summary_json(report));
  progress.clear();
  for (const std::string& warning : report.warnings) warn(warning);
  if (!options.quiet) print(summary_text(report));
  folder.commit();
  return report.every_solve_converged() ? kFine : kFindings;
}

}  // namespace

void add_run_command(CLI::App& cleave, Action& chosen) {
  const auto options = std::make_shared<RunOptions>();
  CLI::App* command = cleave.add_subcommand(
      "run", "Runs a scene: mesh, supports, loads, strokes, solves; writes what became of it");
  command->add_option("SCENE", options->scene, "Scene file (JSON)")->required();
  command
      ->add_option("-o,--output", options->folder,
                   "Folder to write into: summary.json, .vtu files, index.html. Made if missing; "
                   "files of the same names are replaced")
      ->required();
  command->add_flag("--strict", options->strict,
                    "Refuse a mesh that is not cut-regular instead of regularising it");
  command->add_flag("-q,--quiet", options->quiet, "Print warnings and errors only");
  command->footer(
      "Exit status: 0 every solve converged, 1 some solve did not (summary.json says how it "
      "ended),\n3 the scene or its mesh is invalid and nothing was written.\n\n"
      "  cleave run data/liver.scene.json -o liver      the demo; open liver/index.html\n\n"
      "docs/scenes.md describes scene files by example.");
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

}  // namespace cleave::app
