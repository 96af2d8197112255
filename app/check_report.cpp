#include "check_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include "body.hpp"
#include "cleave/topology/betti.hpp"
#include "cleave/topology/check.hpp"
#include "coincident_vertices.hpp"
#include "edge_nodes.hpp"
#include "file_words.hpp"
#include "geometry_check.hpp"

namespace cleave::app {

std::size_t CheckReport::count(Severity severity) const {
  return static_cast<std::size_t>(std::count_if(
      findings.begin(), findings.end(), [&](const Finding& f) { return f.severity == severity; }));
}

namespace {

// About as much work as the rest of the check of three million cells.
constexpr topology::BettiLimits kModerate{12'000'000, 1'000'000'000};

template <int D>
std::optional<std::vector<std::size_t>> holes(const Mesh& mesh, CountHoles when,
                                              std::size_t simplices) {
  if (when == CountHoles::never) return std::nullopt;
  const auto limits = when == CountHoles::always ? topology::BettiLimits{} : kModerate;
  if (simplices > limits.simplices) return std::nullopt;  // without a list of them
  const auto betti = topology::betti_numbers(soup_of<D>(mesh), limits);
  if (!betti) return std::nullopt;
  return std::vector<std::size_t>(betti->begin(), betti->end());
}

// The rules that topology::check does not come to while there are these violations.
std::vector<std::string> undecided_by(const std::vector<topology::Violation>& violations) {
  bool unsound = false, crowded = false;
  for (const auto& violation : violations) {
    const std::string_view rule = topology::rule(violation);
    unsound = unsound || rule == "degenerate-cell" || rule == "vertex-out-of-range";
    crowded = crowded || rule == "duplicate-cell" || rule == "facet-in-three-cells";
  }
  std::vector<std::string> undecided;
  if (unsound) undecided = {"duplicate-cell", "facet-in-three-cells"};
  if (unsound || crowded)
    undecided.insert(undecided.end(), {"orientation-conflict", "non-orientable", "not-cut-regular",
                                       "pinched-edge", "bad-vertex-link"});
  return undecided;
}

void apply_severities(std::vector<Finding>& findings, const CheckSettings& settings) {
  for (Finding& finding : findings) {
    const auto chosen = settings.severity.find(finding.rule);
    if (chosen != settings.severity.end()) finding.severity = chosen->second;
  }
  findings.erase(std::remove_if(findings.begin(), findings.end(),
                                [](const Finding& f) { return f.severity == Severity::off; }),
                 findings.end());
}

template <int D>
CheckReport check_cells(const Mesh& mesh, const CheckSettings& settings, Progress* progress) {
  const auto stage = [&](const char* what) {
    if (progress != nullptr) progress->stage(what + (" of " + mesh.source));
  };
  stage("checking the cells");
  const auto soup = cells_of<D>(mesh);
  auto violations = topology::check(soup, topology::Level::manifold);
  const std::vector<bool> node = edge_nodes(mesh);
  violations.erase(std::remove_if(violations.begin(), violations.end(),
                                  [&](const auto& violation) {
                                    const auto* orphan =
                                        std::get_if<topology::OrphanVertex>(&violation);
                                    return orphan != nullptr && node[orphan->vertex.value];
                                  }),
                   violations.end());
  stage("counting pieces and holes");
  const auto nodes = static_cast<std::size_t>(std::count(node.begin(), node.end(), true));
  const topology::Summary summary = topology::summarize(soup);
  CheckReport report{mesh.source,
                     {},
                     D,
                     soup.cells.size(),
                     mesh.points.size() - nodes,
                     nodes,
                     mesh.cohesive.size(),
                     topology::level_reached(D, violations),
                     {},
                     summary,
                     holes<D>(mesh, settings.betti, summary.simplices),
                     undecided_by(violations)};
  const auto add = [&](std::vector<Finding> findings) {
    std::move(findings.begin(), findings.end(), std::back_inserter(report.findings));
  };
  for (const auto& violation : violations)
    report.findings.push_back(finding_of(violation, mesh, settings.required));
  stage("checking the geometry");
  add(check_edge_nodes(mesh));
  add(check_geometry(mesh, settings.flat_ratio));
  add(check_coincident(mesh, settings.coincident_distance));
  apply_severities(report.findings, settings);
  return report;
}

std::string line(const CheckReport& report, const Finding& finding) {
  return fmt::format("{}: {}: {}: {}\n", report.source, name(finding.severity), finding.rule,
                     finding.message);
}

// In place of the findings of one rule and severity of which only the first `shown` are listed.
std::string line_on_the_others(const CheckReport& report, const Finding& last, std::size_t count,
                               std::size_t shown) {
  const std::string others = shown == 0 ? counted(count, "finding") + ", not shown"
                                        : fmt::format("{} more like these", count - shown);
  return fmt::format("{}: {}: {}: {}; --json lists them all\n", report.source, name(last.severity),
                     last.rule, others);
}

std::string line_on_the_whole(const CheckReport& report) {
  std::string text =
      fmt::format("{}: dimension {}, {}, {}", report.source, report.dimension,
                  counted(report.cells, "cell"), counted(report.vertices, "vertex", "vertices"));
  if (report.edge_nodes > 0)
    text += fmt::format(", second order ({} on edges)", counted(report.edge_nodes, "node"));
  if (report.cohesive > 0) text += ", " + counted(report.cohesive, "cohesive element");
  text += fmt::format(", {}, {}, Euler characteristic {}", counted(report.topology.pieces, "piece"),
                      counted(report.topology.boundary_components, "boundary component"),
                      report.topology.euler_characteristic);
  if (report.betti) text += fmt::format(", Betti numbers {}", fmt::join(*report.betti, " "));
  text += fmt::format("; level {}; {}, {}", topology::name(report.level),
                      counted(report.count(Severity::error), "error"),
                      counted(report.count(Severity::warning), "warning"));
  if (const std::size_t notes = report.count(Severity::note); notes > 0)
    text += ", " + counted(notes, "note");
  return text + '\n';
}

}  // namespace

CheckReport check_mesh(const Mesh& mesh, const CheckSettings& settings, Progress* progress) {
  if (mesh.dimension == 1) return check_cells<1>(mesh, settings, progress);
  if (mesh.dimension == 2) return check_cells<2>(mesh, settings, progress);
  return check_cells<3>(mesh, settings, progress);
}

std::string text_of(const CheckReport& report, std::size_t at_most, bool summary) {
  std::map<std::pair<std::string, Severity>, std::size_t> of_kind, shown;
  for (const Finding& finding : report.findings) ++of_kind[{finding.rule, finding.severity}];
  std::string text;
  for (const Finding& finding : report.findings) {
    const std::pair kind(finding.rule, finding.severity);
    const std::size_t count = ++shown[kind];
    if (count <= at_most)
      text += line(report, finding);
    else if (count == of_kind[kind])
      text += line_on_the_others(report, finding, count, at_most);
  }
  if (!report.undecided.empty())
    text += fmt::format("{}: undecided until these are mended: {}\n", report.source,
                        fmt::join(report.undecided, ", "));
  return summary ? text + line_on_the_whole(report) : text;
}

std::string closing_text(const std::vector<CheckReport>& reports, std::size_t excluded) {
  std::set<std::string> met;
  std::size_t unreadable = 0, objected = 0, errors = 0, warnings = 0, notes = 0;
  for (const CheckReport& report : reports) {
    for (const Finding& finding : report.findings) met.insert(finding.rule);
    unreadable += report.unreadable.empty() ? 0 : 1;
    objected += report.count(Severity::error) > 0 ? 1 : 0;
    errors += report.count(Severity::error);
    warnings += report.count(Severity::warning);
    notes += report.count(Severity::note);
  }
  std::string text;
  if (!met.empty())
    text += fmt::format("what these mean and how to mend them: cleave check --explain {}\n",
                        fmt::join(met, " "));
  if (reports.size() == 1 && excluded == 0) return text;
  text += counted(reports.size(), "mesh", "meshes") + " checked";
  if (unreadable > 0) text += fmt::format(", {} of them cannot be read", unreadable);
  if (excluded > 0) text += fmt::format(", {} excluded", excluded);
  text += fmt::format(": {} in {}, {}", counted(errors, "error"),
                      counted(objected, "mesh", "meshes"), counted(warnings, "warning"));
  if (notes > 0) text += ", " + counted(notes, "note");
  return text + '\n';
}

}  // namespace cleave::app
