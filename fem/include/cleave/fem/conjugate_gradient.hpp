#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

namespace cleave::fem {

/// How a solve ended.
/// converged: the tolerance was met, by the true residual (norm residual) or by the estimate
/// (energy). iteration_limit: max_iterations were made and the tolerance was not met. stagnated:
/// the residual is down to what rounding allows, and the tolerance was still not met. indefinite:
/// the operator or the preconditioner is not positive definite, beyond rounding. not_finite: the
/// right-hand side, the start or an iterate is NaN or infinite. unsupported_piece: a piece can move
/// rigidly, and the caller asked to refuse that (solve only).
enum class Outcome {
  converged,
  iteration_limit,
  stagnated,
  indefinite,
  not_finite,
  unsupported_piece
};

std::string_view name(Outcome outcome);  // "converged", "iteration_limit", ..

/// What the tolerance is measured in, relative to the same norm of the right-hand side (residual)
/// or of the solution (energy: |x|_A = sqrt(x.Ax)).
enum class Norm { residual, energy };

/// One iteration. Errors are relative, as Norm says.
struct Sample {
  std::size_t iteration = 0;  // 0: the start
  double seconds = 0.0;       // wall clock since the start
  double residual = 0.0;      // |b - A x| / |b| by recurrence; the last sample: computed anew
  std::optional<double> energy_error;  // estimate of |x - x*|_A / |x*|_A, see below
};

struct CgOptions {
  double tolerance = 1e-8;
  Norm norm = Norm::residual;
  std::size_t max_iterations = 10000;

  /// Called with every iterate, the start included (iteration 0).
  std::function<void(std::size_t iteration, const Eigen::VectorXd& x)> on_iterate;
};

struct CgResult {
  Outcome outcome = Outcome::converged;
  Eigen::VectorXd x;                   // the last iterate
  std::vector<Sample> samples;         // one per iterate, the start included
  double residual = 0.0;               // |b - A x| / |b|, computed anew at the end
  std::optional<double> energy_error;  // the last estimate there is: it bounds that of x from above
  double energy_norm = 0.0;            // estimate of |x*|_A, to make energy errors absolute

  std::size_t iterations() const { return samples.empty() ? 0 : samples.back().iteration; }
};

/// Writes the product of a matrix with the first argument to the second (resized by the callee).
using LinearMap = std::function<void(const Eigen::VectorXd& in, Eigen::VectorXd& out)>;

/// Solves A x = b for symmetric positive definite A and preconditioner M^-1 (empty: none), from the
/// start `x0` (empty: zero). Singular A is fine if b is orthogonal to its null space and the
/// preconditioner's results are. Never throws on slow or failed convergence: read `outcome`. Throws
/// std::invalid_argument for sizes that differ or a tolerance that is not positive.
///
/// Energy error: CG step j lowers |x - x_j|_A^2 by exactly alpha_j r_j.z_j, so the sum over a
/// window of steps after j is a lower bound of it (Hestenes & Stiefel 1952) that holds in finite
/// precision (Strakos & Tichy 2002). The window of each iterate is chosen as in Meurant, Papez &
/// Tichy 2021 (Accurate error estimation in CG), with a longer memory: it is closed when what it
/// leaves out is estimated to be below a quarter of it. So the estimate of an iterate is known some
/// iterations later (20 to 30 on bodies of one material, up to 200 on stiff ones), and the last
/// iterates of a solve have none; as the energy error never grows, the last estimate there is holds
/// for them as an upper one. Norm::energy stops when an estimate meets the tolerance; by then the
/// iterate is those iterations further.
///
/// Stagnation: once the residual of the recurrence is below the rounding errors of b - A x, that is
/// computed anew and CG restarts from it; the second time this brings no factor of two, it is over.
/// Time: per iteration one product with A, one with M^-1, and a few passes over vectors; one more
/// product with A at the start and at the end. Paper: section 2.2.
CgResult conjugate_gradient(const LinearMap& a, const Eigen::VectorXd& b,
                            const LinearMap& preconditioner = {}, Eigen::VectorXd x0 = {},
                            const CgOptions& options = {});

}  // namespace cleave::fem
