#include "run_solve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cleave/topology/pieces.hpp"

namespace cleave::app {
namespace {

using topology::VertexId;

constexpr std::size_t kSamples = 200;

Eigen::Vector3d at(const Eigen::VectorXd& u, VertexId vertex) {
  return u.segment<3>(3 * static_cast<Eigen::Index>(vertex.value));
}

void measure(SolveReport& report, const topology::Complex<3>& k, const Eigen::VectorXd& u) {
  const double infinity = std::numeric_limits<double>::infinity();
  report.low = {infinity, infinity, infinity};
  report.high = {-infinity, -infinity, -infinity};
  for (Index v = 0; v < k.vertex_count(); ++v) {
    if (!k.a_corner({v})) continue;
    const Eigen::Vector3d move = at(u, {v});
    report.largest_displacement = std::max(report.largest_displacement, move.norm());
    for (std::size_t i = 0; i < 3; ++i) {
      report.low[i] = std::min(report.low[i], move[static_cast<Eigen::Index>(i)]);
      report.high[i] = std::max(report.high[i], move[static_cast<Eigen::Index>(i)]);
    }
  }
}

SolveReport::Floating floating_of(const fem::PieceFinding& finding, const topology::Pieces& pieces,
                                  const Mesh& mesh) {
  SolveReport::Floating floating;
  floating.piece = finding.unsupported.piece;
  floating.a_cell = mesh.cells().numbers[finding.unsupported.a_cell.value];
  floating.cells = static_cast<std::size_t>(
      std::count(pieces.of_cell.begin(), pieces.of_cell.end(), finding.unsupported.piece));
  floating.free_modes = static_cast<std::size_t>(finding.unsupported.modes.cols());
  for (std::size_t i = 0; i < 3; ++i) {
    floating.removed_force[i] = finding.removed_force[static_cast<Eigen::Index>(i)];
    floating.removed_moment[i] = finding.removed_moment[static_cast<Eigen::Index>(i)];
  }
  return floating;
}

}  // namespace

fem::SolveOptions solve_options(const SolveSpec& spec) {
  fem::SolveOptions options;
  options.tolerance = spec.tolerance;
  options.norm = spec.norm == SolveSpec::Norm::residual ? fem::Norm::residual : fem::Norm::energy;
  options.max_iterations = spec.max_iterations;
  options.preconditioner = spec.preconditioner == SolveSpec::Preconditioner::none
                               ? fem::Preconditioner::none
                               : fem::Preconditioner::jacobi;
  options.on_unsupported = spec.on_unsupported == SolveSpec::Unsupported::refuse
                               ? fem::OnUnsupported::refuse
                               : fem::OnUnsupported::solve_modulo;
  return options;
}

std::vector<fem::Sample> thinned(const std::vector<fem::Sample>& samples, std::size_t limit) {
  if (samples.size() <= limit) return samples;
  std::size_t estimated = 0;  // the last one with an estimate
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (samples[i].energy_error) estimated = i;
  std::vector<std::size_t> kept{estimated};
  const std::size_t even = limit - 1;
  for (std::size_t i = 0; i < even; ++i) kept.push_back(i * (samples.size() - 1) / (even - 1));
  std::sort(kept.begin(), kept.end());
  kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
  std::vector<fem::Sample> few;
  for (const std::size_t i : kept) few.push_back(samples[i]);
  return few;
}

SolveReport report_of(const fem::SolveResult& solved, const topology::Complex<3>& k,
                      const Mesh& mesh) {
  SolveReport report;
  report.outcome = solved.outcome;
  report.iterations = solved.iterations();
  report.residual = solved.residual;
  report.energy_error = solved.energy_error;
  report.energy_norm = solved.energy_norm;
  report.samples = thinned(solved.samples, kSamples);
  report.pieces = solved.piece_count;
  report.milliseconds = 1e3 * solved.seconds;
  if (!solved.findings.empty()) {
    const topology::Pieces pieces = topology::pieces(k);
    for (const auto& finding : solved.findings)
      report.floating.push_back(floating_of(finding, pieces, mesh));
  }
  report.has_displacement = solved.displacement.size() != 0 && solved.displacement.allFinite();
  if (report.has_displacement) measure(report, k, solved.displacement);
  return report;
}

Gap gap_of(std::span<const topology::OpenedFacet> opened, const topology::Incision<3>& incision,
           const Eigen::VectorXd& displacement) {
  const topology::Complex<3>& k = incision.complex();
  Gap gap;
  for (const auto& facet : opened) {
    double sum = 0.0;
    for (const VertexId v : k.facet(facet.half_facet))
      for (const VertexId w : k.facet(facet.former_mate))
        if (incision.original(v) == incision.original(w)) {
          const double distance = (at(displacement, v) - at(displacement, w)).norm();
          sum += distance;
          gap.max = std::max(gap.max, distance);
        }
    gap.mean += sum / 3.0;
  }
  if (!opened.empty()) gap.mean /= static_cast<double>(opened.size());
  return gap;
}

}  // namespace cleave::app
