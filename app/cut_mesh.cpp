#include "cut_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "cleave/cutting/stroke.hpp"
#include "cleave/topology/check.hpp"
#include "cleave/topology/fix_it.hpp"
#include "cohesive.hpp"
#include "cut_files.hpp"
#include "cut_request.hpp"
#include "cut_state.hpp"
#include "error.hpp"
#include "file_words.hpp"
#include "reproducer.hpp"
#include "requested.hpp"

namespace cleave::app {
namespace {

using topology::FacetSet;
using topology::HalfFacetId;
using topology::VertexId;

// Says which vertices were not cut-regular; with --strict that is the end.
template <int D>
void report_regularized(const Body<D>& body, const CutOptions& options, CutResult& result) {
  std::set<std::uint64_t> vertices;
  for (const auto& split : body.regularized) vertices.insert(body.number(split.vertex));
  if (vertices.empty()) return;
  const std::string which = listed({vertices.begin(), vertices.end()});
  const std::string found = fmt::format("{}: {} not cut-regular", options.mesh,
                                        counted(vertices.size(), "vertex is", "vertices are"));
  if (options.strict)
    throw InputError(
        fmt::format("{}: {}; mend the mesh, or leave out --strict to give each of "
                    "their parts a copy",
                    found, which));
  result.warnings.push_back(fmt::format("{}; the parts of their cells are separated by {}: {}",
                                        found, counted(body.regularized.size(), "copy", "copies"),
                                        which));
}

// One point per vertex of the incision's complex, copies at the places of their originals.
template <int D>
std::vector<cutting::Point<D>> rest_points(const CutState<D>& state) {
  auto points = points_of(state.body);
  const auto originals = static_cast<Index>(points.size());
  points.resize(state.incision.complex().vertex_count());
  for (Index v = originals; v < points.size(); ++v)
    if (state.incision.complex().a_corner(VertexId{v}))
      points[v] = points[state.incision.original(VertexId{v}).value];
  return points;
}

// The interior facets that --keep excludes.
template <int D>
FacetSet facets_to_keep(const CutSource& source, const CutOptions& options,
                        const CutState<D>& state) {
  std::vector<HalfFacetId> kept;
  for (const std::string& name : options.keep) {
    const auto facets = facets_of_group<D>(source, name);
    kept.insert(kept.end(), facets.begin(), facets.end());
  }
  return sort_out(state.body.complex, std::span<const HalfFacetId>(kept)).interior;
}

// One request, made in a state.
template <int D>
class Cutting {
 public:
  Cutting(const CutSource& source, const CutOptions& options, CutState<D>& state, CutResult& result)
      : source_(source), options_(options), state_(state), result_(result) {}

  // Scores what is asked for, but for `keep`. `attempted` is the last set that was cut along, or
  // began to be.
  void run(const FacetSet& keep, FacetSet& attempted) {
    cut_named(keep, attempted);
    if (!options_.sweep.empty()) sweep(keep);
  }

 private:
  static void append(std::vector<HalfFacetId>& to, const std::vector<HalfFacetId>& more) {
    to.insert(to.end(), more.begin(), more.end());
  }

  SortedOut interior(const std::vector<HalfFacetId>& facets) const {
    return sort_out(state_.body.complex, std::span<const HalfFacetId>(facets));
  }

  void warn(std::string text) { result_.warnings.push_back(std::move(text)); }

  // By number, group or --all.
  void cut_named(const FacetSet& keep, FacetSet& attempted) {
    std::vector<HalfFacetId> facets, others;
    for (const std::string& name : std::set(options_.groups.begin(), options_.groups.end())) {
      if (made_by_cut(source_, name)) {
        warn(
            fmt::format("{}: the group {} is what an earlier cut made; its facets are scored "
                        "already",
                        options_.mesh, name));
        continue;
      }
      facets_of_group<D>(source_, name);  // refuses an unknown name in the words of MESH
      state_.name(name);
      append(facets, state_.groups.at(name));
    }
    for (const std::string& file : options_.facets) append(others, facets_in<D>(source_, file));
    if (options_.all) append(others, FacetSet::all(state_.body.complex).half_facets());
    append(facets, others);
    if (facets.empty() && options_.sweep.empty()) warn(options_.mesh + ": no facet was asked for");

    const SortedOut sorted = interior(facets);
    result_.report.not_interior = sorted.boundary.size();
    if (!sorted.boundary.empty())
      warn(
          fmt::format("{}: {} on the boundary already and left alone, such as ({})", options_.mesh,
                      counted(sorted.boundary.size(), "facet asked for is", "facets asked for are"),
                      listed(facet_vertices(source_.mesh, sorted.boundary.front()))));
    result_.report.kept = (sorted.interior & keep).size();
    attempted = sorted.interior - keep;
    state_.incision.cut(attempted, options_.verify);
    state_.others = state_.others | (interior(others).interior - keep);
  }

  void sweep(const FacetSet& keep) {
    if constexpr (D == 1) {
      throw InputError(options_.mesh +
                       ": nothing can be swept through edges; use --facets, --group or --all");
    } else {
      const auto sweep = read_sweep<D>(options_.sweep);
      auto points = rest_points(state_);
      const auto stroke = cutting::cut_along(state_.incision, points, sweep, options_.select,
                                             options_.verify, keep);
      if (stroke.scored.empty() && stroke.excepted.empty())
        warn((options_.sweep == "-" ? "standard input" : options_.sweep) +
             ": the sweep selects no facet; does it meet the body? Its coordinates are those of "
             "the mesh");
      result_.report.kept += stroke.excepted.size();
      state_.others = state_.others | stroke.scored;
    }
  }

  const CutSource& source_;
  const CutOptions& options_;
  CutState<D>& state_;
  CutResult& result_;
};

// Cuts what else must be cut for the level that is asked for; refuses to cut what is to be kept.
template <int D>
void cut_to_reach(const CutSource& source, const CutOptions& options, const FacetSet& keep,
                  CutState<D>& state, FacetSet& attempted, CutResult& result) {
  if (!options.require || !options.require_by_cutting) return;
  const FacetSet further =
      topology::facets_to_reach(state.incision.complex(), state.incision.shut(), *options.require);
  const FacetSet kept = further & keep;
  if (!kept.empty())
    throw InputError(fmt::format(
        "{}: to reach the level of --require, --require-by cutting would cut {} that --keep "
        "excludes: {}; leave their groups out of --keep, or require a lower level; nothing is "
        "written",
        options.mesh, counted(kept.size(), "facet"),
        facets_listed(facets_vertices(source.mesh, kept))));
  attempted = further;
  state.incision.cut(attempted, options.verify);
  state.others = state.others | attempted;
  for (const HalfFacetId h : attempted.half_facets())
    result.report.added.push_back(facet_vertices(source.mesh, h));
}

// Refuses a result below the level that is asked for, with every witness in the numbers of OUT.
template <int D>
void require_level(const CutOptions& options, const CutState<D>& state, const Mesh& out) {
  if (!options.require) return;
  auto soup = soup_of<D>(out);
  for (Index c = 0; c < soup.cells.size(); ++c)
    soup.signs.push_back(static_cast<std::int8_t>(state.body.complex.sign({c})));
  const auto violations = topology::check(soup, *options.require);
  if (topology::level_reached(D, violations) >= *options.require) return;
  std::string text = options.mesh + ": after this cut the mesh is below the level of --require:";
  for (const auto& violation : violations) text += "\n  " + describe_in_file(violation, out);
  throw InputError(text +
                   "\nnothing is written (copies would have these numbers); --require-by cutting "
                   "cuts further facets until the level is reached");
}

void warn_of_output(const CutSource& source, const CutOutput& output, CutResult& result) {
  for (const std::string& warning : output.warnings)
    result.warnings.push_back(source.mesh.source + ": " + warning);
  for (const OneSidedSheet& sheet : output.one_sided)
    result.warnings.push_back(fmt::format(
        "{}: the facets of {} form a sheet with one side only; its minus and plus sides change "
        "places where this loop of {} facets closes, at facet ({})",
        source.mesh.source, sheet.name, sheet.loop.size(),
        listed(facet_vertices(source.mesh, sheet.loop.front()))));
}

template <int D>
CutResult cut_cells(const CutSource& source, const CutOptions& options, Progress& progress) {
  CutResult result;
  progress.stage("looking at the cells");
  CutState<D> state(source.original(), progress.within_stage());
  report_regularized(state.body, options, result);
  resume(state, source);
  if (source.record)
    result.report.earlier =
        CutReport::Earlier{source.record->opened.size(), source.record->shut.size()};
  state.cohesive = state.cohesive || options.cohesive;
  if (options.offset) state.offset = *options.offset;
  if (state.cohesive && state.offset > 0)
    throw InputError(
        options.mesh +
        (options.offset
             ? ": its record has cohesive elements between the sides, which --offset would give a "
               "thickness; cut the original again, or leave it out"
             : fmt::format(": its record moves the sides apart by {:g}; give --offset 0 with "
                           "--cohesive, whose elements have no thickness",
                           state.offset)));
  if (state.cohesive) {
    require_cohesive(source.original());
    if (!options.out.empty()) require_format(options.out, true);
  }
  const FacetSet keep = facets_to_keep(source, options, state);
  FacetSet attempted;
  CutOutput output;
  try {
    progress.stage("cutting");
    Cutting<D>(source, options, state, result).run(keep, attempted);
    cut_to_reach(source, options, keep, state, attempted, result);
    progress.stage("naming what opened");
    const std::string& target = options.out.empty() ? options.mesh : options.out;
    output = output_of(state, numbering_of(target));
    if (options.verify == topology::Verify::all) certify(state, output.mesh);
    require_level(options, state, output.mesh);
    if (!options.certificate.empty())
      result.certificate = certificate_of(state, output.mesh, target);
    if (!options.dry_run) result.record = record_of(state, output, target);
  } catch (const topology::InvariantBroken& e) {
    const auto path = (options.out.empty() ? "cleave" : options.out) + ".reproducer.json";
    write_reproducer(path, state.body.complex, state.incision.scored() | attempted, e.what());
    throw topology::InvariantBroken(
        fmt::format("{}; {} has the cells and the facets", e.what(), path));
  }
  warn_of_output(source, output, result);
  progress.stage("looking at the result");
  fill_report(state, source.mesh, output, Wanted{options.explain, !options.fix_it.empty(), keep},
              result.report);
  result.mesh = std::move(output.mesh);
  return result;
}

}  // namespace

CutResult cut_mesh(const CutSource& source, const CutOptions& options, Progress& progress) {
  if (source.mesh.dimension == 1) return cut_cells<1>(source, options, progress);
  if (source.mesh.dimension == 2) return cut_cells<2>(source, options, progress);
  return cut_cells<3>(source, options, progress);
}

}  // namespace cleave::app
