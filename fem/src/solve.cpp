#include "cleave/fem/solve.hpp"

#include <chrono>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>

#include "block_jacobi.hpp"
#include "cleave/topology/pieces.hpp"
#include "free_modes.hpp"
#include "geometry.hpp"

namespace cleave::fem {

using topology::Complex;
using topology::VertexId;

namespace {

Eigen::Ref<Eigen::Vector3d> entries_of(Eigen::VectorXd& v, VertexId vertex) {
  return v.segment<3>(3 * static_cast<Eigen::Index>(vertex.value));
}

void require_fit(const Complex<3>& k, const ElasticOperator& k_operator,
                 const Eigen::VectorXd& force, const Eigen::VectorXd& start) {
  if (k_operator.vertex_count() != k.vertex_count() || k_operator.cell_count() != k.cell_count())
    throw std::invalid_argument(
        "the operator was made for another complex, or was not told of a change of this one");
  if (force.size() != k_operator.size() || start.size() != k_operator.size())
    throw std::invalid_argument("force and start need " + std::to_string(k_operator.size()) +
                                " entries, 3 per vertex; they have " +
                                std::to_string(force.size()) + " and " +
                                std::to_string(start.size()));
}

/// Keeps vertices that no cell uses where they are; throws if one is loaded.
void hold_unused_vertices(const Complex<3>& k, const Eigen::VectorXd& force, Eigen::VectorXd& u) {
  for (topology::Index v = 0; v < k.vertex_count(); ++v) {
    if (k.a_corner({v})) continue;
    const Eigen::Vector3d load = force.segment<3>(3 * static_cast<Eigen::Index>(v));
    if (!(load == Eigen::Vector3d::Zero()))
      throw std::invalid_argument("there is a force on vertex " + std::to_string(v) +
                                  ", which no cell uses");
    entries_of(u, {v}).setZero();
  }
}

/// Removes the part of `load` that works on free modes and writes its resultants to `findings`.
void balance(const FreeModes& modes, Points points, Eigen::VectorXd& load,
             std::vector<PieceFinding>& findings) {
  if (modes.empty()) return;
  const Eigen::VectorXd before = load;
  modes.remove_load(load);
  const Eigen::VectorXd removed = before - load;
  for (PieceFinding& finding : findings)
    for (const VertexId v : finding.unsupported.vertices) {
      const Eigen::Vector3d force = removed.segment<3>(3 * static_cast<Eigen::Index>(v.value));
      const Eigen::Vector3d arm = as_vector(points[v.value]) - finding.unsupported.centre;
      finding.removed_force += force;
      finding.removed_moment += arm.cross(force);
    }
  constexpr double kRounding = 1e-14;
  if (load.norm() <= kRounding * before.norm()) load.setZero();  // nothing deforms the pieces
}

/// M^-1 between the two projections, so that no direction leaves the space in which K is definite.
LinearMap preconditioner_map(Preconditioner kind, const BlockJacobi* jacobi,
                             const FreeModes& modes) {
  if (kind == Preconditioner::none && modes.empty()) return {};
  return [jacobi, &modes](const Eigen::VectorXd& r, Eigen::VectorXd& z) {
    if (modes.empty()) {
      jacobi->apply(r, z);
      return;
    }
    Eigen::VectorXd balanced = r;
    modes.remove_load(balanced);
    if (jacobi)
      jacobi->apply(balanced, z);
    else
      z = balanced;
    modes.remove_motion(z);
  };
}

void take_over(CgResult&& from, SolveResult& to) {
  to.outcome = from.outcome;
  to.samples = std::move(from.samples);
  to.residual = from.residual;
  to.energy_error = from.energy_error;
  to.energy_norm = from.energy_norm;
}

/// The system on the free coordinates: u = w + u_D with u_D the prescribed values, zero elsewhere,
/// and P K w = P (f - K u_D), P setting prescribed coordinates to zero.
void solve_free_part(const ElasticOperator& k_operator, Points points, const Dirichlet& supports,
                     const FreeModes& modes, const Eigen::VectorXd& force, Eigen::VectorXd w,
                     const SolveOptions& options, SolveResult& result) {
  Eigen::VectorXd prescribed = Eigen::VectorXd::Zero(k_operator.size());
  supports.impose(prescribed);
  Eigen::VectorXd load;
  k_operator.apply(prescribed, load);
  load = force - load;
  supports.project(load);
  balance(modes, points, load, result.findings);
  supports.project(w);
  modes.remove_motion(w);

  const LinearMap k_map = [&](const Eigen::VectorXd& in, Eigen::VectorXd& out) {
    k_operator.apply(in, out);
    supports.project(out);
  };
  std::unique_ptr<const BlockJacobi> jacobi;
  if (options.preconditioner == Preconditioner::jacobi)
    jacobi = std::make_unique<BlockJacobi>(k_operator, supports);
  const LinearMap preconditioner = preconditioner_map(options.preconditioner, jacobi.get(), modes);

  CgOptions cg{options.tolerance, options.norm, options.max_iterations, {}};
  if (options.on_iterate)
    cg.on_iterate = [&](std::size_t iteration, const Eigen::VectorXd& iterate) {
      options.on_iterate(iteration, iterate + prescribed);
    };
  CgResult found = conjugate_gradient(k_map, load, preconditioner, std::move(w), cg);
  modes.remove_motion(found.x);
  result.displacement = found.x + prescribed;
  take_over(std::move(found), result);
}

}  // namespace

SolveResult solve(const Complex<3>& k, Points points, const ElasticOperator& k_operator,
                  const Dirichlet& supports, const Eigen::VectorXd& force,
                  const SolveOptions& options, const Eigen::VectorXd& start) {
  const auto begin = std::chrono::steady_clock::now();
  require_one_point_per_vertex(k, points);
  Eigen::VectorXd w = start;
  if (w.size() == 0) w = Eigen::VectorXd::Zero(k_operator.size());
  require_fit(k, k_operator, force, w);
  hold_unused_vertices(k, force, w);

  SolveResult result;
  const auto pieces = topology::pieces(k);
  result.piece_count = pieces.count;
  const auto unsupported = unsupported_pieces(k, points, pieces, supports);
  for (const UnsupportedPiece& piece : unsupported) result.findings.push_back({piece});

  if (!unsupported.empty() && options.on_unsupported == OnUnsupported::refuse) {
    result.outcome = Outcome::unsupported_piece;
  } else {
    std::vector<double> volumes;
    if (!unsupported.empty()) volumes = star_volumes(k, points);
    const FreeModes modes(unsupported, points, volumes, supports);
    solve_free_part(k_operator, points, supports, modes, force, std::move(w), options, result);
  }
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
  result.seconds = elapsed.count();
  return result;
}

double energy_distance(const ElasticOperator& k_operator, const Eigen::VectorXd& u,
                       const Eigen::VectorXd& v) {
  if (u.size() != v.size())
    throw std::invalid_argument("the displacements have " + std::to_string(u.size()) + " and " +
                                std::to_string(v.size()) + " entries");
  return std::sqrt(2.0 * k_operator.energy(u - v));
}

}  // namespace cleave::fem
