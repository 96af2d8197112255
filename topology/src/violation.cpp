#include "cleave/topology/violation.hpp"

#include <string>

namespace cleave::topology {
namespace {

template <class... Fs>
struct Overloaded : Fs... {
  using Fs::operator()...;
};
template <class... Fs>
Overloaded(Fs...) -> Overloaded<Fs...>;

template <class Tag>
std::string to_text(Id<Tag> id) {
  return std::to_string(id.value);
}

template <class Ids>
std::string list(const Ids& ids) {
  std::string text;
  for (const auto id : ids) text += (text.empty() ? "" : " ") + to_text(id);
  return text;
}

std::string parts(std::size_t count, CellId one, CellId other) {
  return " fall into " + std::to_string(count) + " parts (cell " + to_text(one) +
         " is in one, cell " + to_text(other) + " in another)";
}

}  // namespace

std::string_view name(Level level) {
  switch (level) {
    case Level::none:
      return "none";
    case Level::pseudo_manifold:
      return "pseudo-manifold";
    case Level::cut_regular:
      return "cut-regular";
    case Level::edge_regular:
      return "edge-regular";
    case Level::manifold:
      return "manifold";
  }
  return "";
}

std::string_view rule(const Violation& violation) {
  return std::visit(Overloaded{[](const DegenerateCell&) { return "degenerate-cell"; },
                               [](const VertexOutOfRange&) { return "vertex-out-of-range"; },
                               [](const DuplicateCell&) { return "duplicate-cell"; },
                               [](const FacetInThreeCells&) { return "facet-in-three-cells"; },
                               [](const OrientationConflict&) { return "orientation-conflict"; },
                               [](const NonOrientable&) { return "non-orientable"; },
                               [](const NotCutRegular&) { return "not-cut-regular"; },
                               [](const PinchedSimplex&) { return "pinched-edge"; },
                               [](const BadVertexLink&) { return "bad-vertex-link"; },
                               [](const OrphanVertex&) { return "orphan-vertex"; }},
                    violation);
}

Level breaks(const Violation& violation) {
  return std::visit(Overloaded{[](const OrientationConflict&) { return Level::none; },
                               [](const NonOrientable&) { return Level::none; },
                               [](const OrphanVertex&) { return Level::none; },
                               [](const NotCutRegular&) { return Level::cut_regular; },
                               [](const PinchedSimplex&) { return Level::edge_regular; },
                               [](const BadVertexLink&) { return Level::manifold; },
                               [](const auto&) { return Level::pseudo_manifold; }},
                    violation);
}

std::string describe(const Violation& violation) {
  return std::visit(
      Overloaded{
          [](const DegenerateCell& v) {
            return "cell " + to_text(v.cell) + " names vertex " + to_text(v.repeated) + " twice";
          },
          [](const VertexOutOfRange& v) {
            return "cell " + to_text(v.cell) + " names vertex " + to_text(v.vertex) +
                   ", which does not exist";
          },
          [](const DuplicateCell& v) {
            return "cells " + to_text(v.first) + " and " + to_text(v.second) +
                   " have the same vertices";
          },
          [](const FacetInThreeCells& v) {
            return "one facet belongs to " + std::to_string(v.half_facets.size()) +
                   " cells (half-facets " + list(v.half_facets) + ")";
          },
          [](const OrientationConflict& v) {
            return "half-facets " + to_text(v.one) + " and " + to_text(v.other) +
                   " are mates with the same orientation";
          },
          [](const NonOrientable& v) {
            return "no orientation is coherent along the loop of half-facets " + list(v.loop);
          },
          [](const NotCutRegular& v) {
            return "the cells around vertex " + to_text(v.vertex) +
                   parts(v.parts, v.one_part, v.other_part);
          },
          [](const PinchedSimplex& v) {
            return "the cells around simplex " + list(v.simplex) +
                   parts(v.parts, v.one_part, v.other_part);
          },
          [](const BadVertexLink& v) {
            return "the link of vertex " + to_text(v.vertex) +
                   " is neither a sphere nor a ball (Euler characteristic " +
                   std::to_string(v.euler_characteristic) + ", boundary components " +
                   std::to_string(v.boundary_components) + ")";
          },
          [](const OrphanVertex& v) { return "no cell uses vertex " + to_text(v.vertex); }},
      violation);
}

namespace {
std::string describe_all(const std::vector<Violation>& all) {
  if (all.empty()) return "no violation";
  std::string text = describe(all.front());
  if (all.size() > 1) text += " (and " + std::to_string(all.size() - 1) + " more violations)";
  return text;
}
}  // namespace

InvalidComplex::InvalidComplex(std::vector<Violation> all)
    : std::invalid_argument(describe_all(all)), violations(std::move(all)) {}

}  // namespace cleave::topology
