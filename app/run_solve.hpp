#pragma once
#include <Eigen/Core>
#include <span>

#include "body.hpp"
#include "cleave/fem/solve.hpp"
#include "cleave/topology/incision.hpp"
#include "run_report.hpp"
#include "scene.hpp"

namespace cleave::app {

fem::SolveOptions solve_options(const SolveSpec& spec);

/// What a solve on `k`, made from `mesh`, is reported as; samples thinned to 200. A displacement
/// that is not finite counts as none.
SolveReport report_of(const fem::SolveResult& solved, const topology::Complex<3>& k,
                      const Mesh& mesh);

/// How far the sides of `opened` (facets of the incision, open now) are apart; see Gap.
Gap gap_of(std::span<const topology::OpenedFacet> opened, const topology::Incision<3>& incision,
           const Eigen::VectorXd& displacement);

}  // namespace cleave::app
