#include "stitch_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "cleave/topology/pieces.hpp"
#include "cut_files.hpp"
#include "cut_state.hpp"
#include "error.hpp"
#include "file_words.hpp"
#include "requested.hpp"

namespace cleave::app {
namespace {

using topology::FacetSet;
using topology::HalfFacetId;

std::string names_asked_for(const std::set<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

// The names of the request, as they were asked for at the cut.
template <int D>
std::set<std::string> leaving_names(const CutState<D>& state, const StitchOptions& options) {
  std::set<std::string> known, leaving;
  for (const NamedFacets& named : state.asked()) known.insert(named.name);
  for (const std::string& name : options.groups) {
    const std::string sheet = sheet_name(state, name);
    if (known.count(sheet) == 0)
      throw InputError(fmt::format("{}: no facets were cut by the name {}; the names are: {}",
                                   options.mesh, name, names_asked_for(known)));
    leaving.insert(sheet);
  }
  return leaving;
}

// The scored facets to be taken back. The names of the request are forgotten: what another name
// asks for, too, stays scored by that one alone.
template <int D>
FacetSet taken_back(const CutSource& source, const StitchOptions& options, CutState<D>& state,
                    StitchResult& result) {
  if (options.all) return state.incision.scored();
  const FacetSet scored = state.incision.scored();
  const std::set<std::string> leaving = leaving_names(state, options);
  FacetSet taken = state.only_in(leaving);
  for (const std::string& name : leaving) state.groups.erase(name);
  if (leaving.count("cut") != 0) state.others = FacetSet();
  if (options.facets.empty()) return taken;
  const auto named = facets_in<D>(source, options.facets);
  const SortedOut sorted = sort_out(state.body.complex, std::span<const HalfFacetId>(named));
  const FacetSet found = sorted.interior & scored;
  result.report.not_scored = sorted.interior.size() - found.size() + sorted.boundary.size();
  if (result.report.not_scored > 0)
    result.warnings.push_back(fmt::format(
        "{}: {} never cut and left alone", options.mesh,
        counted(result.report.not_scored, "facet asked for was", "facets asked for were")));
  return taken | found;
}

// Which vertices of `before` ceased to be: of those that become one vertex, the one with the least
// corner stays. `number` has the number in OUT of each place in `after`.
std::vector<StitchReport::Merge> merges(const Mesh& before, const Mesh& after,
                                        const std::vector<std::uint64_t>& number) {
  constexpr Index kNone = topology::kNoIndex;
  std::vector<Index> stays(after.points.size(), kNone);
  std::vector<bool> seen(before.points.size());
  std::vector<StitchReport::Merge> merges;
  const auto &from = before.cells().vertices, &to = after.cells().vertices;
  for (std::size_t c = 0; c < from.size(); ++c) {
    if (seen[from[c]]) continue;
    seen[from[c]] = true;
    if (stays[to[c]] == kNone)
      stays[to[c]] = from[c];
    else
      merges.push_back({before.vertex_numbers[from[c]], number[to[c]]});
  }
  std::sort(merges.begin(), merges.end(),
            [](const auto& a, const auto& b) { return a.vertex < b.vertex; });
  return merges;
}

std::vector<std::uint64_t> numbers_in(const Mesh& mesh, const std::string& path) {
  const Numbering numbering = numbering_of(path);
  std::vector<std::uint64_t> numbers = mesh.vertex_numbers;
  for (std::size_t i = 0; i < numbers.size() && numbering != Numbering::kept; ++i)
    numbers[i] = numbering == Numbering::from_one ? i + 1 : i;
  return numbers;
}

// Nothing is left of the cut: the result is the original itself. If that is not cut-regular it is
// no result of a cut: even the empty one separates such vertices (T12, the way back).
template <int D>
void give_original_back(const CutSource& source, const StitchOptions& options,
                        const CutState<D>& state, StitchResult& result) {
  result.mesh = source.original();
  std::set<std::uint64_t> joining;
  for (const auto& split : state.body.regularized) joining.insert(state.body.number(split.vertex));
  if (joining.empty()) return;
  const std::string again = fmt::format(
      "nothing is left of the cut, so {} is the mesh from before it, in which {} parts "
      "that have no facet in common (such as {})",
      options.out.empty() ? "the result" : options.out,
      counted(joining.size(), "vertex joins", "vertices join"), *joining.begin());
  if (!options.certificate.empty())
    throw InputError(
        fmt::format("{}: {}; that is no result of a cut, which separates them, so there is no "
                    "certificate of it: leave --certificate out",
                    options.mesh, again));
  result.warnings.push_back(options.mesh + ": " + again);
}

template <int D>
StitchResult stitch_cells(const CutSource& source, const StitchOptions& options,
                          Progress& progress) {
  StitchResult result;
  StitchReport& report = result.report;
  const std::string& target = options.out.empty() ? options.mesh : options.out;
  progress.stage("looking at the cells");
  CutState<D> state(source.original(), progress.within_stage());
  resume(state, source);
  if (!options.out.empty()) require_format(target, state.cohesive && !options.all);
  report.pieces_before = topology::pieces(state.incision.complex()).count;
  const FacetSet taken = taken_back(source, options, state, result);
  const FacetSet was_shut = state.incision.shut();
  report.requested = taken.size();
  report.closed = (taken - was_shut).size();

  progress.stage("stitching");
  state.incision.stitch(taken, options.verify);
  state.others = state.others - taken;
  report.pieces_after = topology::pieces(state.incision.complex()).count;
  for (const HalfFacetId h : (state.incision.shut() - was_shut).half_facets())
    report.shut_again.push_back(facet_vertices(source.mesh, h));
  report.opened = state.incision.opened().size();
  report.shut = state.incision.shut().size();

  progress.stage("naming what is open");
  const bool whole = report.opened + report.shut == 0;
  if (whole) {
    give_original_back(source, options, state, result);
  } else {
    CutOutput output = output_of(state, numbering_of(target));
    result.record = record_of(state, output, target);
    for (const std::string& warning : output.warnings)
      result.warnings.push_back(options.mesh + ": " + warning);
    result.mesh = std::move(output.mesh);
  }
  if (options.verify == topology::Verify::all && !(whole && !state.body.regularized.empty()))
    certify(state, result.mesh);
  if (!options.certificate.empty()) result.certificate = certificate_of(state, result.mesh, target);
  report.cells = source.mesh.cells().size();
  report.vertices_before = source.mesh.points.size();
  report.vertices_after = result.mesh.points.size();
  report.merges = merges(source.mesh, result.mesh, numbers_in(result.mesh, target));
  return result;
}

}  // namespace

StitchResult stitch_mesh(const CutSource& source, const StitchOptions& options,
                         Progress& progress) {
  if (!source.record)
    throw InputError(
        fmt::format("{}: there is no {} beside it, so nothing is known of an earlier cut; {}",
                    options.mesh, record_path(options.mesh).string(),
                    looks_cut(source.mesh)
                        ? "the mesh looks cut before: restore the file, and keep the two together"
                        : "`cleave cut` writes one with the mesh"));
  if (source.mesh.dimension == 1) return stitch_cells<1>(source, options, progress);
  if (source.mesh.dimension == 2) return stitch_cells<2>(source, options, progress);
  return stitch_cells<3>(source, options, progress);
}

}  // namespace cleave::app
