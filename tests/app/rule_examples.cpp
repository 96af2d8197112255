#include "rule_examples.hpp"

#include <cmath>
#include <limits>

namespace cleave::app::test {
namespace {

using Points = std::vector<std::array<double, 3>>;
using Cells = std::vector<std::vector<Index>>;  // vertices from 1 on

Mesh mesh_of(const Points& points, const Cells& cells) {
  Mesh mesh;
  mesh.source = "example";
  mesh.points = points;
  mesh.dimension = static_cast<int>(cells.front().size()) - 1;
  for (std::uint64_t v = 1; v <= points.size(); ++v) mesh.vertex_numbers.push_back(v);
  Elements& elements = mesh.elements[static_cast<std::size_t>(mesh.dimension)];
  for (const auto& cell : cells) {
    for (const Index v : cell) elements.vertices.push_back(v - 1);
    elements.numbers.push_back(elements.numbers.size() + 1);
  }
  return mesh;
}

Mesh moebius_band() {
  constexpr Index kSections = 9;
  Points points;
  Cells cells;
  for (Index i = 0; i < kSections; ++i)
    for (const double side : {-0.4, 0.4}) {
      const double angle = 2 * M_PI * i / kSections;
      const double radius = 1.2 + side * std::cos(angle / 2);
      points.push_back(
          {radius * std::cos(angle), radius * std::sin(angle), side * std::sin(angle / 2)});
    }
  for (Index i = 0; i < kSections; ++i) {
    const Index a = 2 * i + 1, b = a + 1;
    const bool last = i + 1 == kSections;  // there the two sides change places
    const Index c = last ? 2 : a + 2, d = last ? 1 : a + 3;
    cells.push_back({a, c, b});
    cells.push_back({c, d, b});
  }
  return mesh_of(points, cells);
}

// The cone of a ring of six triangles.
Mesh cone_of_a_ring() {
  Points points = {{0, 0, 1.3}};
  for (const double radius : {0.75, 1.6})
    for (int i = 0; i < 3; ++i)
      points.push_back({radius * std::cos(2 * M_PI * i / 3 + 0.4),
                        radius * std::sin(2 * M_PI * i / 3 + 0.4), 0});
  Cells cells;
  for (Index i = 0; i < 3; ++i) {
    const Index a = 2 + i, b = 2 + (i + 1) % 3, c = a + 3, d = b + 3;
    cells.push_back({1, a, d, c});
    cells.push_back({1, a, b, d});
  }
  return mesh_of(points, cells);
}

// Two triangles of second order; the edge between them has a node of each.
Mesh torn_second_order() {
  Mesh mesh = mesh_of({{0, 0, 0},
                       {1.2, -0.2, 0},
                       {1, 1, 0},
                       {2.2, 0.7, 0},
                       {0.6, -0.1, 0},
                       {0.5, 0.5, 0},
                       {1.13, 0.22, 0},
                       {1.7, 0.25, 0},
                       {1.07, 0.58, 0},
                       {1.6, 0.85, 0}},
                      {{1, 2, 3}, {2, 4, 3}});
  mesh.elements[2].midside = {4, 5, 6, 7, 8, 9};
  return mesh;
}

}  // namespace

std::vector<RuleExample> rule_examples() {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  return {
      {"degenerate-cell",
       mesh_of({{0, 0, 0}, {1, 0, 0}, {0.5, 0.8, 0}, {1.6, 0.7, 0}}, {{1, 2, 3}, {2, 4, 4}}),
       "Two triangles, one of which is an edge in truth"},
      {"duplicate-cell", mesh_of({{0, 0, 0}, {1.4, 0, 0}, {0.7, 1, 0}}, {{1, 2, 3}, {2, 3, 1}}),
       "A triangle that is listed twice, the second drawn smaller"},
      {"bad-edge-node", torn_second_order(),
       "Two triangles of second order; each has a node of its own on their common edge"},
      {"facet-in-three-cells",
       mesh_of({{0, 0, -0.6}, {0, 0, 0.6}, {1, -0.3, 0}, {-1, -0.5, 0.1}, {0.2, 1.4, 0}},
               {{1, 2, 3}, {1, 2, 4}, {1, 2, 5}}),
       "Three triangles on one edge, like the pages of a book"},
      {"orientation-conflict",
       mesh_of({{0, 0, 0}, {1.2, 0, 0}, {1.2, 1, 0}, {0, 1, 0}}, {{1, 2, 3}, {1, 4, 3}}),
       "Two triangles whose vertices are listed in opposite senses"},
      {"non-orientable", moebius_band(), "A Moebius band of 18 triangles"},
      {"not-cut-regular",
       mesh_of({{0, 0, 0}, {-1, 0.6, 0}, {-1, -0.6, 0}, {1, -0.6, 0}, {1, 0.6, 0}},
               {{1, 2, 3}, {1, 4, 5}}),
       "Two triangles that touch in a vertex"},
      {"pinched-edge",
       mesh_of({{0, 0, -0.6},
                {0, 0, 0.6},
                {-1.1, -0.5, 0},
                {-1.0, 0.5, 0},
                {1.1, -0.5, 0},
                {1.0, 0.5, 0}},
               {{1, 2, 3, 4}, {1, 2, 6, 5}}),
       "Two tetrahedra that touch in an edge"},
      {"bad-vertex-link", cone_of_a_ring(),
       "Six tetrahedra that join a ring of six triangles to an apex; the ring is the link of "
       "vertex 1"},
      {"orphan-vertex", mesh_of({{0, 0, 0}, {1, 0, 0}, {0.5, 0.8, 0}, {1.6, 0.5, 0}}, {{1, 2, 3}}),
       "A triangle, and a vertex that it does not use"},
      {"inverted-cell",
       mesh_of({{0, 0, 0}, {1.6, 0, 0}, {0.8, 1.2, 0}, {1, 0.62, 0}}, {{1, 2, 3}, {2, 4, 3}}),
       "Two triangles; vertex 4 was moved across the edge they share"},
      {"flat-cell",
       mesh_of({{0, 0, 0}, {2, 0, 0}, {0.5, 0, 0}, {0.9, 0.9, 0}},
               {{1, 3, 4}, {3, 2, 4}, {1, 2, 3}}),
       "Three triangles; the vertices of the third are on one line"},
      {"not-finite",
       mesh_of({{0, 0, 0}, {1, 0, 0}, {0.5, 0.8, 0}, {1.7, kNan, 0}}, {{1, 2, 3}, {2, 4, 3}}),
       "Two triangles; nobody knows where vertex 4 is"},
      {"coincident-vertices",
       mesh_of({{0, 0, 0},
                {1, 0, 0},
                {1, 0.9, 0},
                {0, 0.9, 0},
                {1, 0, 0},
                {2, 0, 0},
                {2, 0.9, 0},
                {1, 0.9, 0}},
               {{1, 2, 3}, {1, 3, 4}, {5, 6, 7}, {5, 7, 8}}),
       "Two squares that lie side by side and are not joined"},
  };
}

}  // namespace cleave::app::test
