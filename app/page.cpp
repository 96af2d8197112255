#include "page.hpp"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <ostream>
#include <span>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "page/assets.hpp"
#include "page/base64.hpp"
#include "page/check.hpp"

namespace cleave::app {
namespace {

using Json = nlohmann::ordered_json;

/// Modules of the page: the name other modules import, and the asset.
constexpr std::array<std::pair<std::string_view, std::string_view>, 14> kModules{{
    {"three", "three.module.min.js"},
    {"three/OrbitControls.js", "OrbitControls.js"},
    {"cleave/body.js", "body.js"},
    {"cleave/camera.js", "camera.js"},
    {"cleave/colours.js", "colours.js"},
    {"cleave/data.js", "data.js"},
    {"cleave/fragment.js", "fragment.js"},
    {"cleave/main.js", "main.js"},
    {"cleave/marks.js", "marks.js"},
    {"cleave/mesh.js", "mesh.js"},
    {"cleave/overlay.js", "overlay.js"},
    {"cleave/panel.js", "panel.js"},
    {"cleave/plot.js", "plot.js"},
    {"cleave/stage.js", "stage.js"},
}};

std::string in_html(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

/// JSON that may stand in a script element: `<` occurs in strings only and is written \u003c there,
/// so neither </script> nor <!-- can occur. Bytes that are no UTF-8 become U+FFFD.
std::string in_script(const Json& json) {
  std::string escaped;
  for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace)) {
    if (c == '<')
      escaped += "\\u003c";
    else
      escaped += c;
  }
  return escaped;
}

std::string base64_of(const std::vector<std::uint32_t>& numbers) {
  return page::base64(std::span<const std::uint32_t>(numbers));
}

Json displacement_json(const std::vector<double>& displacement) {
  if (displacement.empty()) return nullptr;
  const std::vector<float> floats = page::as_floats(displacement);
  return page::base64(std::span<const float>(floats));
}

/// The corners that have another vertex than in the first state.
Json state_json(const PageState& state, const std::vector<std::uint32_t>& first_cells) {
  std::vector<std::uint32_t> corners, vertices;
  for (std::size_t h = 0; h < first_cells.size(); ++h) {
    if (state.cells[h] == first_cells[h]) continue;
    corners.push_back(static_cast<std::uint32_t>(h));
    vertices.push_back(state.cells[h]);
  }
  return {{"label", state.label},
          {"renamedCorners", base64_of(corners)},
          {"theirVertices", base64_of(vertices)},
          {"displacement", displacement_json(state.displacement)},
          {"opened", base64_of(state.opened)},
          {"shut", base64_of(state.shut)},
          {"pieces", state.pieces},
          {"iterations", state.iterations},
          {"outcome", state.outcome}};
}

Json solve_json(const PageSolve& solve) {
  Json iteration = Json::array(), seconds = Json::array(), residual = Json::array(),
       energy_error = Json::array();
  for (const auto& sample : solve.samples) {
    iteration.push_back(sample.iteration);
    seconds.push_back(sample.seconds);
    residual.push_back(sample.residual);  // not finite: null
    energy_error.push_back(sample.energy_error);
  }
  return {{"label", solve.label},
          {"outcome", solve.outcome},
          {"tolerance", solve.tolerance},
          {"iteration", std::move(iteration)},
          {"seconds", std::move(seconds)},
          {"residual", std::move(residual)},
          {"energyError", std::move(energy_error)}};
}

Json findings_json(const std::vector<PageFinding>& findings) {
  Json all = Json::array();
  for (const auto& finding : findings) {
    Json marks = Json::array();
    for (const auto& mark : finding.marks)
      marks.push_back({{"label", mark.label}, {"vertices", mark.vertices}});
    all.push_back({{"name", finding.name}, {"marks", std::move(marks)}});
  }
  return all;
}

/// The page reads 1, 2, .. when the numbers are left out.
Json cell_numbers_json(const std::vector<std::uint64_t>& numbers) {
  bool plain = true;
  for (std::size_t c = 0; c < numbers.size(); ++c) plain = plain && numbers[c] == c + 1;
  if (plain) return nullptr;
  return page::base64(std::span<const std::uint64_t>(numbers));
}

Json data_json(const PageData& data) {
  const auto& first = data.states.front();
  const auto origin = page::middle(data.points);
  const std::vector<float> points = page::as_floats(data.points, origin);
  Json states = Json::array();
  for (const auto& state : data.states) states.push_back(state_json(state, first.cells));
  Json solves = Json::array();
  for (const auto& solve : data.solves) solves.push_back(solve_json(solve));
  return {{"format", "cleave-page/1"},
          {"title", data.title},
          {"lengthUnit", data.length_unit},
          {"origin", origin},
          {"points", page::base64(std::span<const float>(points))},
          {"cells", base64_of(first.cells)},
          {"states", std::move(states)},
          {"materials", data.materials},
          {"materialOfCell", base64_of(data.material_of_cell)},
          {"cellNumbers", cell_numbers_json(data.cell_numbers)},
          {"findings", findings_json(data.findings)},
          {"solves", std::move(solves)}};
}

/// The modules as data: addresses, which every page may import, also one opened as a file.
Json import_map() {
  Json imports = Json::object();
  for (const auto& [name, file] : kModules)
    imports[std::string(name)] = "data:text/javascript;base64," + page::base64(page::asset(file));
  return {{"imports", std::move(imports)}};
}

/// The first line stands beside the title, the others in a list of their own.
std::string first_line(const std::vector<std::string>& lines) {
  return lines.empty() ? std::string() : in_html(lines.front());
}

std::string other_lines(const std::vector<std::string>& lines) {
  std::string html;
  for (std::size_t i = 1; i < lines.size(); ++i) html += "<li>" + in_html(lines[i]) + "</li>";
  return html;
}

}  // namespace

void write_page(std::ostream& out, const PageData& data) {
  page::require_consistent(data);
  const std::array<std::pair<std::string_view, std::string>, 7> parts{{
      {"title", in_html(data.title)},
      {"summary", first_line(data.summary)},
      {"story", other_lines(data.summary)},
      {"style", page::asset("page.css")},
      {"import_map", in_script(import_map())},
      {"data", in_script(data_json(data))},
      {"three_licence", in_html(page::asset("LICENSE"))},
  }};
  const std::string text = page::asset("page.html");
  std::string_view rest = text;
  for (auto open = rest.find("{{"); open != rest.npos; open = rest.find("{{")) {
    const auto close = rest.find("}}", open);
    const auto name = rest.substr(open + 2, close - open - 2);
    out << rest.substr(0, open);
    for (const auto& [part, content] : parts)
      if (part == name) out << content;
    rest.remove_prefix(close + 2);
  }
  out << rest;
}

}  // namespace cleave::app
