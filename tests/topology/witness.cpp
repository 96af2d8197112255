#include "witness.hpp"

#include <algorithm>
#include <set>
#include <vector>

#include "cleave/support/reference.hpp"

namespace cleave::topology {
namespace {

using support::induced_sign;
using support::sorted_facet;

template <int D>
std::set<VertexId> vertex_set(const CellSoup<D>& soup, CellId cell) {
  return {soup.cells.at(cell.value).begin(), soup.cells.at(cell.value).end()};
}

std::string unless(bool holds, const char* claim) { return holds ? "" : claim; }

/// The facet-connected components of the cells that contain `simplex`, as one number per cell.
template <int D>
std::map<std::size_t, std::size_t> parts_around(const CellSoup<D>& soup,
                                                const std::vector<VertexId>& simplex) {
  std::vector<Cell<D>> star;
  std::vector<std::size_t> number;
  for (std::size_t c = 0; c < soup.cells.size(); ++c) {
    const std::set<VertexId> cell(soup.cells[c].begin(), soup.cells[c].end());
    if (!std::includes(cell.begin(), cell.end(), simplex.begin(), simplex.end())) continue;
    star.push_back(soup.cells[c]);
    number.push_back(c);
  }
  const auto component = support::components<D>(star);
  std::map<std::size_t, std::size_t> parts;
  for (std::size_t i = 0; i < star.size(); ++i) parts[number[i]] = component[i];
  return parts;
}

// Cells of a star that share a facet may share one without the simplex only if they are equal, so
// facet-connected in the star is facet-connected as a mesh of its own.
template <int D>
std::string refute_parts(const CellSoup<D>& soup, const std::vector<VertexId>& simplex, CellId one,
                         CellId other, std::size_t parts) {
  const auto part = parts_around<D>(soup, simplex);
  if (part.count(one.value) == 0 || part.count(other.value) == 0) return "cells are not around it";
  if (part.at(one.value) == part.at(other.value)) return "both cells are in one part";
  std::set<std::size_t> distinct;
  for (const auto& [cell, number] : part) distinct.insert(number);
  return unless(distinct.size() == parts, "the number of parts is another");
}

template <int D>
struct Refute {
  const CellSoup<D>& soup;
  std::vector<std::int8_t> as_written = std::vector<std::int8_t>(soup.cells.size(), 1);

  std::string operator()(const DegenerateCell& v) const {
    const auto& cell = soup.cells.at(v.cell.value);
    return unless(std::count(cell.begin(), cell.end(), v.repeated) >= 2, "it is not repeated");
  }
  std::string operator()(const VertexOutOfRange& v) const {
    return unless(
        vertex_set(soup, v.cell).count(v.vertex) == 1 && v.vertex.value >= soup.vertex_count,
        "the vertex is not in the cell, or in range");
  }
  std::string operator()(const DuplicateCell& v) const {
    return unless(v.first < v.second && vertex_set(soup, v.first) == vertex_set(soup, v.second),
                  "the cells differ");
  }
  std::string operator()(const FacetInThreeCells& v) const {
    if (v.half_facets.size() < 3) return "fewer than three";
    const auto facets = support::facets_of<D>(soup.cells);
    return unless(facets.at(sorted_facet<D>(soup.cells, v.half_facets[0])) == v.half_facets,
                  "these are not the half-facets of one facet");
  }
  std::string operator()(const OrientationConflict& v) const {
    const auto& signs = soup.signs.empty() ? as_written : soup.signs;
    return unless(support::mates_of<D>(soup.cells).at(v.one.value) == v.other &&
                      induced_sign<D>(soup.cells, signs, v.one) ==
                          induced_sign<D>(soup.cells, signs, v.other),
                  "the two are no mates, or opposite");
  }
  std::string operator()(const NonOrientable& v) const {
    const auto mates = support::mates_of<D>(soup.cells);
    std::size_t alike = 0;
    for (std::size_t i = 0; i < v.loop.size(); ++i) {
      const auto mate = mates.at(v.loop[i].value);
      if (!mate) return "the loop leaves through the boundary";
      if (cell_of<D>(*mate) != cell_of<D>(v.loop[(i + 1) % v.loop.size()]))
        return "the loop is broken";
      if (induced_sign<D>(soup.cells, as_written, v.loop[i]) ==
          induced_sign<D>(soup.cells, as_written, *mate))
        ++alike;
    }
    return unless(alike % 2 == 1, "the loop keeps its orientation");
  }
  std::string operator()(const NotCutRegular& v) const {
    return refute_parts<D>(soup, {v.vertex}, v.one_part, v.other_part, v.parts);
  }
  std::string operator()(const PinchedSimplex& v) const {
    if (!std::is_sorted(v.simplex.begin(), v.simplex.end())) return "its vertices are not sorted";
    return refute_parts<D>(soup, v.simplex, v.one_part, v.other_part, v.parts);
  }
  std::string operator()(const BadVertexLink& v) const {
    std::set<std::set<VertexId>> link;  // all its simplices
    for (const Cell<D>& cell : soup.cells) {
      if (std::find(cell.begin(), cell.end(), v.vertex) == cell.end()) continue;
      for (unsigned subset = 1; subset < 1U << cell.size(); ++subset) {
        std::set<VertexId> face;
        for (std::size_t i = 0; i < cell.size(); ++i)
          if ((subset >> i & 1U) != 0) face.insert(cell[i]);
        if (face.count(v.vertex) == 0) link.insert(face);
      }
    }
    int characteristic = 0;
    for (const auto& face : link) characteristic += face.size() % 2 == 1 ? 1 : -1;
    if (characteristic != v.euler_characteristic) return "the Euler characteristic is another";
    const int sphere = D % 2 == 0 ? 0 : 2;
    return unless(!(v.boundary_components == 0 && characteristic == sphere) &&
                      !(v.boundary_components == 1 && characteristic == 1),
                  "the link is a sphere or a ball");
  }
  std::string operator()(const OrphanVertex& v) const {
    for (Index c = 0; c < soup.cells.size(); ++c)
      if (vertex_set(soup, {c}).count(v.vertex) != 0) return "a cell uses it";
    return unless(v.vertex.value < soup.vertex_count, "it does not exist");
  }
};

}  // namespace

template <int D>
std::string refute(const Violation& violation, const CellSoup<D>& soup) {
  return std::visit(Refute<D>{soup}, violation);
}

template std::string refute<1>(const Violation&, const CellSoup<1>&);
template std::string refute<2>(const Violation&, const CellSoup<2>&);
template std::string refute<3>(const Violation&, const CellSoup<3>&);
template std::string refute<4>(const Violation&, const CellSoup<4>&);

}  // namespace cleave::topology
