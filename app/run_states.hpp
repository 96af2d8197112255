#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "body.hpp"
#include "cleave/topology/incision.hpp"
#include "mesh.hpp"

/// The states of a run as meshes for .vtu files.
namespace cleave::app {

/// The body as it is now, undeformed, with point data `parent` (number in the mesh file) and
/// `displacement` (3 components, unless `displacement` is empty), and cell data `group` and
/// `piece`. What had to be dropped or renumbered is appended to `warnings`, once.
Mesh state_mesh(const Body<3>& body, const topology::Incision<3>& incision,
                const Eigen::VectorXd& displacement, std::vector<std::string>& warnings);

/// The mesh as it was read, for a run without complex: point data `parent`, cell data `group`.
Mesh bare_mesh(const Mesh& mesh);

}  // namespace cleave::app
