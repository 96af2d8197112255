#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mesh.hpp"
#include "page.hpp"
#include "run_report.hpp"
#include "scene.hpp"

namespace cleave::app {

/// A file of a run, by its name inside the output folder.
struct StateFile {
  std::string name;
  Mesh mesh;
};

/// How many stages run_scene will announce.
std::size_t run_stages(const Scene& scene);

/// What a run leaves: nothing has been written yet.
struct RunResult {
  RunReport report;
  std::vector<StateFile> vtu;  // in time order, final.vtu last
  std::optional<PageData> page;
};

/// Runs a scene: loads or makes the mesh, regularises it, solves at rest, and after each stroke
/// cuts, brings operator, supports, loads and displacement up to date and solves again from there.
/// Builds no part that the scene does not name: the complex (with its mates) only for a scene that
/// cuts or solves, the operator only to solve. `progress` is called now and then with a line to
/// show. Throws InputError for whatever is invalid in the scene or its mesh. Failed solves are
/// outcomes.
/// With `strict`, a mesh that is not cut-regular is one, too, instead of being regularised.
RunResult run_scene(const Scene& scene, const std::function<void(const std::string&)>& progress,
                    bool strict = false);

}  // namespace cleave::app
