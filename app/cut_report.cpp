#include "cut_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cleave/topology/check.hpp"
#include "cleave/topology/explain.hpp"
#include "cleave/topology/pieces.hpp"
#include "file_words.hpp"

namespace cleave::app {

using topology::Incision;
using topology::VertexId;

namespace {

// What level the cells reach after the cut, looked at afresh.
template <int D>
void check_result(const topology::Complex<D>& k, CutReport& report) {
  topology::CellSoup<D> soup{{k.cells().begin(), k.cells().end()}, k.vertex_count(), {}};
  for (std::uint32_t c = 0; c < k.cell_count(); ++c)
    soup.signs.push_back(static_cast<std::int8_t>(k.sign({c})));
  const auto violations = topology::check(soup, topology::Level::edge_regular);
  report.cut_regular = topology::level_reached(D, violations) >= topology::Level::cut_regular;
  for (const auto& violation : violations)
    if (std::holds_alternative<topology::PinchedSimplex>(violation)) ++report.pinched_edges;
}

template <int D>
void list_copies(const Body<D>& body, const Incision<D>& incision, const CutOutput& output,
                 CutReport& report) {
  for (const VertexId v : output.vertex_at) {
    if (v == kNoVertex) continue;
    const CutReport::Copy copy{output.number_of[v.value], body.number(incision.original(v))};
    if (v.value < body.mesh->points.size()) continue;
    (v.value < incision.original_vertex_count() ? report.regularized : report.splits)
        .push_back(copy);
  }
}

// How many nodes of second order copy another one.
std::size_t copied_nodes(const CutOutput& output) {
  std::vector<std::uint32_t> origins;
  for (std::size_t i = 0; i < output.origin.size(); ++i)
    if (output.vertex_at[i] == kNoVertex) origins.push_back(output.origin[i]);
  std::sort(origins.begin(), origins.end());
  const auto distinct = std::unique(origins.begin(), origins.end()) - origins.begin();
  return origins.size() - static_cast<std::size_t>(distinct);
}

}  // namespace

template <int D>
CutReport report_on(const Body<D>& body, const Incision<D>& incision, const CutOutput& output,
                    bool with_opened) {
  const Mesh& mesh = *body.mesh;
  const auto& after = incision.complex();
  CutReport report;
  report.cells = after.cell_count();
  report.edge_nodes_after = static_cast<std::size_t>(
      std::count(output.vertex_at.begin(), output.vertex_at.end(), kNoVertex));
  report.vertices_after = output.vertex_at.size() - report.edge_nodes_after;
  report.edge_nodes_before = report.edge_nodes_after - copied_nodes(output);
  report.cohesive = output.mesh.cohesive.size();
  report.opened = incision.opened().size();
  report.shut = incision.shut().size();
  report.pieces_before = topology::pieces(body.complex).count;
  report.pieces_after = topology::pieces(after).count;
  check_result(after, report);
  list_copies(body, incision, output, report);
  report.vertices_before = report.vertices_after - report.regularized.size() - report.splits.size();

  for (const auto h : incision.shut().half_facets()) {
    auto& shut = report.shut_facets.emplace_back();
    shut.facet = facet_vertices(mesh, h);
    for (const auto& because : topology::explain(after, incision.shut(), h)) {
      auto& reason = shut.because.emplace_back();
      reason.vertex = body.number(incision.original(because.vertex));
      for (const auto cell : because.through) reason.through.push_back(cell_number(mesh, cell));
    }
  }
  if (with_opened) {
    report.opened_facets.emplace();
    for (const auto& opened : incision.opened())
      report.opened_facets->push_back(
          {facet_vertices(mesh, opened.half_facet), body.number(opened.by)});
  }
  for (const OneSidedSheet& sheet : output.one_sided) {
    auto& one_sided = report.one_sided.emplace_back();
    one_sided.name = sheet.name;
    for (const auto h : sheet.loop) one_sided.loop.push_back(facet_vertices(mesh, h));
  }
  return report;
}

std::string text_of(const CutReport& report, const std::string& source, bool explain) {
  std::string text = fmt::format(
      "{}: {}: {} opened, {} shut{}; pieces {} -> {}; vertices {} -> {}; {}cells {}{}\n", source,
      counted(report.requested, "facet"), report.opened, report.shut,
      report.not_interior == 0 ? "" : fmt::format(", {} on the boundary", report.not_interior),
      report.pieces_before, report.pieces_after, report.vertices_before, report.vertices_after,
      report.edge_nodes_before == 0
          ? ""
          : fmt::format("nodes on edges {} -> {}; ", report.edge_nodes_before,
                        report.edge_nodes_after),
      report.cells,
      report.cohesive == 0 ? "" : fmt::format("; cohesive elements {}", report.cohesive));
  if (report.shut > 0 && !explain)
    text += fmt::format("{}: --explain says why facets stay shut\n", source);
  if (!explain) return text;
  for (const auto& shut : report.shut_facets) {
    text += fmt::format("{}: facet ({}) is shut: no vertex of it separates its sides\n", source,
                        listed(shut.facet));
    for (const auto& because : shut.because)
      text += fmt::format("  around vertex {} the sides are joined through cells {}\n",
                          because.vertex, listed(because.through));
  }
  if (report.opened_facets)
    for (const auto& opened : *report.opened_facets)
      text += fmt::format("{}: facet ({}) opened by vertex {}\n", source, listed(opened.facet),
                          opened.by);
  return text;
}

template CutReport report_on<1>(const Body<1>&, const Incision<1>&, const CutOutput&, bool);
template CutReport report_on<2>(const Body<2>&, const Incision<2>&, const CutOutput&, bool);
template CutReport report_on<3>(const Body<3>&, const Incision<3>&, const CutOutput&, bool);

}  // namespace cleave::app
