#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "files/group_sets.hpp"
#include "files/msh_format.hpp"
#include "files/msh_kind.hpp"
#include "files/text_output.hpp"
#include "mesh.hpp"

namespace cleave::app {

/// Rows of numbers in either form of a .msh file: in text separated by blanks and ended by a line
/// end, in binary their bytes, of which the types of the numbers are part of the format.
class MshRows {
 public:
  MshRows(TextOutput& out, bool binary) : out_(&out), binary_(binary) {}

  bool binary() const { return binary_; }
  /// Lines that are text in both forms.
  TextOutput& text() { return *out_; }

  template <class Number>
  void put(Number value) {
    if (binary_) {
      *out_ << std::string_view(reinterpret_cast<const char*>(&value), sizeof value);
      return;
    }
    if (in_row_) *out_ << ' ';
    *out_ << value;
    in_row_ = true;
  }
  void put(const std::array<double, 3>& point) {
    for (const double x : point) put(x);
  }
  void end_row() {
    if (!binary_) *out_ << '\n';
    in_row_ = false;
  }
  template <class... Parts>
  void row(const Parts&... parts) {
    (put(parts), ...);
    end_row();
  }

  /// The lines around a section.
  void open(std::string_view section) { *out_ << '$' << section << '\n'; }
  void close(std::string_view section) {
    *out_ << (binary_ ? "\n$End" : "$End") << section << '\n';
  }

 private:
  TextOutput* out_;
  bool binary_;
  bool in_row_ = false;
};

/// The numbers of nodes and elements in a file: the mesh's where all are positive, no two equal and
/// none too great, else counted from 1 on. Elements by dimension, then cohesive ones.
struct MshNumbers {
  MshNumbers(const Mesh& mesh, std::uint64_t greatest_node, std::uint64_t greatest_element);
  std::vector<std::uint64_t> nodes, elements;
};

/// Elements of one kind and their groups. Those in the same groups form a geometrical entity; a
/// vertex is an entity of its own, as gmsh wants it. Elements of which all vertices are on one
/// entity of Mesh::periodic are in that one.
struct MshLevel {
  MshKind kind{};
  std::size_t count = 0;
  std::vector<Group> groups;       // without elements where the set of groups says enough
  std::vector<std::int32_t> tags;  // of each group
  GroupSets sets;
  std::vector<std::int32_t> entities;  // the tag of each entity; 0: no element is in it

  std::size_t entity_of(std::size_t element) const {
    return kind.dimension == 0 ? element : sets.of_element[element];
  }
  const std::vector<std::size_t>& groups_of_entity(std::size_t entity) const {
    return sets.sets[kind.dimension == 0 ? sets.of_element[entity] : entity];
  }
  std::int32_t tag_of(std::size_t element) const { return entities[entity_of(element)]; }
  /// Nodes of an element, places in the mesh's points, in gmsh's order.
  const Index* nodes(std::size_t element) const {
    return (reordered.empty() ? vertices->data() : reordered.data()) + kind.nodes() * element;
  }

  const std::vector<Index>* vertices = nullptr;
  std::vector<Index> reordered;  // where the mesh does not have them in gmsh's order
};

/// The simplices by dimension, then the cohesive elements if there are any.
std::vector<MshLevel> msh_levels(const Mesh& mesh);

void write_msh22(MshRows& rows, const Mesh& mesh, const std::vector<MshLevel>& levels,
                 const MshNumbers& numbers);
void write_msh41(MshRows& rows, const Mesh& mesh, const std::vector<MshLevel>& levels,
                 const MshNumbers& numbers);

/// $NodeData of the point fields, $ElementData of the fields of cells and facets. Every element has
/// a row, NaN where the field has no value: meshio passes over the numbers of the rows, and cannot
/// read the file otherwise.
void write_msh_data(MshRows& rows, const Mesh& mesh, const MshNumbers& numbers);

}  // namespace cleave::app
