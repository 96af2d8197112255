#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>

#include "body.hpp"
#include "cleave/topology/incision.hpp"
#include "page.hpp"
#include "run_report.hpp"
#include "scene.hpp"
#include "scene_physics.hpp"

/// The page of a run, put together as the run goes on.
namespace cleave::app {

/// A page with title and materials, and no states yet.
PageData new_page(const Scene& scene, const Mesh& mesh,
                  const std::optional<SceneMaterials>& materials);

/// Adds the body at rest: its points, and what is marked on it.
void add_body(PageData& page, const Body<3>& body, const std::vector<std::array<double, 3>>& points,
              const RunReport& report);

/// Adds the present state of the body; `solve` is the one that led here, or null.
void add_state(PageData& page, const std::string& label, const topology::Incision<3>& incision,
               const Eigen::VectorXd& displacement, std::size_t pieces, const SolveReport* solve);

/// Adds points and the one state of a run without complex. Time: O(n log n), to count the pieces.
void add_bare_state(PageData& page, const Mesh& mesh, const std::string& label);

/// Adds the solves and the lines under the title.
void add_report(PageData& page, const Scene& scene, const RunReport& report);

}  // namespace cleave::app
