#include "check_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "body.hpp"
#include "cleave/topology/check.hpp"
#include "edge_nodes.hpp"
#include "file_words.hpp"
#include "geometry_check.hpp"

namespace cleave::app {

std::size_t CheckReport::errors() const {
  return static_cast<std::size_t>(
      std::count_if(findings.begin(), findings.end(),
                    [](const Finding& f) { return f.severity == Severity::error; }));
}

namespace {

template <int D>
CheckReport check_cells(const Mesh& mesh, topology::Level required) {
  const auto soup = soup_of<D>(mesh);
  auto violations = topology::check(soup, topology::Level::manifold);
  const std::vector<bool> node = edge_nodes(mesh);
  violations.erase(std::remove_if(violations.begin(), violations.end(),
                                  [&](const auto& violation) {
                                    const auto* orphan =
                                        std::get_if<topology::OrphanVertex>(&violation);
                                    return orphan != nullptr && node[orphan->vertex.value];
                                  }),
                   violations.end());
  const auto nodes = static_cast<std::size_t>(std::count(node.begin(), node.end(), true));
  CheckReport report{mesh.source,
                     D,
                     soup.cells.size(),
                     mesh.points.size() - nodes,
                     nodes,
                     mesh.cohesive.size(),
                     topology::level_reached(D, violations),
                     {},
                     topology::summarize(soup)};
  for (const auto& violation : violations)
    report.findings.push_back(finding_of(violation, mesh, required));
  for (Finding& finding : check_edge_nodes(mesh)) report.findings.push_back(std::move(finding));
  for (Finding& finding : check_geometry(mesh)) report.findings.push_back(std::move(finding));
  return report;
}

}  // namespace

CheckReport check_mesh(const Mesh& mesh, topology::Level required) {
  if (mesh.dimension == 1) return check_cells<1>(mesh, required);
  if (mesh.dimension == 2) return check_cells<2>(mesh, required);
  return check_cells<3>(mesh, required);
}

std::string text_of(const CheckReport& report, std::size_t at_most, bool summary) {
  std::map<std::string, std::size_t> of_rule;
  for (const Finding& finding : report.findings) ++of_rule[finding.rule];

  std::string text;
  std::map<std::string, std::size_t> shown;
  for (const Finding& finding : report.findings) {
    const char* severity = finding.severity == Severity::error ? "error" : "warning";
    const std::size_t count = ++shown[finding.rule];
    if (count <= at_most)
      text +=
          fmt::format("{}: {}: {}: {}\n", report.source, severity, finding.rule, finding.message);
    else if (count == of_rule[finding.rule])
      text += fmt::format("{}: {}: {}: {} more like these; --json lists them all\n", report.source,
                          severity, finding.rule, count - at_most);
  }
  if (!summary) return text;
  const std::size_t errors = report.errors(), warnings = report.findings.size() - errors;
  return text + fmt::format(
                    "{}: dimension {}, {}, {}{}{}, {}, {}, Euler characteristic {}; level {}; "
                    "{}, {}\n",
                    report.source, report.dimension, counted(report.cells, "cell"),
                    counted(report.vertices, "vertex", "vertices"),
                    report.edge_nodes == 0 ? ""
                                           : fmt::format(", second order ({} on edges)",
                                                         counted(report.edge_nodes, "node")),
                    report.cohesive == 0 ? "" : ", " + counted(report.cohesive, "cohesive element"),
                    counted(report.topology.pieces, "piece"),
                    counted(report.topology.boundary_components, "boundary component"),
                    report.topology.euler_characteristic, topology::name(report.level),
                    counted(errors, "error"), counted(warnings, "warning"));
}

}  // namespace cleave::app
