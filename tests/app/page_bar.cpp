#include "page_bar.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <utility>

namespace cleave::app {
namespace {

constexpr std::array<std::uint32_t, 3> kCubes{16, 4, 4};
constexpr std::uint32_t kMiddle = 8;
constexpr std::uint32_t kVertices = (kCubes[0] + 1) * (kCubes[1] + 1) * (kCubes[2] + 1);
constexpr double kEdge = 10;

using Place = std::array<std::uint32_t, 3>;

std::uint32_t vertex_at(const Place& p) {
  return p[0] + (kCubes[0] + 1) * (p[1] + (kCubes[1] + 1) * p[2]);
}

Place place_of(std::uint32_t vertex) {
  const std::uint32_t along = kCubes[0] + 1, across = kCubes[1] + 1;
  return {vertex % along, vertex / along % across, vertex / along / across};
}

/// The six cells of a cube: the paths along its edges from one corner to the opposite one.
void add_cube(const Place& at, std::vector<std::uint32_t>& cells) {
  std::array<std::size_t, 3> order{0, 1, 2};
  do {
    Place p = at;
    cells.push_back(vertex_at(p));
    for (const auto axis : order) {
      ++p[axis];
      cells.push_back(vertex_at(p));
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

bool in_right_half(const std::vector<std::uint32_t>& cells, std::size_t cell) {
  for (std::size_t i = 0; i < 4; ++i)
    if (place_of(cells[4 * cell + i])[0] > kMiddle) return true;
  return false;
}

/// Half-facets of the left half on the middle plane whose vertices all have z in [low, high].
std::vector<std::uint32_t> middle_facets(const std::vector<std::uint32_t>& cells, std::uint32_t low,
                                         std::uint32_t high) {
  std::vector<std::uint32_t> facets;
  for (std::uint32_t h = 0; h < cells.size(); ++h) {
    bool inside = !in_right_half(cells, h / 4);
    for (std::uint32_t i = 0; i < 4; ++i) {
      const auto p = place_of(cells[h - h % 4 + i]);
      if (i != h % 4) inside = inside && p[0] == kMiddle && p[2] >= low && p[2] <= high;
    }
    if (inside) facets.push_back(h);
  }
  return facets;
}

/// Corners right of the middle plane, at vertices on it with z > rim, get copies.
std::vector<std::uint32_t> cut_above(const std::vector<std::uint32_t>& cells, int rim,
                                     std::vector<std::uint32_t>& parent) {
  auto result = cells;
  std::vector<std::uint32_t> copy_of(parent.size(), 0);
  for (std::size_t h = 0; h < cells.size(); ++h) {
    const auto p = place_of(cells[h]);
    if (p[0] != kMiddle || static_cast<int>(p[2]) <= rim || !in_right_half(cells, h / 4)) continue;
    auto& copy = copy_of[cells[h]];
    if (copy == 0) {
      copy = static_cast<std::uint32_t>(parent.size());
      parent.push_back(cells[h]);
    }
    result[h] = copy;
  }
  return result;
}

std::vector<std::uint32_t> identity(std::size_t count) {
  std::vector<std::uint32_t> ids(count);
  for (std::uint32_t i = 0; i < count; ++i) ids[i] = i;
  return ids;
}

/// Each half turns by `angle` about the middle of the bar and moves away by `gap`; vertices of the
/// middle plane that have no copy stay.
std::vector<double> bent(const std::vector<std::uint32_t>& parent, double angle, double gap) {
  const std::set<std::uint32_t> copied(parent.begin() + kVertices, parent.end());
  std::vector<double> u;
  for (std::size_t v = 0; v < parent.size(); ++v) {
    const auto p = place_of(parent[v]);
    const bool right = p[0] > kMiddle || v >= kVertices;
    const double x = kEdge * (static_cast<double>(p[0]) - kMiddle), z = kEdge * (p[2] - 2.0);
    const bool hinge = p[0] == kMiddle && copied.count(parent[v]) == 0;
    const double side = hinge ? 0.0 : right ? 1.0 : -1.0, sag = side * angle;
    u.push_back(side * gap + (std::cos(sag) - 1) * x + std::sin(sag) * z);
    u.push_back(0);
    u.push_back(-std::sin(sag) * x + (std::cos(sag) - 1) * z);
  }
  return u;
}

PageSolve decaying_solve(std::string label, double rate, int count) {
  PageSolve solve{std::move(label), "converged", 1e-8, {}};
  for (int i = 0; i <= count; ++i) {
    const double wave = 1 + 0.4 * std::sin(0.9 * i);
    solve.samples.push_back({i, 2.3e-4 * i, std::exp(-rate * i) * wave,
                             i + 4 > count ? std::nan("") : 0.6 * std::exp(-1.05 * rate * i)});
  }
  return solve;
}

}  // namespace

PageData bar_cut_in_two() {
  PageData data;
  data.title = "Bar <cut> in two & \"bent\"";
  data.summary = {"1536 cells, 425 vertices", "one piece before, two after"};
  data.length_unit = "mm";
  std::vector<std::uint32_t> cells;
  for (std::uint32_t z = 0; z < kCubes[2]; ++z)
    for (std::uint32_t y = 0; y < kCubes[1]; ++y)
      for (std::uint32_t x = 0; x < kCubes[0]; ++x) add_cube({x, y, z}, cells);
  for (std::uint32_t v = 0; v < kVertices; ++v)
    for (const auto step : place_of(v)) data.points.push_back(kEdge * step + 200);
  const auto parents = identity(kVertices);
  auto half_parents = parents, full_parents = parents;
  const auto half = cut_above(cells, 2, half_parents), full = cut_above(cells, -1, full_parents);
  const auto half_opened = middle_facets(cells, 2, 4);
  const std::vector<std::uint32_t> shut{middle_facets(cells, 0, 1).front()};
  data.states = {
      {"At rest", cells, {}, {}, {}, 1, -1, ""},
      {"Half cut", half, {}, half_opened, shut, 1, -1, ""},
      {"Under load", half, bent(half_parents, 0.12, 0), half_opened, shut, 1, 64, "converged"},
      {"Cut through",
       full,
       bent(full_parents, 0.2, 9),
       middle_facets(cells, 0, 4),
       {},
       2,
       500,
       "iteration_limit"}};
  data.materials = {"left", "right </script>"};
  for (std::size_t c = 0; c < kBarCells; ++c) {
    data.material_of_cell.push_back(in_right_half(cells, c) ? 1 : 0);
    data.cell_numbers.push_back((std::uint64_t{1} << 53) + 1 +
                                c);  // more than a double can tell apart
  }
  data.findings = {{"Regularised vertices", {{"vertex 500: a copy of 8", {8}}}},
                   {"Pinched edges", {{"edge 424 425", {423, 424}}, {"edge 1 18", {0, 17}}}}};
  data.solves = {decaying_solve("under load", 0.29, 64), decaying_solve("cut through", 0.05, 500)};
  data.solves[1].outcome = "iteration_limit";
  return data;
}

PageData bar_at_rest() {
  const auto all = bar_cut_in_two();
  PageData data;
  data.title = "Bar at rest";
  data.points = all.points;
  data.states = {all.states.front()};
  return data;
}

}  // namespace cleave::app
