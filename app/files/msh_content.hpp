#pragma once
#include <array>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "files/binary_row.hpp"
#include "files/group_sets.hpp"
#include "files/msh_kind.hpp"
#include "files/msh_nodes.hpp"
#include "files/row.hpp"
#include "mesh.hpp"

namespace cleave::app {

/// One $Section .. $EndSection of a file.
struct MshSection {
  std::string name;    // without the dollar
  const char* opened;  // the line that opens it, for messages
  const char* begin;   // its content
  const char* end;     // in binary, of the file where only reading the content tells its end
};

/// A number that is known to come twice: looking at each finds the second one's place.
struct WatchedNumber {
  std::optional<std::uint64_t> number;
  bool seen = false;

  template <class Row>
  void look(const Row& row, std::uint64_t at, const char* kind) {
    if (!number || at != *number) return;
    if (seen)
      row.fail(std::string(kind) + " number " + std::to_string(*number) +
               " is used a second time; numbers must be distinct");
    seen = true;
  }
};

/// Quadrangles or prisms, until it is known whether they are cohesive elements.
struct MshCohesive {
  std::vector<Index> vertices;  // as CohesiveElements has them
  std::vector<std::uint64_t> numbers;
  std::vector<std::int32_t> tags;   // of the physical group, 0 none
  std::vector<const char*> places;  // in the file
};

/// An element of a 2.2 file that was read once more, for another of its groups.
struct MshRepeated {
  static constexpr int kCohesive = -1;
  std::uint64_t number;
  int dimension;  // or kCohesive, which has no place
  Index place;    // of the element in its dimension
};

/// What the sections of both versions fill.
struct MshContent {
  explicit MshContent(const InputText& file) : text(&file) {}

  const InputText* text;
  Mesh mesh;
  WatchedNumber watched_node, watched_element;
  MshNodes nodes;
  GroupCollector groups;
  std::array<const MshKind*, 4> kinds{};  // of the simplices of each dimension, once known
  std::array<MshCohesive, 2> cohesive;    // quadrangles, prisms
  std::vector<MshRepeated> repeated;
  bool cohesive_in_several_groups = false;

  /// Makes room for `count` more elements, which the file is long enough to hold.
  void expect(const MshKind& kind, std::size_t count);

  /// Adds the element that the rest of `row` describes, whose nodes have 32 bits in binary if
  /// `Short`; returns its place.
  template <bool Short, class Row>
  Index add_element(Row& row, const MshKind& kind, std::uint64_t number);

  /// The same for a quadrangle or prism in the physical group `tag`.
  template <bool Short, class Row>
  void add_cohesive(Row& row, const MshKind& kind, std::uint64_t number, std::int32_t tag);

  /// The place of the node whose number comes next in `row`; `user` with its number is who asks.
  template <bool Short, class Row>
  Index node(Row& row, const char* user, std::uint64_t number);

  /// Decides on quadrangles and prisms when everything is read. Throws InputError for those that
  /// are no cohesive elements of this mesh.
  void finish_cohesive();

  /// The highest dimension that has elements, 0 if none above points.
  int dimension() const;

  /// Remembers that what is at `place` has no place in a Mesh.
  void drop(const char* place, const std::string& message);
};

/// A number of a node or element: up to 64 bits, but in the binary form of version 2.2 and of
/// fields 32 (`Short`).
template <bool Short, class Row>
std::uint64_t msh_number(Row& row, const char* what) {
  if constexpr (Short && std::is_same_v<Row, BinaryRow>) {
    const auto number = row.template number<std::int32_t>(what);
    if (number < 0) row.fail(std::string(what) + " is negative: " + std::to_string(number));
    return static_cast<std::uint64_t>(number);
  } else {
    return row.template number<std::uint64_t>(what);
  }
}

/// Why elements of gmsh's `type` cannot be read: one element, or, without `number`, all of a block.
std::string msh_refusal(int type, std::optional<std::uint64_t> number);

/// The kind of gmsh's element type. Throws InputError for all but simplices of order 1 and 2,
/// quadrangles and prisms; `number` is the element's, if one element is meant.
template <class Row>
const MshKind& msh_kind(const Row& row, int type, std::optional<std::uint64_t> number) {
  for (const MshKind& kind : kMshKinds)
    if (kind.type == type) return kind;
  row.fail(msh_refusal(type, number));
}

/// The number of a physical group, without the sign that gmsh uses for orientation.
template <class Row>
std::int32_t msh_physical_tag(Row& row) {
  const auto tag = row.template number<std::int32_t>("the number of a physical group");
  if (tag == INT32_MIN) row.fail("the number of a physical group is out of range");
  return tag < 0 ? -tag : tag;
}

/// Why an element of `kind` cannot stand beside those of its dimension that came before.
std::string msh_mixed_orders(const MshKind& kind, std::uint64_t number);

template <bool Short, class Row>
Index MshContent::node(Row& row, const char* user, std::uint64_t number) {
  const std::uint64_t node = msh_number<Short>(row, "the number of a node");
  const Index place = nodes.find(node);
  if (place == MshNodes::kNone)
    row.fail(std::string(user) + " " + std::to_string(number) + " uses node " +
             std::to_string(node) + ", which $Nodes does not hold");
  return place;
}

template <bool Short, class Row>
Index MshContent::add_element(Row& row, const MshKind& kind, std::uint64_t number) {
  const auto dimension = static_cast<std::size_t>(kind.dimension);
  if (kinds[dimension] != &kind) {
    if (kinds[dimension] != nullptr) row.fail(msh_mixed_orders(kind, number));
    kinds[dimension] = &kind;
  }
  Elements& elements = mesh.elements[dimension];
  for (std::size_t k = 0; k < kind.corners; ++k)
    elements.vertices.push_back(node<Short>(row, "element", number));
  if (kind.midside > 0) {
    const std::size_t first = elements.midside.size();
    elements.midside.resize(first + kind.midside);
    for (std::size_t k = 0; k < kind.midside; ++k)
      elements.midside[first + msh_midside(kind.dimension, k)] =
          node<Short>(row, "element", number);
  }
  row.finish("an element");
  watched_element.look(row, number, "element");
  elements.numbers.push_back(number);
  return static_cast<Index>(elements.size() - 1);
}

template <bool Short, class Row>
void MshContent::add_cohesive(Row& row, const MshKind& kind, std::uint64_t number,
                              std::int32_t tag) {
  MshCohesive& list = cohesive[static_cast<std::size_t>(kind.dimension - 2)];
  const std::size_t first = list.vertices.size();
  list.vertices.resize(first + kind.corners);
  for (std::size_t k = 0; k < kind.corners; ++k)
    list.vertices[first + msh_cohesive_node(kind.dimension, k)] =
        node<Short>(row, "element", number);
  row.finish("an element");
  watched_element.look(row, number, "element");
  list.numbers.push_back(number);
  list.tags.push_back(tag);
  list.places.push_back(row.begin());
}

/// The readers of the sections, for RowReader (text) and BinaryRows. What they read ends where the
/// rows' position is.
template <class Rows>
void read_msh22_nodes(Rows& rows, MshContent& content);
template <class Rows>
void read_msh22_elements(Rows& rows, MshContent& content);
template <class Rows>
void read_msh41_nodes(Rows& rows, MshContent& content);
template <class Rows>
void read_msh41_periodic(Rows& rows, MshContent& content);

/// The physical groups of each geometrical entity, by dimension and tag.
using MshEntities = std::map<std::pair<int, std::int32_t>, std::vector<std::int32_t>>;
template <class Rows>
MshEntities read_msh41_entities(Rows& rows);
/// Elements of entities that are not described have no group (meshio writes such files).
template <class Rows>
void read_msh41_elements(Rows& rows, const MshEntities& entities, MshContent& content);

/// $Periodic of version 2.2, which is text in both forms.
void read_msh22_periodic(RowReader& rows, MshContent& content);

/// A section $NodeData or $ElementData, opened at `opened`.
template <class Rows>
void read_msh_data(Rows& rows, const MshSection& section, MshContent& content);

}  // namespace cleave::app
