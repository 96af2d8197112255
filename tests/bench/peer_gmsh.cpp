#include <gmsh.h>

#include <cstdlib>

#include "median.hpp"
#include "peers.hpp"

/// Plugin(Crack) of gmsh, through its library. It duplicates the vertices of a group of triangles
/// but for those on the group's rim, unless that part of the rim is declared open; which side a
/// tetrahedron is on it decides by the geometry. Timed is the call of the plugin.
namespace cleave::bench {
namespace {

enum Type { line = 1, triangle = 2, tetrahedron = 4 };  // gmsh's numbers for elements

/// A model for as long as this lives; gmsh has one session per program.
struct Model {
  Model() {
    gmsh::initialize();
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::model::add("body");
  }
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;
  ~Model() { gmsh::finalize(); }
};

template <class Tuples>
void add_elements(int dimension, int tag, int type, const Tuples& tuples) {
  gmsh::model::addDiscreteEntity(dimension, tag);
  std::vector<std::size_t> nodes;
  for (const auto& tuple : tuples)
    for (const auto v : tuple) nodes.push_back(v.value + 1);
  gmsh::model::mesh::addElementsByType(tag, type, {}, nodes);
  gmsh::model::addPhysicalGroup(dimension, {tag}, tag);
}

std::size_t node_count() {
  std::vector<std::size_t> tags;
  std::vector<double> coordinates, parameters;
  gmsh::model::mesh::getNodes(tags, coordinates, parameters);
  return tags.size();
}

Split crack(const CutMesh<3>& mesh) {
  const Model model;
  std::vector<std::size_t> tags;
  for (std::size_t v = 0; v < mesh.soup.vertex_count; ++v) tags.push_back(v + 1);
  gmsh::model::addDiscreteEntity(3, 1);
  gmsh::model::mesh::addNodes(3, 1, tags, mesh.coordinates);
  std::vector<std::size_t> nodes;
  for (const auto& cell : mesh.soup.cells)
    for (const auto v : cell) nodes.push_back(v.value + 1);
  gmsh::model::mesh::addElementsByType(1, tetrahedron, {}, nodes);
  add_elements(2, 2, triangle, mesh.cut);
  add_elements(1, 3, line, mesh.rim);

  gmsh::plugin::setNumber("Crack", "Dimension", 2);
  gmsh::plugin::setNumber("Crack", "PhysicalGroup", 2);
  gmsh::plugin::setNumber("Crack", "OpenBoundaryPhysicalGroup", 3);
  Split split;
  split.seconds = seconds([] { gmsh::plugin::run("Crack"); });
  split.new_vertices = node_count() - mesh.soup.vertex_count;
  return split;
}

// Beyond these it takes minutes: the time grows with the square of the facets.
const bool kLarge = std::getenv("CLEAVE_BENCH_LARGE") != nullptr;
const Registration kCrack(Splitter<3>{"gmsh_Crack", crack, kLarge ? 10'000'000U : 1'000'000U,
                                      kLarge ? 25'000U : 5'000U});

}  // namespace
}  // namespace cleave::bench
