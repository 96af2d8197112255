#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "cleave/fem/body.hpp"
#include "cleave/fem/conjugate_gradient.hpp"
#include "cleave/fem/dirichlet.hpp"
#include "cleave/fem/elastic_operator.hpp"
#include "cleave/fem/rigid_modes.hpp"
#include "cleave/topology/complex.hpp"

namespace cleave::fem {

/// jacobi: the inverses of the 3x3 blocks on the diagonal, restricted to free coordinates.
enum class Preconditioner { none, jacobi };

/// What to do about pieces that can move rigidly: refuse to solve, or solve for the deformation
/// alone.
enum class OnUnsupported { refuse, solve_modulo };

struct SolveOptions {
  double tolerance = 1e-8;  // relative, see Norm; of the system left after the supports
  Norm norm = Norm::residual;
  std::size_t max_iterations = 10000;
  Preconditioner preconditioner = Preconditioner::jacobi;
  OnUnsupported on_unsupported = OnUnsupported::refuse;

  /// Called with every displacement, the start included (iteration 0).
  std::function<void(std::size_t iteration, const Eigen::VectorXd& displacement)> on_iterate;
};

/// A piece with free rigid modes, and the part of its load that no elastic force can balance.
struct PieceFinding {
  UnsupportedPiece unsupported;
  Eigen::Vector3d removed_force = Eigen::Vector3d::Zero();   // resultant of the load removed
  Eigen::Vector3d removed_moment = Eigen::Vector3d::Zero();  // its moment about the piece's centre
};

struct SolveResult {
  Outcome outcome = Outcome::converged;
  Eigen::VectorXd displacement;        // 3 per vertex; empty if the outcome is unsupported_piece
  std::vector<Sample> samples;         // one per iterate; of the system left after the supports
  double residual = 0.0;               // relative, computed anew at the end
  std::optional<double> energy_error;  // relative, the last estimate there is: an upper one
  double energy_norm = 0.0;  // makes energy errors absolute: |u*|_K without the supports' part
  std::size_t piece_count = 0;
  std::vector<PieceFinding> findings;  // the pieces with free rigid modes, ascending
  double seconds = 0.0;                // wall clock of the whole call

  std::size_t iterations() const { return samples.empty() ? 0 : samples.back().iteration; }
};

/// Solves K u = force with the prescribed coordinates of `supports` (Equation (2) of the paper),
/// from the displacement `start` (empty: zero), by preconditioned conjugate gradients.
///
/// Pieces that can move rigidly are found first and named in `findings`. With refuse, the outcome
/// is unsupported_piece and nothing is solved. With solve_modulo, the part of each such piece's
/// load that works on its free modes is removed, as inertia would take it (in proportion to the
/// volume around each vertex), and reported; the displacement returned has no free rigid part (its
/// mean over the volume around the vertices, against each free mode, is zero).
///
/// Vertices that no cell uses do not move. `k` and `points` are the ones `k_operator` stands for.
/// The complex is cut-regular by its type, which is what makes the analysis of pieces complete
/// (T9). Throws std::invalid_argument for sizes that differ, a prescribed vertex that does not
/// exist, a force on a vertex that no cell uses, a tolerance that is not positive. Otherwise read
/// `outcome`. Time: linear in the mesh per iteration; two passes over the cells before.
SolveResult solve(const topology::Complex<3>& k, Points points, const ElasticOperator& k_operator,
                  const Dirichlet& supports, const Eigen::VectorXd& force,
                  const SolveOptions& options = {}, const Eigen::VectorXd& start = {});

/// |u - v|_K = sqrt((u-v).K(u-v)), the energy norm of a difference.
double energy_distance(const ElasticOperator& k_operator, const Eigen::VectorXd& u,
                       const Eigen::VectorXd& v);

}  // namespace cleave::fem
