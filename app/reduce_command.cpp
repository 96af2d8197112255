#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "choice.hpp"
#include "commands.hpp"
#include "cut_files.hpp"
#include "cut_output.hpp"
#include "error.hpp"
#include "file_words.hpp"
#include "mesh_file.hpp"
#include "progress.hpp"
#include "reduce_property.hpp"
#include "sub_mesh.hpp"

namespace cleave::app {
namespace {

struct ReduceOptions {
  std::string mesh, out, rule, command;
  CutRequest request;
  CutOutcome outcome = CutOutcome::shut;
  topology::Level required = topology::Level::cut_regular;
  bool quiet = false;

  bool cuts() const { return !request.facets.empty() || !request.groups.empty() || request.all; }
};

std::string facets_path(const std::string& out) { return out + ".facets.json"; }

// The file's number of the vertex at place `place` of a mesh with these numbers.
std::uint64_t number(const Mesh& mesh, Index place, Numbering numbering) {
  if (numbering == Numbering::kept) return mesh.vertex_numbers[place];
  return place + (numbering == Numbering::from_one ? 1U : 0U);
}

// What is left of the request, in the numbers of the reduced mesh as its file has them. Facets
// whose vertices are not all there are left out.
std::string facets_json(const CutProperty& cut, const Candidate& rest, const SubMesh& part,
                        Numbering numbering) {
  auto facets = nlohmann::ordered_json::array();
  for (const Index f : rest.facets) {
    auto facet = nlohmann::ordered_json::array();
    for (const Index v : cut.request[f]) {
      const auto at = std::lower_bound(part.place.begin(), part.place.end(), v);
      if (at == part.place.end() || *at != v) break;
      const auto place = static_cast<Index>(at - part.place.begin());
      facet.push_back(number(part.mesh, place, numbering));
    }
    if (facet.size() == cut.request[f].size()) facets.push_back(std::move(facet));
  }
  return nlohmann::ordered_json{{"facets", std::move(facets)}}.dump() + "\n";
}

int run_reduce(const ReduceOptions& options) {
  format_of(options.out);  // refused before anything is done
  Progress progress(40, options.quiet);
  progress.stage("reading " + options.mesh);
  const Mesh mesh = read_mesh(options.mesh, progress.within_stage());
  progress.clear();
  for (const std::string& warning : mesh.dropped) warn(warning);
  progress.stage("looking for what to keep");
  CutProperty cut;
  if (options.cuts())
    cut = cut_property(mesh, options.request, options.outcome);
  else if (!options.command.empty())
    cut.property = command_property(mesh, options.command, options.out);
  else
    cut.property = finding_property(mesh, options.rule, options.required);

  const Reduction reduction = reduce(mesh, cut.property, [&progress](const Reduction& so_far) {
    progress.stage(
        fmt::format("{}, {} tries", counted(so_far.rest.cells.size(), "cell"), so_far.tries));
  });
  const SubMesh part = sub_mesh(mesh, reduction.rest.cells, reduction.rest.loose);
  progress.stage("writing " + options.out);
  OutputFiles files;  // both appear, or none
  write_mesh(files, options.out, part.mesh);
  remove_record(files, options.out);
  if (options.cuts())
    files.add(facets_path(options.out))
        .write(facets_json(cut, reduction.rest, part, numbering_of(options.out)));
  files.commit();
  progress.clear();
  if (!options.quiet)
    print(fmt::format("{}: {} reduced to {} and {} in {}; kept: {}\n", options.mesh,
                      counted(mesh.cells().size(), "cell"),
                      counted(reduction.rest.cells.size(), "cell"),
                      counted(part.mesh.points.size(), "vertex", "vertices"),
                      counted(reduction.tries, "try", "tries"), cut.property.what));
  return kFine;
}

void add_property(CLI::App& reduce, ReduceOptions& options) {
  auto* what = reduce.add_option_group("What to keep", "at most one of; the first error if none");
  auto* rule = what->add_option("--rule", options.rule,
                                "The first finding of this rule, such as pinched-edge")
                   ->option_text("RULE");
  auto* facets = what->add_option("--facets", options.request.facets,
                                  "What a cut of these facets leaves: JSON {\"facets\": ..}")
                     ->option_text("FILE");
  auto* groups =
      what->add_option("--group", options.request.groups, "What a cut of these facet groups leaves")
          ->option_text("NAME..");
  auto* all =
      what->add_flag("--all", options.request.all, "What a cut of every interior facet leaves");
  auto* command =
      what->add_option("--command", options.command,
                       "The exit status of this shell command, whose {} stands for a mesh file")
          ->option_text("CMD")
          ->check([](const std::string& text) {
            return text.find("{}") == std::string::npos
                       ? std::string("the command must name the mesh: write {} in its place")
                       : std::string();
          });
  what->require_option(0, 1);
  auto* expect = add_choice<CutOutcome>(
      reduce, "--expect", options.outcome,
      {{"shut", CutOutcome::shut}, {"pinched", CutOutcome::pinched}},
      "What the cut leaves: a facet that stays shut (shut, default) or a pinched edge (pinched)");
  expect->option_text("WHAT");
  for (auto* other : {rule, command}) expect->excludes(other);
  add_choice<topology::Level>(reduce, "--require", options.required,
                              {{"pseudo-manifold", topology::Level::pseudo_manifold},
                               {"cut-regular", topology::Level::cut_regular},
                               {"edge-regular", topology::Level::edge_regular},
                               {"manifold", topology::Level::manifold}},
                              "What `cleave check --require LEVEL` calls an error")
      ->option_text("LEVEL")
      ->excludes(facets)
      ->excludes(groups)
      ->excludes(all)
      ->excludes(command);
}

}  // namespace

void add_reduce_command(CLI::App& cleave, Action& chosen) {
  auto* reduce = cleave.add_subcommand(
      "reduce", "Shrinks a failing mesh, or cut, to a small one that fails in the same way");
  auto options = std::make_shared<ReduceOptions>();
  reduce->add_option("MESH", options->mesh, "Mesh file")->required()->option_text("FILE");
  reduce->add_option("-o,--output", options->out, "The mesh to write")
      ->required()
      ->option_text("OUT");
  add_property(*reduce, *options);
  reduce->add_flag("--quiet", options->quiet, "No progress bar and no summary");
  reduce->footer(
      "Without any single one of the cells of OUT the same thing would not be there any more.\n"
      "A cut's facets go to OUT.facets.json. Ctrl-C ends it and writes nothing.\n"
      "Exit status: 0 done; 2 wrong usage; 3 MESH does not show it, or a file cannot be read or "
      "written.\n"
      "Examples:\n"
      "  cleave reduce liver.mesh -o small.mesh\n"
      "  cleave reduce liver.mesh -o small.mesh --rule pinched-edge\n"
      "  cleave reduce fault.msh -o small.msh --group fault --expect shut\n"
      "  cleave reduce part.msh -o small.msh --command 'solver {}'");
  reduce->callback([options, &chosen] {
    if (options->cuts())
      refuse_report_onto(facets_path(options->out), {options->mesh, options->request.facets});
    chosen = [options] { return run_reduce(*options); };
  });
}

}  // namespace cleave::app
