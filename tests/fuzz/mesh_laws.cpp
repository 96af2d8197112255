#include "mesh_laws.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "target.hpp"

namespace cleave::fuzz {
namespace {

using app::Field;
using app::Mesh;

void require_below(const std::vector<std::uint32_t>& places, std::size_t count) {
  for (const std::uint32_t place : places) FUZZ_REQUIRE(place < count);
}

void require_values(const std::vector<Field>& fields, std::size_t count) {
  for (const Field& field : fields) {
    FUZZ_REQUIRE(field.components >= 1);
    FUZZ_REQUIRE(field.values.size() == count * static_cast<std::size_t>(field.components));
  }
}

bool same_number(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) ||
         (std::isnan(a) && std::isnan(b));
}

}  // namespace

void require_places(const Mesh& mesh) {
  FUZZ_REQUIRE(mesh.dimension >= 1 && mesh.dimension <= 3);
  FUZZ_REQUIRE(mesh.vertex_numbers.size() == mesh.points.size());
  FUZZ_REQUIRE(mesh.cells().size() > 0);
  for (std::size_t d = 0; d <= 3; ++d) {
    const app::Elements& elements = mesh.elements[d];
    FUZZ_REQUIRE(elements.vertices.size() == (d + 1) * elements.size());
    require_below(elements.vertices, mesh.points.size());
    require_below(elements.midside, mesh.points.size());
    if (elements.second_order())
      FUZZ_REQUIRE(elements.midside.size() == d * (d + 1) / 2 * elements.size());
  }
  for (const app::Group& group : mesh.groups) {
    FUZZ_REQUIRE(group.dimension >= 0 && group.dimension <= 3);
    FUZZ_REQUIRE(!group.name.empty());
    FUZZ_REQUIRE(std::is_sorted(group.elements.begin(), group.elements.end()));
    require_below(group.elements, mesh.elements[static_cast<std::size_t>(group.dimension)].size());
  }
  require_values(mesh.point_fields, mesh.points.size());
  require_values(mesh.cell_fields, mesh.cells().size());
  require_values(mesh.facet_fields, mesh.facets().size());
  const std::size_t corners = 2 * static_cast<std::size_t>(mesh.dimension);
  FUZZ_REQUIRE(mesh.cohesive.vertices.size() == corners * mesh.cohesive.size());
  FUZZ_REQUIRE(mesh.cohesive.names.size() == mesh.cohesive.size());
  require_below(mesh.cohesive.vertices, mesh.points.size());
  for (const app::Periodicity& periodicity : mesh.periodic)
    for (const auto& pair : periodicity.pairs)
      FUZZ_REQUIRE(pair.vertex < mesh.points.size() && pair.master < mesh.points.size());
}

void require_same_cells(const Mesh& a, const Mesh& b) {
  FUZZ_REQUIRE(a.dimension == b.dimension);
  FUZZ_REQUIRE(a.points.size() == b.points.size());
  for (std::size_t p = 0; p < a.points.size(); ++p)
    for (std::size_t i = 0; i < 3; ++i) FUZZ_REQUIRE(same_number(a.points[p][i], b.points[p][i]));
  FUZZ_REQUIRE(a.cells().vertices == b.cells().vertices);
  FUZZ_REQUIRE(a.cells().midside == b.cells().midside);
}

void require_same_content(const Mesh& a, const Mesh& b) {
  require_same_cells(a, b);
  for (std::size_t d = 0; d <= 3; ++d) {
    FUZZ_REQUIRE(a.elements[d].vertices == b.elements[d].vertices);
    FUZZ_REQUIRE(a.elements[d].midside == b.elements[d].midside);
  }
  FUZZ_REQUIRE(a.groups.size() == b.groups.size());
  for (std::size_t g = 0; g < a.groups.size(); ++g) {
    FUZZ_REQUIRE(a.groups[g].name == b.groups[g].name);
    FUZZ_REQUIRE(a.groups[g].dimension == b.groups[g].dimension);
    FUZZ_REQUIRE(a.groups[g].tag == b.groups[g].tag);
    FUZZ_REQUIRE(a.groups[g].elements == b.groups[g].elements);
  }
}

}  // namespace cleave::fuzz
