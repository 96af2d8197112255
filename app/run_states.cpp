#include "run_states.hpp"

#include <algorithm>

#include "cut_output.hpp"
#include "mesh_fields.hpp"

namespace cleave::app {
namespace {

// A .vtu file of a run holds the cells alone, so that fields on cells fit them.
void keep_cells_only(Mesh& mesh) {
  for (std::size_t d = 0; d < 3; ++d) mesh.elements[d] = {};
  mesh.facet_fields.clear();
  mesh.groups.erase(std::remove_if(mesh.groups.begin(), mesh.groups.end(),
                                   [](const Group& group) { return group.dimension < 3; }),
                    mesh.groups.end());
}

}  // namespace

Mesh state_mesh(const Body<3>& body, const topology::Incision<3>& incision,
                const Eigen::VectorXd& displacement, std::vector<std::string>& warnings) {
  CutOutput output = cut_output(body, incision, {}, Numbering::from_zero);
  for (const std::string& warning : output.warnings)
    if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end())
      warnings.push_back(warning);
  keep_cells_only(output.mesh);
  if (displacement.size() != 0) {
    Field field{"displacement", 3, {}};
    for (const auto vertex : output.vertex_at)
      for (Eigen::Index i = 0; i < 3; ++i)
        field.values.push_back(displacement[3 * static_cast<Eigen::Index>(vertex.value) + i]);
    set_field(output.mesh.point_fields, std::move(field));
  }
  return std::move(output.mesh);
}

Mesh bare_mesh(const Mesh& mesh) {
  Mesh bare = mesh;
  keep_cells_only(bare);
  Field parent{"parent", 1, {}, true};
  for (const std::uint64_t number : mesh.vertex_numbers)
    parent.values.push_back(static_cast<double>(number));
  set_field(bare.point_fields, std::move(parent));
  set_field(bare.cell_fields, {"group", 1, cell_tags(mesh)});
  return bare;
}

}  // namespace cleave::app
