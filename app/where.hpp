#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "body.hpp"
#include "mesh.hpp"
#include "scene.hpp"

/// What a scene's `where` stands for, at rest and before any stroke. `source` is the scene's file.
/// All throw InputError that names source, entry and what there is, for an unknown group, a vertex
/// number that the mesh does not have, and a selection that is empty.
namespace cleave::app {

/// The vertices there that cells use; of a group, the vertices of its elements. A vertex that
/// regularisation split counts with all its copies. Ascending. Time: linear in the mesh.
std::vector<topology::VertexId> vertices_in(const Where& where, const Body<3>& body,
                                            const std::string& source);

/// The boundary half-facets with all three vertices there; of a group, its facets that are
/// boundary. Ascending. Time: linear in the mesh.
std::vector<topology::HalfFacetId> boundary_facets_in(const Where& where, const Body<3>& body,
                                                      const std::string& source);

/// The cells with all vertices there; of a group, its cells. Ascending. Time: linear in the mesh.
std::vector<topology::CellId> cells_in(const Where& where, const Mesh& mesh,
                                       const std::string& source);

/// The group of this name and dimension. Throws InputError that lists the groups of the dimension;
/// `at` is the JSON pointer of the place that asks.
const Group& named_group(const Mesh& mesh, const std::string& name, int dimension,
                         const std::string& source, const std::string& at);

}  // namespace cleave::app
