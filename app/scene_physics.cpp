#include "scene_physics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "error.hpp"
#include "where.hpp"

namespace cleave::app {
namespace {

constexpr std::uint32_t kNoMaterial = UINT32_MAX;

std::string groups_of_cell(const Mesh& mesh, Index cell) {
  std::string names;
  for (const Group& group : mesh.groups)
    if (group.dimension == mesh.dimension &&
        std::binary_search(group.elements.begin(), group.elements.end(), cell))
      names += (names.empty() ? "\"" : ", \"") + group.name + "\"";
  return names.empty() ? "no group" : "group " + names;
}

void require_material_everywhere(const Scene& scene, const Mesh& mesh,
                                 const std::vector<std::uint32_t>& of_cell) {
  for (Index cell = 0; cell < of_cell.size(); ++cell)
    if (of_cell[cell] == kNoMaterial)
      throw InputError(fmt::format(
          "{}: at /material/groups: cell {} of {} has no material; it is in {}. Give one to a "
          "group "
          "that holds it",
          scene.source, mesh.cells().numbers[cell], mesh.source, groups_of_cell(mesh, cell)));
}

double density_of(const Scene& scene, const LoadSpec& load, const SceneMaterials& materials,
                  const Mesh& mesh, topology::CellId cell) {
  if (load.density) return *load.density;
  const std::uint32_t material = materials.lame.of_cell[cell.value];
  if (!materials.density[material])
    throw InputError(fmt::format(
        "{}: at {}: gravity needs a density for cell {}; add \"density\" here, or to {}",
        scene.source, load.at, mesh.cells().numbers[cell.value], scene.materials[material].at));
  return *materials.density[material];
}

fem::Loads gravity_of(const Scene& scene, const LoadSpec& load, const Mesh& mesh,
                      const SceneMaterials& materials) {
  fem::Loads loads;
  loads.gravity = Eigen::Vector3d(load.vector.data());
  loads.density.assign(mesh.cells().size(), 0.0);
  if (load.where) {
    for (const auto cell : cells_in(*load.where, mesh, scene.source))
      loads.density[cell.value] = density_of(scene, load, materials, mesh, cell);
  } else {
    for (Index c = 0; c < loads.density.size(); ++c)
      loads.density[c] = density_of(scene, load, materials, mesh, {c});
  }
  return loads;
}

}  // namespace

SceneMaterials materials_of(const Scene& scene, const Mesh& mesh) {
  SceneMaterials materials;
  std::vector<std::uint32_t>& of_cell = materials.lame.of_cell;
  of_cell.assign(mesh.cells().size(), kNoMaterial);
  for (std::uint32_t m = 0; m < scene.materials.size(); ++m) {
    const MaterialSpec& spec = scene.materials[m];
    materials.lame.table.push_back(spec.lame);
    materials.density.push_back(spec.density);
    if (spec.group.empty()) {
      of_cell.assign(of_cell.size(), m);
      continue;
    }
    const Group& group = named_group(mesh, spec.group, mesh.dimension, scene.source, spec.at);
    for (const Index cell : group.elements) {
      if (of_cell[cell] != kNoMaterial)
        throw InputError(
            fmt::format("{}: cell {} of {} gets two materials, of {} and of {}; it is in {}. Take "
                        "it out of all "
                        "but one",
                        scene.source, mesh.cells().numbers[cell], mesh.source,
                        scene.materials[of_cell[cell]].at, spec.at, groups_of_cell(mesh, cell)));
      of_cell[cell] = m;
    }
  }
  require_material_everywhere(scene, mesh, of_cell);
  return materials;
}

fem::Dirichlet supports_of(const Scene& scene, const Body<3>& body) {
  fem::Dirichlet supports;
  std::map<std::pair<topology::VertexId, int>, std::string> prescribed_by;
  for (const SupportSpec& spec : scene.supports) {
    for (const auto vertex : vertices_in(spec.where, body, scene.source))
      for (int axis = 0; axis < 3; ++axis) {
        if (!spec.axes[static_cast<std::size_t>(axis)]) continue;
        try {
          supports.prescribe(vertex, axis, spec.value);
          prescribed_by.emplace(std::pair{vertex, axis}, spec.where.at);
        } catch (const fem::ContradictorySupport& e) {
          throw InputError(fmt::format(
              "{}: contradictory supports: vertex {} is held at {} = {} by {} and at {} by {}; let "
              "only one of them hold it",
              scene.source, body.number(vertex), "xyz"[axis], e.earlier,
              prescribed_by.at({vertex, axis}), e.later, spec.where.at));
        }
      }
  }
  return supports;
}

std::vector<fem::Loads> loads_of(const Scene& scene, const Body<3>& body, fem::Points points,
                                 const SceneMaterials& materials) {
  using Kind = LoadSpec::Kind;
  std::vector<fem::Loads> all(1);
  for (const LoadSpec& load : scene.loads) {
    const Eigen::Vector3d vector(load.vector.data());
    if (load.kind == Kind::force) {
      for (const auto vertex : vertices_in(*load.where, body, scene.source))
        all[0].nodal.push_back({vertex, vector});
    } else if (load.kind == Kind::total_force) {
      const auto vertices = vertices_in(*load.where, body, scene.source);
      for (const auto& share : fem::share_force(body.complex, points, vertices, vector))
        all[0].nodal.push_back(share);
    } else if (load.kind == Kind::traction) {
      for (const auto facet : boundary_facets_in(*load.where, body, scene.source))
        all[0].tractions.push_back({facet, vector});
    } else {
      all.push_back(gravity_of(scene, load, *body.mesh, materials));
    }
  }
  return all;
}

Eigen::VectorXd force_of(const std::vector<fem::Loads>& loads, const topology::Complex<3>& k,
                         fem::Points points) {
  Eigen::VectorXd force = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(k.vertex_count()));
  for (const fem::Loads& part : loads) force += fem::force_vector(k, points, part);
  return force;
}

}  // namespace cleave::app
