#include <CLI/CLI.hpp>
#include <memory>

#include "commands.hpp"
#include "error.hpp"
#include "mesh_file.hpp"
#include "mesh_info.hpp"

namespace cleave::app {
namespace {

struct InfoOptions {
  std::string mesh, json;
};

int tell(const InfoOptions& options) {
  const Mesh mesh = read_mesh(options.mesh);
  for (const std::string& dropped : mesh.dropped) warn(dropped);
  const MeshInfo info = info_of(mesh, options.mesh);
  if (!options.json.empty()) write_report(options.json, json_of(info, mesh));
  if (options.json != "-") print(text_of(info, mesh));
  return kFine;
}

}  // namespace

void add_info_command(CLI::App& cleave, Action& chosen) {
  auto* command = cleave.add_subcommand("info", "Says what a mesh file holds");
  auto options = std::make_shared<InfoOptions>();
  command->add_option("MESH", options->mesh, "Mesh file: " + mesh_extensions())
      ->required()
      ->option_text("FILE");
  command
      ->add_option("--json", options->json, "Write it as JSON to this file; - is standard output")
      ->option_text("FILE");
  command->footer(
      "Exit status: 0 read; 2 wrong usage; 3 the file cannot be read.\n"
      "Examples:\n"
      "  cleave info fault.msh\n"
      "  cleave info fault.msh --json -");
  command->callback([options, &chosen] {
    refuse_report_onto(options->json, mesh_files(options->mesh));
    chosen = [options] { return tell(*options); };
  });
}

}  // namespace cleave::app
