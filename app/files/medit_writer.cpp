#include <string>

#include "files/group_sets.hpp"
#include "files/medit.hpp"

namespace cleave::app {
namespace {

void write_elements(TextOutput& out, const std::string& keyword, const Elements& elements,
                    std::size_t dimension, const std::vector<std::int32_t>& references) {
  if (elements.size() == 0) return;
  out << keyword << (elements.second_order() ? "P2\n" : "\n") << elements.size() << '\n';
  const std::size_t edges = elements.second_order() ? dimension * (dimension + 1) / 2 : 0;
  auto vertex = elements.vertices.begin();
  for (std::size_t i = 0; i < elements.size(); ++i) {
    for (std::size_t k = 0; k <= dimension; ++k) out << std::uint64_t{*vertex++} + 1 << ' ';
    for (std::size_t k = 0; k < edges; ++k)
      out << std::uint64_t{elements.midside[edges * i + medit_midside(dimension, k)]} + 1 << ' ';
    out << references[i] << '\n';
  }
}

}  // namespace

GroupIntegers write_medit(TextOutput& out, const Mesh& mesh) {
  GroupIntegers integers;
  integers.encode(0, mesh.points.size(), groups_of_vertices(mesh));
  for (int dimension = 1; dimension <= 3; ++dimension)
    integers.encode(dimension, mesh.elements[static_cast<std::size_t>(dimension)].size(),
                    groups_of(mesh, dimension));

  const bool flat = mesh.two_dimensional_points;
  out << "MeshVersionFormatted 2\nDimension " << (flat ? 2 : 3) << "\nVertices\n"
      << mesh.points.size() << '\n';
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const auto& point = mesh.points[v];
    out << point[0] << ' ' << point[1] << ' ';
    if (!flat) out << point[2] << ' ';
    out << integers.of_element[0][v] << '\n';
  }
  write_elements(out, "Edges", mesh.elements[1], 1, integers.of_element[1]);
  write_elements(out, "Triangles", mesh.elements[2], 2, integers.of_element[2]);
  write_elements(out, "Tetrahedra", mesh.elements[3], 3, integers.of_element[3]);
  out << "End\n";
  return integers;
}

}  // namespace cleave::app
