#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "choice.hpp"
#include "commands.hpp"
#include "cut_files.hpp"
#include "error.hpp"
#include "file_words.hpp"
#include "losses.hpp"
#include "mesh_file.hpp"
#include "progress.hpp"

namespace cleave::app {
namespace {

using Json = nlohmann::ordered_json;

struct ConvertOptions {
  std::string in, out, json;
  WriteOptions write;
  bool strict = false, quiet = false;
};

std::string report_json(const ConvertOptions& options, const Mesh& mesh,
                        const std::vector<Loss>& losses) {
  Json list = Json::array();
  for (const Loss& loss : losses)
    list.push_back({{"kind", loss.kind}, {"count", loss.count}, {"message", loss.message}});
  const auto file = [](const std::string& path) {
    return Json{{"file", path}, {"format", name_of(format_of(path))}};
  };
  const Json report = {{"schema", "cleave-convert/1"},
                       {"input", file(options.in)},
                       {"output", file(options.out)},
                       {"mesh",
                        {{"dimension", mesh.dimension},
                         {"cells", mesh.cells().size()},
                         {"vertices", mesh.points.size()},
                         {"groups", mesh.groups.size()}}},
                       {"not_read", mesh.dropped},
                       {"losses", list}};
  return report.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string refusal(const ConvertOptions& options, const Mesh& mesh,
                    const std::vector<Loss>& losses) {
  std::string text = fmt::format(
      "'{}' cannot hold all of '{}', and --strict refuses a loss:", options.out, options.in);
  for (const Loss& loss : losses) text += "\n  " + loss.message;
  for (const std::string& dropped : mesh.dropped) text += "\n  " + dropped;
  return text;
}

int convert(const ConvertOptions& options) {
  require_options_fit(options.out, options.write);  // refused before anything is done
  Progress progress(2, options.quiet);
  progress.stage("reading " + options.in);
  const Mesh mesh = read_mesh(options.in, progress.within_stage());
  const std::vector<Loss> losses = losses_of(mesh, options.out, options.write);
  if (options.strict && (!losses.empty() || !mesh.dropped.empty()))
    throw InputError(refusal(options, mesh, losses));
  progress.stage("writing " + options.out);
  OutputFiles files;
  write_mesh(files, options.out, mesh, options.write);
  remove_record(files, options.out);
  if (!options.json.empty() && options.json != "-")
    files.add(options.json).write(report_json(options, mesh, losses));
  files.commit();
  progress.clear();
  for (const std::string& dropped : mesh.dropped) warn(dropped);
  for (const Loss& loss : losses) warn(loss.message);
  if (options.json == "-")
    print(report_json(options, mesh, losses));
  else if (!options.quiet)
    print(fmt::format(
        "{}: {}, {}, {}; {}\n", options.out, counted(mesh.cells().size(), "cell"),
        counted(mesh.points.size(), "vertex", "vertices"), counted(mesh.groups.size(), "group"),
        losses.empty() && mesh.dropped.empty() ? "nothing is lost"
                                               : "see the warnings for what is lost"));
  return kFine;
}

void add_form_options(CLI::App& command, ConvertOptions& options) {
  auto* binary = command.add_flag_callback(
      "--binary", [&options] { options.write.binary = true; },
      "Write .msh or .vtk in binary form (default of .vtk)");
  command
      .add_flag_callback(
          "--text", [&options] { options.write.binary = false; },
          "Write .msh or .vtk as text (default of .msh: as IN is)")
      ->excludes(binary);
  add_choice<std::optional<MshVersion>>(
      command, "--msh-version", options.write.msh_version,
      {{"2.2", MshVersion::k22}, {"4.1", MshVersion::k41}},
      "Version of a .msh file: 2.2 or 4.1 (default: as IN is, else 4.1)")
      ->option_text("VERSION");
  add_choice<std::optional<VtuEncoding>>(command, "--encoding", options.write.encoding,
                                         {{"text", VtuEncoding::kText},
                                          {"raw", VtuEncoding::kRaw},
                                          {"base64", VtuEncoding::kBase64},
                                          {"zlib", VtuEncoding::kZlib}},
                                         "Arrays of a .vtu file: text, raw, base64 (default) or "
                                         "zlib (compressed)")
      ->option_text("HOW");
}

}  // namespace

void add_convert_command(CLI::App& cleave, Action& chosen) {
  auto* command = cleave.add_subcommand(
      "convert", "Writes a mesh in another format, and says what that format cannot hold");
  auto options = std::make_shared<ConvertOptions>();
  command->add_option("IN", options->in, "Mesh file: " + mesh_extensions())
      ->required()
      ->option_text("FILE");
  command->add_option("OUT", options->out, "The mesh to write, in any of these formats")
      ->required()
      ->option_text("FILE");
  add_form_options(*command, *options);
  command->add_flag("--strict", options->strict,
                    "Refuse, and write nothing, if anything would be lost");
  command
      ->add_option("--json", options->json,
                   "Write what is lost to this file; - is standard "
                   "output")
      ->option_text("FILE");
  command->add_flag("--quiet", options->quiet, "No progress bar and no summary; warnings only");
  command->footer(
      "Exit status: 0 written; 2 wrong usage; 3 IN cannot be read, OUT cannot be written, or\n"
      "--strict refuses a loss; nothing is written then.\n"
      "Examples:\n"
      "  cleave convert fault.msh fault.inp\n"
      "  cleave convert fault.msh fault.vtu --encoding zlib --strict\n"
      "  cleave convert body.1.node body.msh --msh-version 2.2 --binary");
  command->callback([options, &chosen] {
    refuse_report_onto(options->json, mesh_files(options->in));
    refuse_report_onto(options->json, mesh_files(options->out));
    refuse_report_onto(options->json, {record_path(options->out).string()});
    chosen = [options] { return convert(*options); };
  });
}

}  // namespace cleave::app
