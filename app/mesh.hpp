#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "cleave/topology/ids.hpp"

namespace cleave::app {

/// Places of points and elements count as ids do: they become the ids of vertices and cells.
using topology::Index;

/// Simplices of one dimension as a file lists them.
struct Elements {
  std::vector<Index> vertices;         // dimension+1 per element: 0-based places in Mesh::points
  std::vector<std::uint64_t> numbers;  // the file's own number of each element
  /// Empty, or the element's nodes of second order, one per edge: places in Mesh::points, in the
  /// order (0,1) (0,2) (0,3) (1,2) (1,3) (2,3) of the edge's ends in the element's tuple.
  std::vector<Index> midside = {};
  std::size_t size() const { return numbers.size(); }
  bool second_order() const { return !midside.empty(); }
};

/// Zero-thickness elements between the two sides of opened facets: prisms (D = 3) or quadrangles
/// (D = 2). They are no cells: the complex does not know them. Vertices on the minus side come in
/// the order whose normal points to the plus side (D = 3: by the right hand; D = 2: plus is to the
/// left of the way from the first to the second), which is positive in gmsh's and Abaqus's sense.
struct CohesiveElements {
  std::vector<Index> vertices;         // 2*D per element: D on the minus side, then their
                                       // counterparts on the plus side; places in Mesh::points
  std::vector<std::uint64_t> numbers;  // the file's own number of each element
  std::vector<std::string> names;      // the group of each element
  std::size_t size() const { return numbers.size(); }
};

/// Vertices of the boundary that a periodic condition identifies, as gmsh's $Periodic lists them.
struct Periodicity {
  int dimension = 0;                    // of the two entities of the geometry
  std::int64_t entity = 0, master = 0;  // their tags
  std::vector<double> affine;           // 16 numbers that map the master onto the entity, or none
  struct Pair {
    Index vertex, master;  // places in Mesh::points
  };
  std::vector<Pair> pairs;
};

/// A named set of elements of one dimension: a physical group, a label, a reference. Groups may
/// overlap. A reference 0, which formats with one integer per element use for "none", is no group.
struct Group {
  std::string name;  // as the file has it; the integer in digits where the file has no names
  int dimension = 0;
  std::int32_t tag = 0;         // the file's integer for it
  std::vector<Index> elements;  // places in Mesh::elements[dimension], ascending
};

/// Values per point, cell or facet that a file carries.
struct Field {
  std::string name;
  int components = 1;
  std::vector<double> values;  // components per entity
  bool integer = false;        // the file stored integers
};

/// The two dialects of gmsh's .msh that are read and written.
enum class MshVersion { k22, k41 };

/// What a mesh file holds, nothing checked but its own grammar, order and numbers kept.
struct Mesh {
  std::string source;  // the name to quote in messages
  int dimension = 0;   // highest dimension that has elements, 1 .. 3
  std::vector<std::array<double, 3>>
      points;  // may hold values that are not finite: check's business
  std::vector<std::uint64_t> vertex_numbers;  // the file's own, one per point
  std::array<Elements, 4> elements;  // by dimension: vertices, edges, triangles, tetrahedra
  std::vector<Group> groups;         // by dimension, then tag
  std::vector<Field> point_fields, cell_fields,
      facet_fields;  // for the elements of the highest dimension, and of one below it
  CohesiveElements cohesive;
  std::vector<Periodicity> periodic;
  bool two_dimensional_points = false;       // the format stored 2 coordinates (Medit Dimension 2)
  MshVersion msh_version = MshVersion::k41;  // of the .msh it was read from, and to write as .msh
  bool msh_binary = false;                   // its form: binary, or text
  /// What the file holds and this does not: a sentence each, with the place in the file. Commands
  /// say them as warnings.
  std::vector<std::string> dropped;

  const Elements& cells() const { return elements[static_cast<std::size_t>(dimension)]; }
  const Elements& facets() const { return elements[static_cast<std::size_t>(dimension - 1)]; }
};

}  // namespace cleave::app
