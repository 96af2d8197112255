#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>

#include "choice.hpp"
#include "commands.hpp"
#include "cut_files.hpp"
#include "cut_mesh.hpp"
#include "error.hpp"
#include "mesh_file.hpp"

namespace cleave::app {
namespace {

int run_cut(const CutOptions& options) {
  if (!options.out.empty()) require_format(options.out, options.cohesive);
  Progress progress(6, options.quiet);
  progress.stage("reading " + options.mesh);
  const CutSource source = read_source(options.mesh, options.forget, progress.within_stage());
  progress.clear();
  for (const std::string& dropped : source.mesh.dropped) warn(dropped);
  if (source.record && !options.quiet) note(note_on(source));
  if (!source.record && !options.forget && looks_cut(source.mesh))
    warn(warning_of_lost_record(source.mesh));
  CutResult result = cut_mesh(source, options, progress);
  progress.clear();
  for (const std::string& warning : result.warnings) warn(warning);

  CutAnswer said = answer(options.json, json_of(result.report),
                          text_of(result.report, options.mesh, options.explain), options.quiet);
  if (!options.fix_it.empty()) {
    said.fix_it_file = options.fix_it;
    said.fix_it = fix_it_file(result.report);
  }
  add_certificate(said, options.certificate, std::move(result.certificate));
  if (options.dry_run) {
    write_answer(said);
  } else {
    progress.stage("writing " + options.out);
    write_cut(options.out, result.mesh, &result.record, said);
    progress.clear();
  }
  return options.require_open && result.report.shut > 0 ? kFindings : kFine;
}

void add_request(CLI::App& cut, CutOptions& options) {
  auto* what = cut.add_option_group("What to cut", "one of these, or several; --all alone");
  auto* facets =
      what->add_option(
              "--facets", options.facets,
              "Facets by vertex numbers: JSON {\"facets\": [[a, b, c], ..]}; - is standard "
              "input")
          ->option_text("FILE..");
  auto* groups = what->add_option("--group", options.groups, "Facet groups of MESH, by name")
                     ->option_text("NAME..");
  auto* sweep =
      what->add_option("--sweep", options.sweep,
                       "What a blade sweeps: JSON {\"blade\": [[p, q], ..]}, "
                       "{\"triangles\": ..} or, in a plane, {\"polyline\": [p, ..]}; - is "
                       "standard input")
          ->option_text("FILE");
  what->add_flag("--all", options.all, "Every interior facet")
      ->excludes(facets)
      ->excludes(groups)
      ->excludes(sweep);
  what->require_option(1, 0);
  cut.add_option("--keep", options.keep, "Facet groups of MESH that stay as they are, by name")
      ->option_text("NAME..");

  add_choice<cutting::Rule>(
      cut, "--select", options.select.rule,
      {{"dual-edge", cutting::Rule::dual_edge}, {"nearest-vertex", cutting::Rule::nearest_vertex}},
      "How a sweep selects facets: dual-edge (default) or nearest-vertex")
      ->needs(sweep)
      ->option_text("RULE");
  add_choice<cutting::Ties>(
      cut, "--ties", options.select.ties,
      {{"id", cutting::Ties::by_id}, {"both", cutting::Ties::both}},
      "nearest-vertex: of two equally near vertices the one with the lesser number, id "
      "(default), or both")
      ->needs(sweep)
      ->option_text("HOW");
}

// What the options cannot say of each other by themselves.
void require_sense(const CutOptions& options, bool with_ties) {
  if (options.offset && !(*options.offset >= 0 && std::isfinite(*options.offset)))
    throw CLI::ValidationError("--offset", "the distance must be finite and not negative");
  if (options.offset.value_or(0) > 0 && options.cohesive)
    throw CLI::ValidationError("--offset", "it excludes --cohesive, unless it is 0");
  if (options.fix_it == "-") throw CLI::ValidationError("--fix-it", "give the name of a file");
  const auto from_stdin = std::count(options.facets.begin(), options.facets.end(), "-");
  if (from_stdin + (options.sweep == "-" ? 1 : 0) > 1)
    throw CLI::ValidationError("-", "standard input can be one request only");
  if (with_ties && options.select.rule != cutting::Rule::nearest_vertex)
    throw CLI::ValidationError(
        "--ties", "it has a meaning for --select nearest-vertex only; dual-edge knows no ties");
}

}  // namespace

void add_cut_command(CLI::App& cleave, Action& chosen) {
  auto* cut = cleave.add_subcommand("cut", "Separates the cells of a mesh along its own facets");
  auto options = std::make_shared<CutOptions>();
  cut->add_option("MESH", options->mesh, "Mesh file: " + mesh_extensions())
      ->required()
      ->option_text("FILE");
  auto* out =
      cut->add_option("-o,--output", options->out, "The mesh to write, in any of these formats")
          ->option_text("OUT");
  add_request(*cut, *options);

  auto* dry_run = cut->add_flag("--dry-run", options->dry_run, "Do everything but write OUT");
  cut->add_flag(
      "--explain", options->explain,
      "Say why facets stay shut, what would open them, and by which vertex facets opened");
  cut->add_option("--fix-it", options->fix_it,
                  "Write the further facets that would open all that stay shut, for --facets")
      ->option_text("FILE");
  auto* level = add_choice<std::optional<topology::Level>>(
                    *cut, "--require", options->require,
                    {{"pseudo-manifold", topology::Level::pseudo_manifold},
                     {"cut-regular", topology::Level::cut_regular},
                     {"edge-regular", topology::Level::edge_regular},
                     {"manifold", topology::Level::manifold}},
                    "Refuse a result below this level: pseudo-manifold, cut-regular, edge-regular "
                    "or manifold")
                    ->option_text("LEVEL");
  add_choice<bool>(*cut, "--require-by", options->require_by_cutting,
                   {{"refusing", false}, {"cutting", true}},
                   "Refuse (refusing, default), or cut further facets to reach the level (cutting)")
      ->needs(level)
      ->option_text("HOW");
  cut->add_flag("--cohesive", options->cohesive,
                "Put cohesive elements of no thickness between the two sides of what opens");
  cut->add_option("--offset", options->offset,
                  "Move the two sides apart by this distance, to look at the cut; 0 moves them "
                  "back")
      ->option_text("DISTANCE");
  cut->add_flag("--require-open", options->require_open, "Exit with 1 if a facet stays shut");
  cut->add_flag("--strict", options->strict,
                "Refuse a mesh that is not cut-regular instead of regularising it");
  cut->add_flag("--forget", options->forget,
                "Leave out the record of an earlier cut: MESH is a new mesh");
  add_choice<topology::Verify>(
      *cut, "--verify", options->verify,
      {{"none", topology::Verify::none},
       {"touched", topology::Verify::touched},
       {"all", topology::Verify::all}},
      "Verify nothing (none), what the cut touched (touched, default), or everything and "
      "certify the result (all)")
      ->option_text("WHAT");
  cut->add_option("--json", options->json, "Write the report to this file; - is standard output")
      ->option_text("FILE");
  cut->add_option("--certificate", options->certificate,
                  "Write the cells before and after and the facets, for `cleave certify`; - is "
                  "standard output")
      ->option_text("FILE");
  cut->add_flag("--quiet", options->quiet, "No progress bar and no summary");
  cut->footer(
      "Exit status: 0 done; 1 a facet stays shut and --require-open is given; 2 wrong usage;\n"
      "3 the input is missing, unreadable or invalid for the request, nothing is written;\n"
      "4 a defect of cleave.\n"
      "Examples:\n"
      "  cleave cut fault.msh -o open.msh --group fault\n"
      "  cleave cut liver.mesh -o cut.vtu --sweep blade.json --json report.json\n"
      "  cleave cut open.msh -o more.msh --group branch       (cut before: goes on from its "
      "record)\n"
      "  cleave cut liver.mesh --facets seam.json --dry-run --explain --fix-it more.json");
  const auto* ties = cut->get_option("--ties");
  cut->callback([options, out, dry_run, ties, &chosen] {
    if (out->count() == 0 && dry_run->count() == 0)
      throw CLI::RequiredError("-o OUT (or --dry-run)");
    const CutOptions& o = *options;
    require_sense(o, ties->count() > 0);
    std::vector<std::string> files{o.mesh,
                                   o.out,
                                   o.sweep,
                                   groups_path(o.mesh).string(),
                                   groups_path(o.out).string(),
                                   record_path(o.mesh).string(),
                                   record_path(o.out).string()};
    files.insert(files.end(), o.facets.begin(), o.facets.end());
    refuse_report_onto(o.json, files);
    files.push_back(o.json);
    refuse_report_onto(o.fix_it, files, "--fix-it");
    files.push_back(o.fix_it);
    refuse_certificate(o.certificate, files, o.json);
    chosen = [options] { return run_cut(*options); };
  });
}

}  // namespace cleave::app
