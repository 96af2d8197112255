#include "cut_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "cleave/cutting/stroke.hpp"
#include "cleave/topology/certify.hpp"
#include "cohesive.hpp"
#include "cut_request.hpp"
#include "error.hpp"
#include "file_words.hpp"
#include "offset.hpp"
#include "reproducer.hpp"

namespace cleave::app {
namespace {

using topology::FacetSet;
using topology::HalfFacetId;

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

// The facets asked for by name, number or --all.
template <int D>
std::vector<NamedFacets> requested_facets(const Body<D>& body, const CutOptions& options) {
  const Mesh& mesh = *body.mesh;
  if (options.all) {
    const FacetSet all = FacetSet::all(body.complex);
    return {{"cut", {all.half_facets().begin(), all.half_facets().end()}, nullptr}};
  }
  if (!options.facets.empty())
    return {{"cut", locate(body, read_facets(options.facets, mesh), options.facets), nullptr}};
  std::vector<NamedFacets> asked;
  for (const std::string& name : std::set(options.groups.begin(), options.groups.end())) {
    const Group& group = facet_group(mesh, name);
    asked.push_back(
        {name, locate(body, vertices_of(mesh, group), fmt::format("group \"{}\"", name)), &group});
  }
  return asked;
}

template <int D>
NamedFacets sweep_through(const Body<D>& body, const CutOptions& options,
                          topology::Incision<D>& incision, CutResult& result) {
  if constexpr (D == 1) {
    throw InputError(options.mesh +
                     ": nothing can be swept through edges; use --facets, --group or "
                     "--all");
  } else {
    const auto sweep = read_sweep<D>(options.sweep);
    auto points = points_of(body);
    const auto stroke = cutting::cut_along(incision, points, sweep, options.select, options.verify);
    if (stroke.scored.empty())
      result.warnings.push_back(options.sweep +
                                ": the sweep selects no facet; does it meet the "
                                "body? Its coordinates are those of the mesh");
    return {
        "cut", {stroke.scored.half_facets().begin(), stroke.scored.half_facets().end()}, nullptr};
  }
}

// Scores what is asked for; fills in how many facets that were. `attempted` is the last set that
// was cut along, or began to be.
template <int D>
std::vector<NamedFacets> cut(const Body<D>& body, const CutOptions& options,
                             topology::Incision<D>& incision, FacetSet& attempted,
                             CutResult& result) {
  if (!options.sweep.empty()) {
    auto swept = sweep_through(body, options, incision, result);
    result.report.requested = swept.facets.size();
    return {std::move(swept)};
  }
  auto asked = requested_facets(body, options);
  std::vector<HalfFacetId> facets;
  for (const NamedFacets& named : asked)
    facets.insert(facets.end(), named.facets.begin(), named.facets.end());
  const SortedOut sorted = sort_out(body.complex, std::span<const HalfFacetId>(facets));
  result.report.requested = sorted.interior.size();
  result.report.not_interior = sorted.boundary.size();
  if (!sorted.boundary.empty())
    result.warnings.push_back(
        fmt::format("{}: {} on the boundary already and left alone, such as ({})", options.mesh,
                    counted(sorted.boundary.size(), "facet asked for is", "facets asked for are"),
                    listed(facet_vertices(*body.mesh, sorted.boundary.front()))));
  if (facets.empty()) result.warnings.push_back(options.mesh + ": no facet was asked for");
  attempted = sorted.interior;
  incision.cut(sorted.interior, options.verify);
  return asked;
}

// Certifies that the cells of OUT are those of MESH unglued along the scored facets and nothing
// else (T11: from the file as it was, regularisation included).
template <int D>
void certify_output(const Body<D>& body, const topology::Incision<D>& incision, const Mesh& out) {
  const auto before = soup_of<D>(*body.mesh), after = soup_of<D>(out);
  const FacetSet scored = incision.scored();
  const auto rejection = topology::certify<D>(before.cells, scored.half_facets(), after.cells);
  if (rejection) throw topology::InvariantBroken("not certified: " + describe(*rejection));
}

template <int D>
CutResult cut_cells(const Mesh& mesh, const CutOptions& options, Progress& progress) {
  CutResult result;
  progress.stage("looking at the cells");
  const Body<D> body = make_body<D>(mesh);
  report_regularized(body, options, result);
  topology::Incision<D> incision(body.complex);
  FacetSet attempted;
  CutOutput output;
  try {
    progress.stage("cutting");
    const auto asked = cut(body, options, incision, attempted, result);
    progress.stage("naming what opened");
    output = cut_output(body, incision, asked,
                        numbering_of(options.out.empty() ? options.mesh : options.out));
    if constexpr (D >= 2)
      if (options.cohesive) add_cohesive(body, output);
    if (options.offset > 0) move_sides(body, incision, options.offset, output);
    if (options.verify == topology::Verify::all) certify_output(body, incision, output.mesh);
  } catch (const topology::InvariantBroken& e) {
    const auto path = (options.out.empty() ? "cleave" : options.out) + ".reproducer.json";
    write_reproducer(path, body.complex, incision.scored() | attempted, e.what());
    throw topology::InvariantBroken(
        fmt::format("{}; {} has the cells and the facets", e.what(), path));
  }
  for (const std::string& warning : output.warnings)
    result.warnings.push_back(options.mesh + ": " + warning);
  for (const OneSidedSheet& sheet : output.one_sided)
    result.warnings.push_back(fmt::format(
        "{}: the facets of {} form a sheet with one side only; its minus and plus sides change "
        "places where this loop of {} facets closes, at facet ({})",
        options.mesh, sheet.name, sheet.loop.size(),
        listed(facet_vertices(mesh, sheet.loop.front()))));
  progress.stage("looking at the result");
  auto report = report_on(body, incision, output, options.explain);
  report.requested = result.report.requested;
  report.not_interior = result.report.not_interior;
  result.report = std::move(report);
  result.mesh = std::move(output.mesh);
  return result;
}

}  // namespace

CutResult cut_mesh(const Mesh& mesh, const CutOptions& options, Progress& progress) {
  if (options.cohesive) require_cohesive(mesh);
  if (mesh.dimension == 1) return cut_cells<1>(mesh, options, progress);
  if (mesh.dimension == 2) return cut_cells<2>(mesh, options, progress);
  return cut_cells<3>(mesh, options, progress);
}

}  // namespace cleave::app
