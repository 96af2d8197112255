#include <algorithm>
#include <string>

#include "error.hpp"
#include "files/group_sets.hpp"
#include "files/midside.hpp"
#include "files/tetgen.hpp"

namespace cleave::app {
namespace {

class TetgenWriter {
 public:
  TetgenWriter(const TetgenOutputs& out, const Mesh& mesh)
      : out_(out), mesh_(mesh), first_(mesh.vertex_numbers[0] == 0 ? 0 : 1) {}

  GroupIntegers write() {
    integers_.encode(0, mesh_.points.size(), groups_of_vertices(mesh_));
    for (int d = 1; d <= 3; ++d) integers_.encode(d, elements(d).size(), groups_of(mesh_, d));
    write_nodes();
    write_cells();
    if (out_.face != nullptr) write_lower(*out_.face, 2);
    if (out_.edge != nullptr) write_lower(*out_.edge, 1);
    return std::move(integers_);
  }

 private:
  const Elements& elements(int d) const { return mesh_.elements[static_cast<std::size_t>(d)]; }

  const std::vector<std::int32_t>& markers(int d) const {
    return integers_.of_element[static_cast<std::size_t>(d)];
  }

  bool marked(int d) const {
    return std::any_of(markers(d).begin(), markers(d).end(), [](auto m) { return m != 0; });
  }

  static std::size_t columns(const std::vector<Field>& fields) {
    std::size_t count = 0;
    for (const Field& field : fields) count += static_cast<std::size_t>(field.components);
    return count;
  }

  static void write_values(TextOutput& out, const std::vector<Field>& fields, std::size_t entry) {
    for (const Field& field : fields) {
      const auto components = static_cast<std::size_t>(field.components);
      for (std::size_t k = 0; k < components; ++k)
        out << ' ' << field.values[components * entry + k];
    }
  }

  void write_nodes() {
    const bool flat = mesh_.dimension == 2, has_markers = marked(0);
    TextOutput& out = out_.node;
    out << mesh_.points.size() << ' ' << (flat ? 2 : 3) << ' ' << columns(mesh_.point_fields) << ' '
        << (has_markers ? 1 : 0) << '\n';
    for (std::size_t v = 0; v < mesh_.points.size(); ++v) {
      const auto& point = mesh_.points[v];
      out << first_ + v << ' ' << point[0] << ' ' << point[1];
      if (!flat) out << ' ' << point[2];
      write_values(out, mesh_.point_fields, v);
      if (has_markers) out << ' ' << markers(0)[v];
      out << '\n';
    }
  }

  void write_vertices(TextOutput& out, int d, std::size_t element) const {
    const Elements& all = elements(d);
    const auto dimension = static_cast<std::size_t>(d), corners = dimension + 1;
    for (std::size_t k = 0; k < corners; ++k)
      out << ' ' << first_ + all.vertices[corners * element + k];
    if (!mesh_.cells().second_order() || !all.second_order()) return;
    for (std::size_t k = 0; k < edges_of_simplex(dimension); ++k)
      out << ' ' << first_ + midside_node(all, dimension, kTetgenMidside, element, k);
  }

  void write_cells() {
    const int d = mesh_.dimension;
    const bool second_order = elements(d).second_order();
    const bool grouped = marked(d) || !mesh_.cell_fields.empty();
    TextOutput& out = out_.ele;
    out << elements(d).size() << ' '
        << (d == 2         ? second_order ? 6 : 3
            : second_order ? 10
                           : 4)
        << ' ' << columns(mesh_.cell_fields) + (grouped ? 1 : 0) << '\n';
    for (std::size_t e = 0; e < elements(d).size(); ++e) {
      out << first_ + e;
      write_vertices(out, d, e);
      if (grouped) out << ' ' << markers(d)[e];
      write_values(out, mesh_.cell_fields, e);
      out << '\n';
    }
  }

  void write_lower(TextOutput& out, int d) const {
    const bool has_markers = marked(d);
    out << elements(d).size() << ' ' << (has_markers ? 1 : 0) << '\n';
    for (std::size_t e = 0; e < elements(d).size(); ++e) {
      out << first_ + e;
      write_vertices(out, d, e);
      if (has_markers) out << ' ' << markers(d)[e];
      out << '\n';
    }
  }

  const TetgenOutputs& out_;
  const Mesh& mesh_;
  std::uint64_t first_;
  GroupIntegers integers_;
};

}  // namespace

void require_tetgen_can_hold(const Mesh& mesh) {
  if (mesh.dimension < 2)
    throw OutputError(
        "TetGen's files hold triangles or tetrahedra, and the mesh has edges only; write another "
        "format");
  if (mesh.dimension == 3) return;
  const auto out_of_plane = std::find_if(mesh.points.begin(), mesh.points.end(),
                                         [](const auto& point) { return point[2] != 0; });
  if (out_of_plane != mesh.points.end())
    throw OutputError(
        "the .node file of triangles holds 2 coordinates, and vertex " +
        std::to_string(
            mesh.vertex_numbers[static_cast<std::size_t>(out_of_plane - mesh.points.begin())]) +
        " is not in the plane z = 0; write another format");
}

GroupIntegers write_tetgen(const TetgenOutputs& out, const Mesh& mesh) {
  return TetgenWriter(out, mesh).write();
}

}  // namespace cleave::app
