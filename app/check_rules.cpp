#include "check_rules.hpp"

#include <fmt/format.h>

#include <array>
#include <stdexcept>

namespace cleave::app {
namespace {

constexpr std::string_view kByLevel =
    "error, if the required level asks for it (--require, usually cut-regular); else warning";

constexpr std::array kRules = {
    Rule{"degenerate-cell", "a cell names a vertex twice", "Cells", "error", Severity::error,
         "A cell names one of its vertices more than once, so that it is a simplex of a lower "
         "dimension.",
         "It has no volume and fewer facets than its neighbours believe; every method that divides "
         "by the volume fails.",
         "Delete the cell. Where vertices were merged too eagerly, merge with a smaller tolerance.",
         "Look up the cell of the witness in the file: `repeated` stands in it twice."},
    Rule{"duplicate-cell", "two cells have the same vertices", "Cells", "error", Severity::error,
         "Two cells of the file have the same vertices, in the same or in another order.",
         "Stiffness and mass count twice there, and the facets between the cell and its neighbours "
         "have three sides.",
         "Delete one of the two; often a part was exported twice.",
         "Sort the vertices of the two cells of the witness: the lists are equal."},
    Rule{"bad-edge-node", "nodes of second order and edges do not belong together", "Cells",
         "error", Severity::error,
         "In a mesh of second order each edge has one node besides its two ends, the same in all "
         "its "
         "cells. Here an element lacks its nodes, or a node is missing, is the end of an edge as "
         "well, or serves two edges, or an edge has two nodes.",
         "The shape of neighbouring cells differs along their common edge: displacements tear "
         "there, "
         "and a cut cannot carry the nodes along.",
         "Make the mesh of second order from that of first order once more, and merge vertices "
         "before, not after.",
         "Look up the elements that have the edge of the witness: their nodes on it differ, or the "
         "node of the witness is listed by them on different edges."},
    Rule{
        "facet-in-three-cells", "a facet belongs to three cells or more", "Facets", "error",
        Severity::error,
        "A facet (a triangle between tetrahedra, an edge between triangles) belongs to three cells "
        "or more.",
        "No solid body in space looks like that: which side is inside is undefined. Surfaces that "
        "branch do, but then no side can be told from the other.",
        "Mostly two parts overlap or were glued along a shared layer: delete the duplicates of the "
        "witness. A surface that is meant to branch must be divided into parts that do not.",
        "Each cell of the witness has all the vertices of `facet`."},
    Rule{
        "orientation-conflict", "two cells are oriented against each other", "Orientation", "error",
        Severity::error,
        "Two cells induce the same orientation on their common facet: the order of the vertices of "
        "one of them is mirrored relative to the other, and some other order would mend it.",
        "Surface normals and fluxes flip there. Cleave itself does not need the order to agree, "
        "and keeps it.",
        "Swap two vertices of one of the two cells: of the one that is also reported as inverted, "
        "if one is.",
        "Write the facet's vertices in the order in which each of the two cells goes round them, "
        "seen from the cell's remaining vertex: the two orders are the same up to a rotation. In a "
        "sound mesh they are opposite."},
    Rule{
        "non-orientable", "cells cannot be oriented alike", "Orientation", "error", Severity::error,
        "No order of vertices makes all cells agree, as in a Moebius band. The witness is a closed "
        "chain of cells: leave each cell through the facet in the same place of the list into the "
        "next cell, the last into the first, and you come back mirrored.",
        "Nothing has an inside then: no outward normal, no sign of a volume. A solid in space is "
        "never like that; a surface may be.",
        "Look along the chain for the cell that is glued wrongly. In a solid the numbering of the "
        "file is wrong, or periodic ends were identified the wrong way round.",
        "Walk the chain and count the steps whose two cells are oriented against each other (see "
        "orientation-conflict): the number is odd, and swapping vertices of a cell changes it by "
        "an even number."},
    Rule{"not-cut-regular", "cells meet in a vertex without sharing facets there", "Vertices",
         kByLevel, Severity::error,
         "The cells around a vertex form several parts that share no facet with that vertex: two "
         "bodies, or two ends of one body, touch in a point or in an edge.",
         "A finite-element solution is tied together there by a hinge that does not exist, and "
         "rigid parts hang in a point. Meshes made from the voxels of images have such vertices.",
         "`cleave cut` gives each part its own copy of the vertex before it cuts, and says so; or "
         "thicken the neck by refining.",
         "Start at the first cell of the witness and step to every cell that shares a facet with "
         "it which contains the vertex, and so on: the second cell is never reached."},
    Rule{
        "pinched-edge", "cells meet in an edge without sharing facets there", "Edges", kByLevel,
        Severity::warning,
        "The cells around an edge form several parts that touch in this edge only.",
        "The parts turn about the edge like a door on its hinge. Such an edge may remain when both "
        "of its ends are cut-regular; cuts are sound with it.",
        "`cleave cut` mends those whose ends are not cut-regular. For the others, copy the ends of "
        "the edge for one of the parts by hand, or thicken the place by refining.",
        "Start at the first cell of the witness and step to every cell that shares a facet with "
        "it which contains the edge, and so on: the second cell is never reached."},
    Rule{
        "bad-vertex-link", "the surroundings of a vertex are no ball or half-ball", "Vertices",
        kByLevel, Severity::warning,
        "The link of a vertex, that is the facets opposite it in its cells, is neither a sphere "
        "nor "
        "a disc, so the surroundings of the vertex look neither like a ball nor like a half-ball.",
        "Methods that need a manifold boundary fail there. Cuts are sound with it.",
        "Subdivide around the vertex, or give it a copy where two parts of the boundary meet.",
        "Count vertices, edges and triangles of the link: vertices - edges + triangles is "
        "`euler_characteristic` (2 for a sphere, 1 for a disc). The link's edges with one triangle "
        "form `boundary_components` closed curves (none for a sphere, one for a disc)."},
    Rule{"orphan-vertex", "no cell uses a vertex", "Vertices", "warning", Severity::warning,
         "No cell uses the vertex; it is no node of second order either.",
         "It gives a solver a row of zeros, and moves the bounding box of the mesh.",
         "Delete it. `cleave cut` drops it and says so.",
         "Search the file's cells for the vertex's number: it is in none of them."},
    Rule{
        "inverted-cell", "the vertices of a cell are in mirrored order", "Shape", "error",
        Severity::error,
        "The order of a cell's vertices is mirrored: a tetrahedron has negative volume, a triangle "
        "in a plane z = constant negative area. The sign is exact on the numbers of the file.",
        "Jacobians are negative there. `cleave cut` does not need the signs to agree.",
        "Swap two vertices of the cell. If it overlaps its neighbours then, the mesh is tangled: "
        "smooth it or make it anew. If all cells are reported, the file has the mirrored "
        "convention; set the rule to off or swap two vertices everywhere.",
        "The determinant of the edges from the first vertex of the witness to the others, in their "
        "order, is negative."},
    Rule{"flat-cell", "a cell has no height", "Shape", "error", Severity::error,
         "The volume of a cell (area, length) is exactly zero, or its least height is below "
         "`flat_ratio` (usually 1e-10) of its longest edge.",
         "What is computed from its shape in double precision has at most a few right digits.",
         "Remove the cell by swapping or collapsing edges; slivers mostly come from Delaunay "
         "meshing "
         "without optimisation. Thin cells above the threshold are the mesh's business.",
         "`relative_height` is D times the cell's volume, over its largest facet, over its longest "
         "edge."},
    Rule{"not-finite", "a coordinate is not a number, or infinite", "Shape", "error",
         Severity::error, "A coordinate of a vertex is NaN or infinite.",
         "Everything that is computed from it is NaN as well.",
         "Look at the program that wrote the file.", "Look up the vertex in the file."},
    Rule{
        "coincident-vertices", "separate vertices are in the same place", "Shape",
        "warning; note, where the file shows that a cut separated them", Severity::warning,
        "Several vertices have the same coordinates (or are within `coincident_distance` of each "
        "other, if a configuration gives one). The cells around one do not know those around the "
        "other, even where they look joined.",
        "Sometimes this is meant: after a cut the two sides lie in the same place. Otherwise parts "
        "that should be one were never merged, and come apart under load. It is a note where the "
        "file shows the intent: the vertices are on the two sides NAME_minus and NAME_plus of a "
        "cut, in cohesive elements, or copies of one `parent`.",
        "If the parts should be one, merge the vertices (in gmsh: `Coherence Mesh;`). "
        "If they are meant, name the two sides as groups "
        "NAME_minus and NAME_plus, or set the rule to note or off.",
        "Look up the coordinates of the vertices of the witness; `distance` is the largest between "
        "the first and another of them."},
};

// `text` in lines of at most `width` characters, each after `indent`.
std::string wrapped(std::string_view text, std::size_t width, const std::string& indent) {
  std::string lines, line;
  const auto end_line = [&] {
    if (!line.empty()) lines += indent + line + '\n';
    line.clear();
  };
  while (!text.empty()) {
    const std::size_t end = text.find(' ');
    const std::string_view word = text.substr(0, end);
    if (!line.empty() && indent.size() + line.size() + 1 + word.size() > width) end_line();
    line += (line.empty() ? "" : " ") + std::string(word);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  end_line();
  return lines;
}

}  // namespace

std::span<const Rule> rules() { return kRules; }

const Rule* find_rule(std::string_view name) {
  for (const Rule& rule : kRules)
    if (rule.name == name) return &rule;
  return nullptr;
}

std::size_t place_of_rule(std::string_view name) {
  const Rule* rule = find_rule(name);
  if (rule == nullptr) throw std::logic_error("no rule '" + std::string(name) + "'");
  return static_cast<std::size_t>(rule - kRules.data());
}

std::string rule_names() {
  std::string names;
  for (const Rule& rule : kRules) names.append(names.empty() ? "" : ", ").append(rule.name);
  return names;
}

std::string explanation(const Rule& rule) {
  const auto part = [](const char* heading, std::string_view text) {
    return fmt::format("{}\n{}", heading, wrapped(text, 80, "  "));
  };
  return fmt::format("{}: {}\n\n", rule.name, rule.title) + part("Meaning", rule.meaning) +
         part("Why it matters", rule.matters) + part("How to mend it", rule.mend) +
         part("The witness by hand", rule.by_hand) + part("Severity", rule.severity);
}

std::string explanation_markdown(const Rule& rule) {
  return fmt::format(
      "{}\n\n**Why it matters.** {}\n\n**How to mend it.** {}\n\n**The witness by hand.** {}\n\n"
      "**Severity.** {}.\n",
      rule.meaning, rule.matters, rule.mend, rule.by_hand, rule.severity);
}

std::string list_of_rules() {
  std::string lines;
  for (const Rule& rule : kRules)
    lines += fmt::format("{:22}{:9}{}\n", rule.name, name(rule.usual), rule.title);
  return lines;
}

}  // namespace cleave::app
