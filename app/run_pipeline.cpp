#include "run_pipeline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "body.hpp"
#include "cleave/fem/displacement.hpp"
#include "cleave/fem/elastic_operator.hpp"
#include "cleave/topology/carry_over.hpp"
#include "cleave/topology/pieces.hpp"
#include "error.hpp"
#include "file_words.hpp"
#include "kuhn_cube.hpp"
#include "mesh_file.hpp"
#include "run_body.hpp"
#include "run_page.hpp"
#include "run_solve.hpp"
#include "run_states.hpp"
#include "scene_physics.hpp"
#include "scene_stroke.hpp"

namespace cleave::app {
namespace {

constexpr const char* kFinalVtu = "final.vtu";
constexpr const char* kPage = "index.html";

using Clock = std::chrono::steady_clock;

std::string selected_by(const StrokeSpec& spec) {
  if (std::holds_alternative<FacetList>(spec.path)) return "facets";
  if (std::holds_alternative<GroupNames>(spec.path)) return "group";
  return spec.select.rule == cutting::Rule::dual_edge ? "dual-edge" : "nearest-vertex";
}

void warn_of(const StrokeReport& stroke, std::vector<std::string>& warnings) {
  if (stroke.requested == 0)
    warnings.push_back(fmt::format(
        "{} selects no facet: it misses the body, or follows a cut that is open already",
        stroke.name));
  if (stroke.not_interior > 0)
    warnings.push_back(
        fmt::format("{}: {} of the facets lie on the boundary; there is nothing to cut",
                    stroke.name, stroke.not_interior));
}

// What to do about a solve that ended without a displacement to trust.
std::string advice(const SolveReport& solve) {
  switch (solve.outcome) {
    case fem::Outcome::unsupported_piece: {
      const auto& piece = solve.floating.front();
      return fmt::format(
          "nothing holds {}, such as piece {} around cell {}, which has {}; add "
          "supports, or set \"on_unsupported\" to \"modulo_free_modes\"",
          counted(solve.floating.size(), "piece"), piece.piece, piece.a_cell,
          counted(piece.free_modes, "free rigid motion"));
    }
    case fem::Outcome::iteration_limit:
      return "raise \"max_iterations\" or \"tolerance\"";
    case fem::Outcome::stagnated:
      return "rounding keeps it from coming closer; raise \"tolerance\"";
    default:
      return "look at the sizes of material, loads and coordinates, and at the shapes of the cells";
  }
}

void warn_of(const SolveReport& solve, std::vector<std::string>& warnings) {
  if (solve.outcome == fem::Outcome::converged) return;
  warnings.push_back(fmt::format("the solve {} did not converge ({}, {} iterations): {}",
                                 solve.after.empty() ? "at rest" : "after " + solve.after,
                                 fem::name(solve.outcome), solve.iterations, advice(solve)));
}

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// A run in the making. Members are built in this order, or left out.
class Run {
 public:
  Run(const Scene& scene, const std::function<void(const std::string&)>& progress, bool strict)
      : scene_(scene), progress_(progress), strict_(strict) {}

  RunResult execute() {
    load_mesh();
    if (!scene_.materials.empty())
      materials_ = parts_.build("material", [&] { return materials_of(scene_, mesh_); });
    if (!scene_.solve && !(scene_.supports.empty() && scene_.loads.empty()))
      report().warnings.push_back("supports and loads do nothing without \"solve\"");
    if (scene_.strokes.empty() && !scene_.solve) return finish_without_complex();
    build_complex();
    if (scene_.solve) build_physics();
    if (scene_.solve) solve({});
    keep_state(scene_.solve ? "At rest, loaded" : "At rest", std::nullopt);
    for (std::size_t i = 0; i < scene_.strokes.size(); ++i) stroke(i);
    return finish();
  }

 private:
  RunReport& report() { return result_.report; }
  void load_mesh();
  void build_complex();
  void build_physics();
  void stroke(std::size_t i);
  void follow(const topology::Relabelling& change);
  void solve(const std::string& after);
  void keep_state(const std::string& label, std::optional<std::size_t> stroke);
  RunResult finish_without_complex();
  RunResult finish();

  const Scene& scene_;
  const std::function<void(const std::string&)>& progress_;
  const bool strict_;
  RunResult result_;
  Parts& parts_ = result_.report.parts;
  Mesh mesh_;
  std::optional<SceneMaterials> materials_;
  Body<3> body_;
  std::vector<std::array<double, 3>> points_;  // rest, one per vertex of the incision
  std::optional<topology::Incision<3>> incision_;
  std::optional<fem::ElasticOperator> operator_;
  fem::Dirichlet supports_;
  std::vector<fem::Loads> loads_;
  Eigen::VectorXd displacement_;  // the last one solved for, carried over; empty: none yet
  std::vector<std::vector<topology::OpenedFacet>> opened_by_stroke_;
};

void Run::load_mesh() {
  progress_("mesh");
  mesh_ = parts_.build("mesh", [&] {
    if (const auto* cube = std::get_if<CubeSpec>(&scene_.mesh)) return kuhn_cube(*cube);
    return read_mesh(std::get<std::filesystem::path>(scene_.mesh));
  });
  if (mesh_.cells().second_order())
    throw InputError(mesh_.source +
                     ": its cells are of second order, and the solver has linear elements; "
                     "write the mesh in first order (gmsh: Mesh.ElementOrder = 1)");
  mesh_.periodic.clear();  // no condition of a run
  if (mesh_.dimension != 3)
    throw InputError(
        fmt::format("{}: at /mesh: a scene needs tetrahedra, and the cells of {} are {}; give a "
                    "mesh of a volume",
                    scene_.source, mesh_.source, mesh_.dimension == 2 ? "triangles" : "edges"));
  report().title = scene_.title;
  report().cells = mesh_.cells().size();
  report().vertices_before = report().vertices_after = used_vertices(mesh_);
}

void Run::build_complex() {
  progress_("complex");
  body_ = parts_.build("complex", [&] { return make_body<3>(mesh_); });
  points_ = points_of(body_);
  incision_ = parts_.build("incision", [&] { return topology::Incision<3>(body_.complex); });
  report().has_complex = true;
  report().cut_regular = body_.regularized.empty();
  report().pieces = topology::pieces(body_.complex).count;
  report().pinched_edges = parts_.build("pinched-edge check", [&] { return pinched_edges(mesh_); });
  report().regularized = regularized_vertices(body_);
  for (const auto& vertex : report().regularized) {
    const std::string found = fmt::format(
        "vertex {} of {} is not cut-regular (its cells hang together only in that vertex)",
        vertex.parent, mesh_.source);
    if (strict_)
      throw InputError(found + "; mend the mesh, or leave out --strict to have it split");
    report().warnings.push_back(found + "; it was split, each part has its own copy now");
  }
}

void Run::build_physics() {
  progress_("physics");
  operator_ = parts_.build("operator", [&] {
    try {
      return fem::ElasticOperator(incision_->complex(), points_, materials_->lame);
    } catch (const fem::InvalidBody& e) {
      throw InputError(describe_flaws(e, mesh_));
    }
  });
  if (!scene_.supports.empty())
    supports_ = parts_.build("supports", [&] { return supports_of(scene_, body_); });
  if (!scene_.loads.empty())
    loads_ = parts_.build("loads", [&] { return loads_of(scene_, body_, points_, *materials_); });
}

void Run::stroke(std::size_t i) {
  const StrokeSpec& spec = scene_.strokes[i];
  progress_("cutting: " + spec.name);
  StrokeReport stroke;
  stroke.name = spec.name;
  stroke.selected_by = selected_by(spec);
  stroke.pieces_before = topology::pieces(incision_->complex()).count;
  const auto start = Clock::now();
  const SceneStroke made = make_stroke(spec, scene_.source, body_, *incision_, points_, parts_);
  stroke.cut_milliseconds = milliseconds_since(start);
  stroke.steps = made.steps;
  stroke.requested = made.requested.size();
  stroke.shut = (made.requested & incision_->shut()).size();
  stroke.opened = stroke.requested - stroke.shut;
  stroke.newly_opened = made.change.opened.size();
  stroke.not_interior = made.not_interior;
  stroke.new_vertices = made.change.splits.size();
  stroke.pieces_after = topology::pieces(incision_->complex()).count;
  stroke.pinched_edges =
      parts_.build("pinched-edge check", [&] { return count_pinched_edges(incision_->complex()); });
  warn_of(stroke, report().warnings);
  opened_by_stroke_.push_back(made.change.opened);

  const auto cut_done = Clock::now();
  if (scene_.solve) follow(made.change);
  stroke.follow_milliseconds = milliseconds_since(cut_done);
  report().strokes.push_back(stroke);
  if (scene_.solve) solve(spec.name);
  keep_state(spec.name, i);
}

void Run::follow(const topology::Relabelling& change) {
  const topology::Complex<3>& k = incision_->complex();
  parts_.build("operator", [&] { operator_->update(k, change); });
  if (!supports_.empty()) parts_.build("supports", [&] { supports_.carry_over(change); });
  if (!loads_.empty())
    parts_.build("loads", [&] {
      for (fem::Loads& loads : loads_) fem::carry_over(loads, k, points_, change);
    });
  if (displacement_.size() != 0) fem::carry_over(displacement_, k, points_, change);
}

void Run::solve(const std::string& after) {
  const topology::Complex<3>& k = incision_->complex();
  progress_(after.empty() ? "solving at rest" : "solving after " + after);
  const Eigen::VectorXd force = force_of(loads_, k, points_);
  const fem::SolveOptions options = solve_options(*scene_.solve);
  const bool warm = displacement_.size() != 0;
  const fem::SolveResult solved = parts_.build("solver", [&] {
    return fem::solve(k, points_, *operator_, supports_, force, options, displacement_);
  });
  SolveReport solve = report_of(solved, k, mesh_);
  solve.after = after;
  solve.warm_start = warm;
  solve.preconditioner = options.preconditioner == fem::Preconditioner::none ? "none" : "jacobi";
  if (solve.has_displacement) {
    displacement_ = solved.displacement;
    for (std::size_t i = 0; i < opened_by_stroke_.size(); ++i) {
      const Gap gap = gap_of(opened_by_stroke_[i], *incision_, displacement_);
      if (i + 1 == opened_by_stroke_.size()) report().strokes[i].gap = gap;
      report().strokes[i].final_gap = gap;
    }
  }
  warn_of(solve, report().warnings);
  report().solves.push_back(std::move(solve));
}

void Run::keep_state(const std::string& label, std::optional<std::size_t> stroke) {
  StateReport state;
  state.label = label;
  state.stroke = stroke;
  const SolveReport* solve = nullptr;
  if (scene_.solve) {
    state.solve = report().solves.size() - 1;
    solve = &report().solves.back();
  }
  const Eigen::VectorXd none;
  const Eigen::VectorXd& shown = solve && solve->has_displacement ? displacement_ : none;
  const bool last = report().states.size() == scene_.strokes.size();
  const bool every = scene_.output.frames == OutputSpec::Frames::states;
  if (scene_.output.vtu && (last || every))
    parts_.build("vtu", [&] {
      Mesh mesh = state_mesh(body_, *incision_, shown, report().warnings);
      if (every) {
        state.vtu = fmt::format("state-{:03}.vtu", report().states.size());
        result_.vtu.push_back({state.vtu, mesh});
      }
      if (last) result_.vtu.push_back({kFinalVtu, std::move(mesh)});
    });
  if (scene_.output.page)
    parts_.build("page", [&] {
      if (!result_.page) {
        result_.page = new_page(scene_, mesh_, materials_);
        add_body(*result_.page, body_, points_, report());
      }
      add_state(*result_.page, label, *incision_, shown,
                stroke ? report().strokes[*stroke].pieces_after : report().pieces, solve);
    });
  report().states.push_back(std::move(state));
}

RunResult Run::finish_without_complex() {
  StateReport state;
  state.label = "At rest";
  if (scene_.output.vtu)
    parts_.build("vtu", [&] {
      Mesh mesh = bare_mesh(mesh_);
      if (scene_.output.frames == OutputSpec::Frames::states) {
        state.vtu = "state-000.vtu";
        result_.vtu.push_back({state.vtu, mesh});
      }
      result_.vtu.push_back({kFinalVtu, std::move(mesh)});
    });
  if (scene_.output.page)
    parts_.build("page", [&] {
      result_.page = new_page(scene_, mesh_, materials_);
      add_bare_state(*result_.page, mesh_, state.label);
    });
  report().states.push_back(std::move(state));
  return finish();
}

RunResult Run::finish() {
  if (report().has_complex) report().vertices_after = used_vertices(incision_->complex());
  if (!result_.vtu.empty()) report().final_vtu = kFinalVtu;
  if (result_.page) {
    report().page = kPage;
    add_report(*result_.page, scene_, report());
  }
  return std::move(result_);
}

}  // namespace

std::size_t run_stages(const Scene& scene) {
  const bool solves = scene.solve.has_value();
  if (!solves && scene.strokes.empty()) return 1;                         // mesh
  return 2 + (solves ? 2 : 0) + scene.strokes.size() * (solves ? 2 : 1);  // complex, physics, ..
}

RunResult run_scene(const Scene& scene, const std::function<void(const std::string&)>& progress,
                    bool strict) {
  return Run(scene, progress, strict).execute();
}

}  // namespace cleave::app
