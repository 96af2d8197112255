#include "file_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace cleave::app {

using topology::CellId;
using topology::HalfFacetId;
using topology::VertexId;

std::uint64_t vertex_number(const Mesh& mesh, VertexId vertex) {
  return mesh.vertex_numbers.at(vertex.value);
}

std::uint64_t cell_number(const Mesh& mesh, CellId cell) {
  return mesh.cells().numbers.at(cell.value);
}

std::vector<std::uint64_t> cell_vertices(const Mesh& mesh, CellId cell) {
  const auto corners = static_cast<std::size_t>(mesh.dimension) + 1;
  std::vector<std::uint64_t> numbers;
  for (std::size_t i = 0; i < corners; ++i)
    numbers.push_back(vertex_number(mesh, {mesh.cells().vertices.at(corners * cell.value + i)}));
  return numbers;
}

CellId cell_of(const Mesh& mesh, HalfFacetId h) {
  return {h.value / static_cast<Index>(mesh.dimension + 1)};
}

std::vector<std::uint64_t> facet_vertices(const Mesh& mesh, HalfFacetId h) {
  auto numbers = cell_vertices(mesh, cell_of(mesh, h));
  numbers.erase(numbers.begin() + h.value % static_cast<Index>(mesh.dimension + 1));
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

std::vector<std::vector<std::uint64_t>> facets_vertices(const Mesh& mesh,
                                                        const topology::FacetSet& facets) {
  std::vector<std::vector<std::uint64_t>> all;
  for (const HalfFacetId h : facets.half_facets()) all.push_back(facet_vertices(mesh, h));
  return all;
}

std::string listed(const std::vector<std::uint64_t>& numbers) {
  return fmt::format("{}", fmt::join(numbers, " "));
}

std::string facets_listed(const std::vector<std::vector<std::uint64_t>>& facets) {
  std::string text;
  for (const auto& facet : facets)
    text += fmt::format("{}({})", text.empty() ? "" : ", ", listed(facet));
  return text;
}

std::string counted(std::size_t count, const std::string& word, const std::string& plural) {
  return fmt::format("{} {}", count, count == 1 ? word : plural.empty() ? word + "s" : plural);
}

namespace {

using namespace topology;

// The words for one kind of violation each.
struct Describer {
  const Mesh& mesh;

  std::uint64_t cell(CellId c) const { return cell_number(mesh, c); }
  std::uint64_t vertex(VertexId v) const { return vertex_number(mesh, v); }
  std::string facet(HalfFacetId h) const { return listed(facet_vertices(mesh, h)); }

  std::string operator()(const DegenerateCell& v) const {
    return fmt::format("cell {} ({}) names vertex {} more than once", cell(v.cell),
                       listed(cell_vertices(mesh, v.cell)), vertex(v.repeated));
  }
  std::string operator()(const VertexOutOfRange& v) const {
    return fmt::format("cell {} names a vertex that does not exist", cell(v.cell));
  }
  std::string operator()(const DuplicateCell& v) const {
    return fmt::format("cells {} and {} have the same vertices ({})", cell(v.first), cell(v.second),
                       listed(cell_vertices(mesh, v.first)));
  }
  std::string operator()(const FacetInThreeCells& v) const {
    std::vector<std::uint64_t> cells;
    for (const HalfFacetId h : v.half_facets) cells.push_back(cell(cell_of(mesh, h)));
    return fmt::format("facet ({}) is in {} cells: {}", facet(v.half_facets.front()), cells.size(),
                       listed(cells));
  }
  std::string operator()(const OrientationConflict& v) const {
    return fmt::format("cells {} and {} are oriented against each other across facet ({})",
                       cell(cell_of(mesh, v.one)), cell(cell_of(mesh, v.other)), facet(v.one));
  }
  std::string operator()(const NonOrientable& v) const {
    std::vector<std::uint64_t> cells;
    for (const HalfFacetId h : v.loop) cells.push_back(cell(cell_of(mesh, h)));
    return fmt::format(
        "the cells cannot be oriented: the closed chain of {} cells {} comes back "
        "reversed",
        cells.size(), listed(cells));
  }
  std::string operator()(const NotCutRegular& v) const {
    return fmt::format(
        "the cells around vertex {} form {} parts that share no facet there, such as "
        "those of cells {} and {}",
        vertex(v.vertex), v.parts, cell(v.one_part), cell(v.other_part));
  }
  std::string operator()(const PinchedSimplex& v) const {
    std::vector<std::uint64_t> ends;
    for (const VertexId end : v.simplex) ends.push_back(vertex(end));
    return fmt::format(
        "the cells around edge ({}) form {} parts that share no facet there, such as "
        "those of cells {} and {}",
        listed(ends), v.parts, cell(v.one_part), cell(v.other_part));
  }
  std::string operator()(const BadVertexLink& v) const {
    return fmt::format(
        "the surroundings of vertex {} are neither a ball nor a half-ball (its link "
        "has Euler characteristic {} and {} boundary components)",
        vertex(v.vertex), v.euler_characteristic, v.boundary_components);
  }
  std::string operator()(const OrphanVertex& v) const {
    return fmt::format("no cell uses vertex {}", vertex(v.vertex));
  }
};

}  // namespace

std::string describe_in_file(const Violation& violation, const Mesh& mesh) {
  return std::visit(Describer{mesh}, violation);
}

}  // namespace cleave::app
