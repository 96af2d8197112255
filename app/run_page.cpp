#include "run_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <unordered_map>

#include "cleave/topology/summary.hpp"
#include "error.hpp"

namespace cleave::app {
namespace {

using topology::VertexId;

std::string material_name(const MaterialSpec& material) {
  const double lambda = material.lame.lambda, mu = material.lame.mu;
  const double young = mu * (3.0 * lambda + 2.0 * mu) / (lambda + mu);
  const double poisson = lambda / (2.0 * (lambda + mu));
  return fmt::format("{}E = {:.4g}, nu = {:.3g}",
                     material.group.empty() ? "" : "group " + material.group + ": ", young,
                     poisson);
}

// The page holds 32 bits of each number; new_page has refused meshes that need more.
std::uint32_t page_number(Index id) { return static_cast<std::uint32_t>(id); }

PageFinding regularised(const Body<3>& body) {
  PageFinding finding{"Regularised vertices", {}};
  for (const auto& split : body.regularized)
    finding.marks.push_back(
        {fmt::format("vertex {}", body.mesh->vertex_numbers[split.parent.value]),
         {page_number(split.vertex.value)}});
  return finding;
}

// The edge's vertices among those of a cell that has it: copies share the number of their parent.
std::vector<std::uint32_t> vertices_of_edge(const PinchedEdge& edge, const Body<3>& body,
                                            Index cell) {
  std::vector<std::uint32_t> ends;
  for (const std::uint64_t number : edge.vertices)
    for (const VertexId v : body.complex.vertices({cell}))
      if (body.number(v) == number) ends.push_back(page_number(v.value));
  return ends;
}

PageFinding pinched(const Body<3>& body, const RunReport& report) {
  PageFinding finding{"Pinched edges", {}};
  std::unordered_map<std::uint64_t, Index> place_of_cell;
  if (!report.pinched_edges.empty())
    for (Index c = 0; c < body.complex.cell_count(); ++c)
      place_of_cell.emplace(body.mesh->cells().numbers[c], c);
  for (const PinchedEdge& edge : report.pinched_edges)
    finding.marks.push_back({fmt::format("edge {} {}: its cells form several parts",
                                         edge.vertices[0], edge.vertices[1]),
                             vertices_of_edge(edge, body, place_of_cell.at(edge.one_part))});
  return finding;
}

std::string solve_line(const SolveReport& solve) {
  return fmt::format("{}: {} after {} iterations, relative residual {:.2g}",
                     solve.after.empty() ? "At rest" : solve.after, fem::name(solve.outcome),
                     solve.iterations, solve.residual);
}

std::string stroke_line(const StrokeReport& stroke, const std::string& unit) {
  std::string line = fmt::format("{}: {} facets requested, {} opened, {} shut; pieces {} to {}",
                                 stroke.name, stroke.requested, stroke.opened, stroke.shut,
                                 stroke.pieces_before, stroke.pieces_after);
  if (stroke.gap)
    line += fmt::format("; the sides are {:.3g}{} apart on average, {:.3g} at most",
                        stroke.gap->mean, unit.empty() ? "" : " " + unit, stroke.gap->max);
  return line;
}

PageSolve page_solve(const SolveReport& solve, const SolveSpec& spec) {
  PageSolve page{solve.after.empty() ? "At rest" : solve.after,
                 std::string(fem::name(solve.outcome)),
                 spec.norm == SolveSpec::Norm::residual ? spec.tolerance : 0.0,
                 {}};
  for (const fem::Sample& sample : solve.samples)
    page.samples.push_back(
        {static_cast<int>(sample.iteration), sample.seconds, sample.residual,
         sample.energy_error.value_or(std::numeric_limits<double>::quiet_NaN())});
  return page;
}

}  // namespace

PageData new_page(const Scene& scene, const Mesh& mesh,
                  const std::optional<SceneMaterials>& materials) {
  if (mesh.cells().size() > UINT32_MAX / 4)
    throw InputError(mesh.source + ": a page shows 1073741823 cells at most; switch it off");
  PageData page;
  page.title = scene.title;
  page.length_unit = scene.length_unit;
  page.cell_numbers = mesh.cells().numbers;
  if (materials) {
    for (const MaterialSpec& material : scene.materials)
      page.materials.push_back(material_name(material));
    page.material_of_cell = materials->lame.of_cell;
  }
  return page;
}

void add_body(PageData& page, const Body<3>& body, const std::vector<std::array<double, 3>>& points,
              const RunReport& report) {
  for (const auto& point : points)
    page.points.insert(page.points.end(), point.begin(), point.end());
  if (!body.regularized.empty()) page.findings.push_back(regularised(body));
  if (!report.pinched_edges.empty()) page.findings.push_back(pinched(body, report));
}

void add_state(PageData& page, const std::string& label, const topology::Incision<3>& incision,
               const Eigen::VectorXd& displacement, std::size_t pieces, const SolveReport* solve) {
  PageState state;
  state.label = label;
  for (const auto& cell : incision.complex().cells())
    for (const VertexId v : cell) state.cells.push_back(page_number(v.value));
  state.displacement.assign(displacement.begin(), displacement.end());
  for (const auto& facet : incision.opened())
    state.opened.push_back(page_number(facet.half_facet.value));
  for (const auto facet : incision.shut().half_facets())
    state.shut.push_back(page_number(facet.value));
  state.pieces = pieces;
  if (solve) {
    state.iterations = static_cast<int>(solve->iterations);
    state.outcome = fem::name(solve->outcome);
  }
  page.states.push_back(std::move(state));
}

void add_bare_state(PageData& page, const Mesh& mesh, const std::string& label) {
  for (const auto& point : mesh.points)
    page.points.insert(page.points.end(), point.begin(), point.end());
  PageState state;
  state.label = label;
  for (const Index v : mesh.cells().vertices) state.cells.push_back(page_number(v));
  state.pieces = topology::summarize(soup_of<3>(mesh)).pieces;
  page.states.push_back(std::move(state));
}

void add_report(PageData& page, const Scene& scene, const RunReport& report) {
  page.summary.push_back(fmt::format(
      "{} cells, {} vertices{}", report.cells, report.vertices_before,
      report.regularized.empty() ? ""
                                 : fmt::format(", {} of them split because they were not "
                                               "cut-regular",
                                               report.regularized.size())));
  for (const StrokeReport& stroke : report.strokes)
    page.summary.push_back(stroke_line(stroke, scene.length_unit));
  for (const SolveReport& solve : report.solves) {
    page.summary.push_back(solve_line(solve));
    page.solves.push_back(page_solve(solve, *scene.solve));
  }
}

}  // namespace cleave::app
