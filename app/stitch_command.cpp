#include <CLI/CLI.hpp>

#include "choice.hpp"
#include "commands.hpp"
#include "cut_files.hpp"
#include "error.hpp"
#include "mesh_file.hpp"
#include "stitch_mesh.hpp"

namespace cleave::app {
namespace {

int run_stitch(const StitchOptions& options) {
  if (!options.out.empty()) require_format(options.out, false);  // refused before anything is done
  Progress progress(5, options.quiet);
  progress.stage("reading " + options.mesh);
  const CutSource source = read_source(options.mesh, false, progress.within_stage());
  progress.clear();
  for (const std::string& dropped : source.mesh.dropped) warn(dropped);
  StitchResult result = stitch_mesh(source, options, progress);
  progress.clear();
  for (const std::string& warning : result.warnings) warn(warning);
  CutAnswer said = answer(options.json, json_of(result.report),
                          text_of(result.report, options.mesh), options.quiet);
  add_certificate(said, options.certificate, std::move(result.certificate));
  if (options.dry_run) {
    write_answer(said);
    return kFine;
  }
  progress.stage("writing " + options.out);
  write_cut(options.out, result.mesh, result.record ? &*result.record : nullptr, said);
  progress.clear();
  return kFine;
}

}  // namespace

void add_stitch_command(CLI::App& cleave, Action& chosen) {
  auto* stitch = cleave.add_subcommand("stitch", "Takes facets of an earlier cut back");
  auto options = std::make_shared<StitchOptions>();
  stitch
      ->add_option("MESH", options->mesh,
                   "Mesh that `cleave cut` wrote, with MESH.cleave.json beside it")
      ->required()
      ->option_text("FILE");
  auto* out =
      stitch->add_option("-o,--output", options->out, "The mesh to write; MESH itself is fine, too")
          ->option_text("OUT");
  auto* what = stitch->add_option_group("What to take back", "facets, groups, or all");
  auto* facets =
      what->add_option("--facets", options->facets,
                       "Facets by vertex numbers: JSON {\"facets\": [[a, b, c], ..]}; either side "
                       "of an opened one; - is standard input")
          ->option_text("FILE");
  auto* groups =
      what->add_option("--group", options->groups,
                       "Names as they were given at the cut, or with _minus, _plus, _shut; cut: "
                       "what had no name")
          ->option_text("NAME..");
  what->add_flag("--all", options->all, "Every facet: gives the mesh from before all cuts")
      ->excludes(facets)
      ->excludes(groups);
  what->require_option(1, 0);
  auto* dry_run = stitch->add_flag("--dry-run", options->dry_run, "Do everything but write OUT");
  add_choice<topology::Verify>(
      *stitch, "--verify", options->verify,
      {{"none", topology::Verify::none},
       {"touched", topology::Verify::touched},
       {"all", topology::Verify::all}},
      "Verify nothing (none), what was touched (touched, default), or everything and certify the "
      "result (all)")
      ->option_text("WHAT");
  stitch->add_option("--json", options->json, "Write the report to this file; - is standard output")
      ->option_text("FILE");
  stitch
      ->add_option("--certificate", options->certificate,
                   "Write the original cells, the facets that are cut still and the cells after, "
                   "for `cleave certify`; - is standard output")
      ->option_text("FILE");
  stitch->add_flag("--quiet", options->quiet, "No progress bar and no summary");
  stitch->footer(
      "Exit status: 0 done; 2 wrong usage; 3 the input is missing, unreadable or invalid for the\n"
      "request, nothing is written; 4 a defect of cleave.\n"
      "Examples:\n"
      "  cleave stitch open.msh -o open.msh --group branch\n"
      "  cleave stitch open.msh -o whole.msh --all");
  stitch->callback([options, out, dry_run, &chosen] {
    if (out->count() == 0 && dry_run->count() == 0)
      throw CLI::RequiredError("-o OUT (or --dry-run)");
    const StitchOptions& o = *options;
    std::vector<std::string> files{o.mesh,
                                   o.out,
                                   o.facets,
                                   groups_path(o.mesh).string(),
                                   groups_path(o.out).string(),
                                   record_path(o.mesh).string(),
                                   record_path(o.out).string()};
    refuse_report_onto(o.json, files);
    files.push_back(o.json);
    refuse_certificate(o.certificate, files, o.json);
    chosen = [options] { return run_stitch(*options); };
  });
}

}  // namespace cleave::app
