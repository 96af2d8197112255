#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "file_words.hpp"
#include "run_report.hpp"

namespace cleave::app {
namespace {

using Json = nlohmann::ordered_json;

template <class T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json name_or_null(const std::string& name) { return name.empty() ? Json(nullptr) : Json(name); }

Json gap_json(const std::optional<Gap>& gap) {
  if (!gap) return nullptr;
  return {{"mean", gap->mean}, {"max", gap->max}};
}

Json stroke_json(const StrokeReport& stroke) {
  return {
      {"name", stroke.name},
      {"selected_by", stroke.selected_by},
      {"steps", stroke.steps},
      {"facets",
       {{"requested", stroke.requested},
        {"opened", stroke.opened},
        {"shut", stroke.shut},
        {"newly_opened", stroke.newly_opened},
        {"not_interior", stroke.not_interior}}},
      {"new_vertices", stroke.new_vertices},
      {"pieces", {{"before", stroke.pieces_before}, {"after", stroke.pieces_after}}},
      {"pinched_edges", stroke.pinched_edges},
      {"gap", gap_json(stroke.gap)},
      {"final_gap", gap_json(stroke.final_gap)},
      {"milliseconds", {{"cut", stroke.cut_milliseconds}, {"follow", stroke.follow_milliseconds}}}};
}

Json solve_json(const SolveReport& solve) {
  Json unsupported = Json::array(), samples = Json::array();
  for (const auto& piece : solve.floating)
    unsupported.push_back({{"piece", piece.piece},
                           {"cell", piece.a_cell},
                           {"cells", piece.cells},
                           {"free_modes", piece.free_modes},
                           {"removed_force", piece.removed_force},
                           {"removed_moment", piece.removed_moment}});
  for (const fem::Sample& sample : solve.samples)
    samples.push_back({{"iteration", sample.iteration},
                       {"seconds", sample.seconds},
                       {"residual", sample.residual},
                       {"energy_error", or_null(sample.energy_error)}});
  Json displacement = nullptr;
  if (solve.has_displacement)
    displacement = {
        {"largest", solve.largest_displacement}, {"low", solve.low}, {"high", solve.high}};
  return {{"after", name_or_null(solve.after)},
          {"outcome", fem::name(solve.outcome)},
          {"preconditioner", solve.preconditioner},
          {"warm_start", solve.warm_start},
          {"iterations", solve.iterations},
          {"residual", solve.residual},
          {"energy_error", or_null(solve.energy_error)},
          {"energy_norm", solve.energy_norm},
          {"pieces", solve.pieces},
          {"unsupported", std::move(unsupported)},
          {"displacement", std::move(displacement)},
          {"milliseconds", solve.milliseconds},
          {"samples", std::move(samples)}};
}

void add_findings(const RunReport& report, Json& summary) {
  Json regularized = Json::array(), pinched = Json::array();
  for (const auto& vertex : report.regularized)
    regularized.push_back({{"vertex", vertex.vertex}, {"parent", vertex.parent}});
  for (const auto& edge : report.pinched_edges)
    pinched.push_back({{"vertices", edge.vertices}, {"cells", {edge.one_part, edge.other_part}}});
  summary["regularized"] = std::move(regularized);
  summary["pinched_edges"] = std::move(pinched);
}

std::string solve_text(const SolveReport& solve) {
  std::string text =
      fmt::format("solve {}: {}, {} iterations, residual {:.2e}, energy error {}, {:.0f} ms\n",
                  solve.after.empty() ? "at rest" : "after " + solve.after,
                  fem::name(solve.outcome), solve.iterations, solve.residual,
                  solve.energy_error ? fmt::format("about {:.1e}", *solve.energy_error) : "unknown",
                  solve.milliseconds);
  for (const auto& piece : solve.floating) {
    text += fmt::format("  piece {} (cell {} and {} more) has {}", piece.piece, piece.a_cell,
                        piece.cells - 1, counted(piece.free_modes, "free rigid motion"));
    if (solve.has_displacement)
      text +=
          fmt::format("; load removed: force ({:.3g} {:.3g} {:.3g}), moment ({:.3g} {:.3g} {:.3g})",
                      piece.removed_force[0], piece.removed_force[1], piece.removed_force[2],
                      piece.removed_moment[0], piece.removed_moment[1], piece.removed_moment[2]);
    text += '\n';
  }
  if (solve.has_displacement)
    text += fmt::format("  largest displacement {:.4g}\n", solve.largest_displacement);
  return text;
}

std::string stroke_text(const StrokeReport& stroke) {
  std::string text = fmt::format(
      "{}: {} requested, {} opened, {} shut; pieces {} -> {}; {}, {}; cut {:.2f} ms\n", stroke.name,
      counted(stroke.requested, "facet"), stroke.opened, stroke.shut, stroke.pieces_before,
      stroke.pieces_after, counted(stroke.new_vertices, "new vertex", "new vertices"),
      counted(stroke.pinched_edges, "pinched edge"), stroke.cut_milliseconds);
  if (stroke.gap)
    text += fmt::format("  under load its sides are {:.4g} apart on average, {:.4g} at most\n",
                        stroke.gap->mean, stroke.gap->max);
  return text;
}

std::string parts_text(const Parts& parts) {
  std::string text = "built            times   seconds      held\n";
  for (const Part& part : parts.all())
    text += fmt::format("{:<18} {:>3} {:>9.4f} {:>9}\n", part.name, part.times, part.seconds,
                        parts.bytes_known()
                            ? fmt::format("{:.1f} kB", static_cast<double>(part.bytes) / 1e3)
                            : "-");
  return text;
}

}  // namespace

std::string summary_json(const RunReport& report) {
  Json summary{{"schema", "cleave-run/1"},
               {"title", report.title},
               {"mesh",
                {{"cells", report.cells},
                 {"vertices_before", report.vertices_before},
                 {"vertices_after", report.vertices_after}}},
               {"cut_regular", report.has_complex ? Json(report.cut_regular) : Json(nullptr)},
               {"pieces", report.has_complex ? Json(report.pieces) : Json(nullptr)}};
  add_findings(report, summary);
  Json strokes = Json::array(), solves = Json::array(), states = Json::array(), vtu = Json::array(),
       parts = Json::array();
  for (const auto& stroke : report.strokes) strokes.push_back(stroke_json(stroke));
  for (const auto& solve : report.solves) solves.push_back(solve_json(solve));
  for (const auto& state : report.states) {
    states.push_back({{"label", state.label},
                      {"vtu", name_or_null(state.vtu)},
                      {"stroke", or_null(state.stroke)},
                      {"solve", or_null(state.solve)}});
    if (!state.vtu.empty()) vtu.push_back(state.vtu);
  }
  for (const Part& part : report.parts.all())
    parts.push_back({{"name", part.name},
                     {"times", part.times},
                     {"seconds", part.seconds},
                     {"bytes", report.parts.bytes_known() ? Json(part.bytes) : Json(nullptr)}});
  summary["strokes"] = std::move(strokes);
  summary["solves"] = std::move(solves);
  summary["states"] = std::move(states);
  if (vtu.empty() && !report.final_vtu.empty()) vtu.push_back(report.final_vtu);
  summary["vtu"] = std::move(vtu);
  summary["final"] = name_or_null(report.final_vtu);
  summary["page"] = name_or_null(report.page);
  summary["parts"] = std::move(parts);
  summary["warnings"] = report.warnings;
  return summary.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string summary_text(const RunReport& report) {
  std::string text = fmt::format("{}: {} cells, {} vertices\n", report.title, report.cells,
                                 report.vertices_before);
  for (const StateReport& state : report.states) {
    if (state.stroke) text += stroke_text(report.strokes[*state.stroke]);
    if (state.solve) text += solve_text(report.solves[*state.solve]);
  }
  return text + parts_text(report.parts);
}

}  // namespace cleave::app
