#pragma once
#include <optional>
#include <string>
#include <vector>

#include "body.hpp"
#include "cleave/fem/body.hpp"
#include "cleave/fem/dirichlet.hpp"
#include "cleave/fem/loads.hpp"
#include "scene.hpp"

/// A scene's material, supports and loads on the body at rest. Everything here throws InputError
/// that names the scene's file, the entry and the file's own numbers.
namespace cleave::app {

struct SceneMaterials {
  fem::Materials lame;                         // table: one entry per MaterialSpec, in its order
  std::vector<std::optional<double>> density;  // one per entry of the table
};

/// The material of every cell. A cell without a material, or with two, is an InputError that names
/// the cell and its groups. Time: linear in the mesh.
SceneMaterials materials_of(const Scene& scene, const Mesh& mesh);

/// What the scene prescribes. Two entries that prescribe different values for one coordinate of one
/// vertex are an InputError that names vertex, axis and both.
fem::Dirichlet supports_of(const Scene& scene, const Body<3>& body);

/// The scene's loads: those on vertices and facets in the first element, each gravity in one more.
/// Forces given as a total are shared by star volumes.
std::vector<fem::Loads> loads_of(const Scene& scene, const Body<3>& body, fem::Points points,
                                 const SceneMaterials& materials);

/// The sum of the force vectors of `loads`, 3 entries per vertex.
Eigen::VectorXd force_of(const std::vector<fem::Loads>& loads, const topology::Complex<3>& k,
                         fem::Points points);

}  // namespace cleave::app
