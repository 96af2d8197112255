#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "mesh.hpp"

namespace cleave::app {

/// How groups are written in a format that has one integer per element and no names: the tag of
/// the element's group, 0 for none, and for each set of overlapping groups an integer of its own.
/// What the integers do not say by themselves (names, overlaps, groups without elements) is said
/// by the file OUT.groups.json.
struct GroupIntegers {
  struct Named {
    int dimension;
    std::int32_t tag;
    std::string name;
  };
  struct Overlap {
    int dimension;
    std::int32_t integer;
    std::vector<std::int32_t> tags;
  };
  std::array<std::vector<std::int32_t>, 4> of_element;  // by dimension
  std::vector<Named> named;
  std::vector<Overlap> overlaps;
  std::vector<std::int32_t> of_cohesive;  // per cohesive element
  std::vector<Named> cohesive_named;      // their names; `dimension` says nothing

  /// Encodes the groups of one dimension for `count` elements. Tags that are 0 or repeated are
  /// replaced by free ones.
  void encode(int dimension, std::size_t count, const std::vector<Group>& groups);

  /// Encodes the names of cohesive elements: an empty one as 0, one of digits as its number.
  void encode_cohesive(const std::vector<std::string>& names);

  /// The content of OUT.groups.json; empty if there is nothing to say.
  std::string to_json() const;
};

/// Groups from the integers of a file: element i of `dimension` is in group integers[i] unless
/// that is 0.
std::vector<Group> groups_from_integers(int dimension, const std::vector<std::int32_t>& integers);

/// For formats that mark the vertices themselves: makes each vertex whose integer is not 0 an
/// element of dimension 0 with the vertex's number; returns the integers of these elements.
std::vector<std::int32_t> mark_vertices(Mesh& mesh, const std::vector<std::int32_t>& of_vertex);

/// The other way: the groups of dimension 0 as lists of places in mesh.points.
std::vector<Group> groups_of_vertices(const Mesh& mesh);

/// Applies `path`, the OUT.groups.json of the mesh, to the groups its integers gave. Throws
/// InputError if the file is not what to_json() writes.
void apply_group_names(Mesh& mesh, const std::filesystem::path& path);

}  // namespace cleave::app
