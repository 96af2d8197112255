#include "finding.hpp"

#include "file_words.hpp"

namespace cleave::app {
namespace {

using namespace topology;
using Witness = std::vector<std::pair<std::string, WitnessValue>>;

struct WitnessMaker {
  const Mesh& mesh;

  std::uint64_t cell(CellId c) const { return cell_number(mesh, c); }
  std::uint64_t vertex(VertexId v) const { return vertex_number(mesh, v); }
  std::vector<std::uint64_t> cells(const std::vector<HalfFacetId>& half_facets) const {
    std::vector<std::uint64_t> numbers;
    for (const HalfFacetId h : half_facets) numbers.push_back(cell(cell_of(mesh, h)));
    return numbers;
  }

  Witness operator()(const DegenerateCell& v) const {
    return {{"cell", cell(v.cell)},
            {"vertices", cell_vertices(mesh, v.cell)},
            {"repeated", vertex(v.repeated)}};
  }
  Witness operator()(const VertexOutOfRange& v) const {
    return {{"cell", cell(v.cell)}, {"place", std::uint64_t{v.vertex.value}}};
  }
  Witness operator()(const DuplicateCell& v) const {
    return {{"cells", std::vector{cell(v.first), cell(v.second)}},
            {"vertices", cell_vertices(mesh, v.first)}};
  }
  Witness operator()(const FacetInThreeCells& v) const {
    return {{"facet", facet_vertices(mesh, v.half_facets.front())},
            {"cells", cells(v.half_facets)}};
  }
  Witness operator()(const OrientationConflict& v) const {
    return {{"facet", facet_vertices(mesh, v.one)}, {"cells", cells({v.one, v.other})}};
  }
  Witness operator()(const NonOrientable& v) const {
    std::vector<std::vector<std::uint64_t>> facets;
    for (const HalfFacetId h : v.loop) facets.push_back(facet_vertices(mesh, h));
    return {{"cells", cells(v.loop)}, {"facets", facets}};
  }
  Witness operator()(const NotCutRegular& v) const {
    return {{"vertex", vertex(v.vertex)},
            {"cells", std::vector{cell(v.one_part), cell(v.other_part)}},
            {"parts", std::uint64_t{v.parts}}};
  }
  Witness operator()(const PinchedSimplex& v) const {
    std::vector<std::uint64_t> ends;
    for (const VertexId end : v.simplex) ends.push_back(vertex(end));
    return {{"edge", ends},
            {"cells", std::vector{cell(v.one_part), cell(v.other_part)}},
            {"parts", std::uint64_t{v.parts}}};
  }
  Witness operator()(const BadVertexLink& v) const {
    return {{"vertex", vertex(v.vertex)},
            {"euler_characteristic", std::int64_t{v.euler_characteristic}},
            {"boundary_components", std::int64_t{v.boundary_components}}};
  }
  Witness operator()(const OrphanVertex& v) const { return {{"vertex", vertex(v.vertex)}}; }
};

Severity severity(const Violation& violation, Level required) {
  if (std::holds_alternative<OrphanVertex>(violation)) return Severity::warning;
  return breaks(violation) <= required ? Severity::error : Severity::warning;
}

}  // namespace

Finding finding_of(const Violation& violation, const Mesh& mesh, Level required) {
  return {std::string(rule(violation)), severity(violation, required),
          describe_in_file(violation, mesh), std::visit(WitnessMaker{mesh}, violation)};
}

}  // namespace cleave::app
