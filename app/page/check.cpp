#include "page/check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace cleave::app::page {
namespace {

[[noreturn]] void refuse(const std::string& what) {
  throw std::invalid_argument("page data: " + what);
}

void require_below(const std::vector<std::uint32_t>& ids, std::size_t bound,
                   const std::string& name) {
  for (std::size_t i = 0; i < ids.size(); ++i)
    if (ids[i] >= bound)
      refuse(name + "[" + std::to_string(i) + "] is " + std::to_string(ids[i]) +
             ", allowed is less than " + std::to_string(bound));
}

void require_finite(const std::vector<double>& triples, const std::string& name) {
  if (triples.size() % 3 != 0)
    refuse(name + " has " + std::to_string(triples.size()) + " numbers, which is no multiple of 3");
  for (std::size_t i = 0; i < triples.size(); ++i)
    if (!(std::abs(triples[i]) <= 0.25 * std::numeric_limits<float>::max()))
      refuse(name + "[" + std::to_string(i) + "] is not finite, or too large for a 32-bit float");
}

void require_state(const PageState& state, std::size_t corners, const std::string& name) {
  if (state.cells.size() != corners)
    refuse(name + ".cells has " + std::to_string(state.cells.size()) +
           " vertices, the first state " + std::to_string(corners));
  require_finite(state.displacement, name + ".displacement");
  if (!state.displacement.empty())
    require_below(state.cells, state.displacement.size() / 3, name + ".cells");
  require_below(state.opened, corners, name + ".opened");
  require_below(state.shut, corners, name + ".shut");
}

void require_findings(const std::vector<PageFinding>& findings, std::size_t vertices) {
  for (std::size_t f = 0; f < findings.size(); ++f)
    for (std::size_t m = 0; m < findings[f].marks.size(); ++m) {
      const auto name = "findings[" + std::to_string(f) + "].marks[" + std::to_string(m) + "]";
      const auto& places = findings[f].marks[m].vertices;
      if (places.empty() || places.size() > 2) refuse(name + " needs one or two vertices");
      require_below(places, vertices, name + ".vertices");
    }
}

}  // namespace

void require_consistent(const PageData& data) {
  if (data.states.empty()) refuse("states is empty");
  const auto& first = data.states.front().cells;
  if (first.empty()) refuse("states[0].cells is empty");
  if (first.size() % 4 != 0)
    refuse("states[0].cells has " + std::to_string(first.size()) +
           " vertices, which is no multiple of 4");
  const auto cells = first.size() / 4;
  require_finite(data.points, "points");
  require_below(first, data.points.size() / 3, "states[0].cells");
  for (std::size_t s = 0; s < data.states.size(); ++s)
    require_state(data.states[s], first.size(), "states[" + std::to_string(s) + "]");
  if (!data.material_of_cell.empty()) {
    if (data.material_of_cell.size() != cells)
      refuse("material_of_cell has not one entry per cell");
    require_below(data.material_of_cell, data.materials.size(), "material_of_cell");
  }
  if (!data.cell_numbers.empty() && data.cell_numbers.size() != cells)
    refuse("cell_numbers has not one entry per cell");
  require_findings(data.findings, data.points.size() / 3);
}

std::array<double, 3> middle(const std::vector<double>& points) {
  std::array<double, 3> result{};
  for (std::size_t axis = 0; axis < 3 && !points.empty(); ++axis) {
    double least = points[axis], most = points[axis];
    for (std::size_t i = axis; i < points.size(); i += 3) {
      least = std::min(least, points[i]);
      most = std::max(most, points[i]);
    }
    result[axis] = 0.5 * (least + most);
  }
  return result;
}

std::vector<float> as_floats(const std::vector<double>& triples,
                             const std::array<double, 3>& origin) {
  std::vector<float> floats(triples.size());
  for (std::size_t i = 0; i < triples.size(); ++i)
    floats[i] = static_cast<float>(triples[i] - origin[i % 3]);
  return floats;
}

}  // namespace cleave::app::page
