#include "cut_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cleave/topology/check.hpp"
#include "cleave/topology/explain.hpp"
#include "cleave/topology/fix_it.hpp"
#include "cleave/topology/pieces.hpp"
#include "file_words.hpp"

namespace cleave::app {

using topology::FacetSet;
using topology::VertexId;

namespace {

// What level the cells reach after the cut, looked at afresh.
template <int D>
void check_result(const topology::Complex<D>& k, CutReport& report) {
  topology::CellSoup<D> soup{{k.cells().begin(), k.cells().end()}, k.vertex_count(), {}};
  for (Index c = 0; c < k.cell_count(); ++c)
    soup.signs.push_back(static_cast<std::int8_t>(k.sign({c})));
  const auto violations = topology::check(soup, topology::Level::edge_regular);
  report.cut_regular = topology::level_reached(D, violations) >= topology::Level::cut_regular;
  for (const auto& violation : violations)
    if (std::holds_alternative<topology::PinchedSimplex>(violation)) ++report.pinched_edges;
}

template <int D>
void list_copies(const CutState<D>& state, const Shown<D>& shown, const CutOutput& output,
                 CutReport& report) {
  const auto number = shown.by_place();
  for (const VertexId v : output.vertex_at) {
    if (v == kNoVertex || v.value < state.body.mesh->points.size()) continue;
    const CutReport::Copy copy{output.number_of[v.value],
                               number[state.body.place(state.incision.original(v))]};
    (v.value < state.incision.original_vertex_count() ? report.regularized : report.splits)
        .push_back(copy);
  }
}

// How many nodes of second order copy another one.
std::size_t copied_nodes(const CutOutput& output) {
  std::vector<Index> origins;
  for (std::size_t i = 0; i < output.origin.size(); ++i)
    if (output.vertex_at[i] == kNoVertex) origins.push_back(output.origin[i]);
  std::sort(origins.begin(), origins.end());
  const auto distinct = std::unique(origins.begin(), origins.end()) - origins.begin();
  return origins.size() - static_cast<std::size_t>(distinct);
}

// The smallest set that opens one shut facet; nothing is offered if it has facets of `keep`.
template <int D>
CutReport::Fix fix_of(const CutState<D>& state, topology::HalfFacetId h, const FacetSet& keep,
                      const Mesh& shown) {
  const auto& incision = state.incision;
  const FacetSet further = topology::separating_facets(incision.complex(), incision.shut(), h);
  const FacetSet kept = further & keep;
  if (kept.empty()) return {facets_vertices(shown, further), true, {}};
  return {{}, false, facets_vertices(shown, kept)};
}

// The same for all shut facets. If that takes facets of `keep`, what is offered opens those of them
// whose own smallest sets have none.
template <int D>
CutReport::Fix fix_of_all(const CutState<D>& state, const FacetSet& keep, const Mesh& shown) {
  const auto& k = state.incision.complex();
  const FacetSet shut = state.incision.shut();
  const FacetSet further = topology::separating_facets(k, shut, shut.half_facets());
  const FacetSet kept = further & keep;
  if (kept.empty()) return {facets_vertices(shown, further), shut.size() <= 1, {}};
  FacetSet offered;
  for (const auto h : shut.half_facets()) {
    const FacetSet own = topology::separating_facets(k, shut, h);
    if ((own & keep).empty()) offered = offered | own;
  }
  return {facets_vertices(shown, offered), false, facets_vertices(shown, kept)};
}

template <int D>
CutReport::Shut shut_facet(const CutState<D>& state, const Shown<D>& shown, topology::HalfFacetId h,
                           const Wanted& wanted) {
  CutReport::Shut shut{facet_vertices(shown.mesh(), h), {}, std::nullopt};
  const auto& incision = state.incision;
  if (wanted.opened) shut.fix = fix_of(state, h, wanted.keep, shown.mesh());
  for (const auto& because : topology::explain(incision.complex(), incision.shut(), h)) {
    auto& reason = shut.because.emplace_back();
    reason.vertex = shown.vertex(h, incision.original(because.vertex));
    for (const auto cell : because.through)
      reason.through.push_back(cell_number(shown.mesh(), cell));
  }
  return shut;
}

}  // namespace

template <int D>
void fill_report(const CutState<D>& state, const Mesh& mesh, const CutOutput& output,
                 const Wanted& wanted, CutReport& report) {
  const Shown<D> shown(state.body, mesh);
  const auto& after = state.incision.complex();
  const auto opened = state.incision.opened();
  report.cells = after.cell_count();
  report.edge_nodes_after = static_cast<std::size_t>(
      std::count(output.vertex_at.begin(), output.vertex_at.end(), kNoVertex));
  report.vertices_after = output.vertex_at.size() - report.edge_nodes_after;
  report.edge_nodes_before = report.edge_nodes_after - copied_nodes(output);
  report.cohesive = output.mesh.cohesive.size();
  report.opened = opened.size();
  report.shut = state.incision.shut().size();
  report.requested = report.opened + report.shut;
  report.pieces_before = topology::pieces(state.body.complex).count;
  report.pieces_after = topology::pieces(after).count;
  check_result(after, report);
  list_copies(state, shown, output, report);
  report.vertices_before = report.vertices_after - report.regularized.size() - report.splits.size();

  const FacetSet shut = state.incision.shut();
  for (const auto h : shut.half_facets())
    report.shut_facets.push_back(shut_facet(state, shown, h, wanted));
  if (wanted.fix) report.fix = fix_of_all(state, wanted.keep, mesh);
  if (wanted.opened) {
    report.opened_facets.emplace();
    for (const auto& facet : opened)
      report.opened_facets->push_back(
          {facet_vertices(mesh, facet.half_facet), shown.vertex(facet.half_facet, facet.by)});
  }
  for (const OneSidedSheet& sheet : output.one_sided) {
    auto& one_sided = report.one_sided.emplace_back();
    one_sided.name = sheet.name;
    for (const auto h : sheet.loop) one_sided.loop.push_back(facet_vertices(mesh, h));
  }
}

namespace {

std::string fix_text(const CutReport& report) {
  if (report.shut == 0) return "nothing is shut";
  const std::string more = counted(report.fix->facets.size(), "facet") + " more would open what is";
  if (report.fix->kept.empty()) return more + " shut";
  return fmt::format("{} shut, as far as they do without facets of --keep, such as: {}", more,
                     facets_listed(report.fix->kept));
}

std::string fix_text(const CutReport::Fix& fix) {
  if (fix.kept.empty()) return "would open with: " + facets_listed(fix.facets);
  return "the smallest set that would open it has facets of --keep, so none is offered: " +
         facets_listed(fix.kept);
}

}  // namespace

std::string text_of(const CutReport& report, const std::string& source, bool explain) {
  std::string text = fmt::format(
      "{}: {}: {} opened, {} shut{}{}{}; pieces {} -> {}; vertices {} -> {}; {}cells {}{}\n",
      source, counted(report.requested, "facet"), report.opened, report.shut,
      report.earlier
          ? fmt::format(" ({} and {} before)", report.earlier->opened, report.earlier->shut)
          : "",
      report.not_interior == 0 ? "" : fmt::format(", {} on the boundary", report.not_interior),
      report.kept == 0 ? "" : fmt::format(", {} kept", report.kept), report.pieces_before,
      report.pieces_after, report.vertices_before, report.vertices_after,
      report.edge_nodes_before == 0
          ? ""
          : fmt::format("nodes on edges {} -> {}; ", report.edge_nodes_before,
                        report.edge_nodes_after),
      report.cells,
      report.cohesive == 0 ? "" : fmt::format("; cohesive elements {}", report.cohesive));
  if (!report.added.empty())
    text += fmt::format("{}: cut besides, to reach the level: {}\n", source,
                        facets_listed(report.added));
  if (report.fix) text += fmt::format("{}: {}\n", source, fix_text(report));
  if (report.shut > 0 && !explain)
    text += fmt::format("{}: --explain says why facets stay shut\n", source);
  if (!explain) return text;
  for (const auto& shut : report.shut_facets) {
    text += fmt::format("{}: facet ({}) is shut: no vertex of it separates its sides\n", source,
                        listed(shut.facet));
    for (const auto& because : shut.because)
      text += fmt::format("  around vertex {} the sides are joined through cells {}\n",
                          because.vertex, listed(because.through));
    if (shut.fix) text += "  " + fix_text(*shut.fix) + "\n";
  }
  if (report.opened_facets)
    for (const auto& opened : *report.opened_facets)
      text += fmt::format("{}: facet ({}) opened by vertex {}\n", source, listed(opened.facet),
                          opened.by);
  return text;
}

template void fill_report<1>(const CutState<1>&, const Mesh&, const CutOutput&, const Wanted&,
                             CutReport&);
template void fill_report<2>(const CutState<2>&, const Mesh&, const CutOutput&, const Wanted&,
                             CutReport&);
template void fill_report<3>(const CutState<3>&, const Mesh&, const CutOutput&, const Wanted&,
                             CutReport&);

}  // namespace cleave::app
