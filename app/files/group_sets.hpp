#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "mesh.hpp"

namespace cleave::app {

/// Groups of one dimension turned around: for each element the set of groups that hold it. Formats
/// that store one integer (or one entity) per element write the number of that set.
struct GroupSets {
  std::vector<std::uint32_t> of_element;           // place in `sets` of each element
  std::vector<std::vector<std::size_t>> sets{{}};  // places in `groups`, ascending; the first: none
};

/// The sets of `groups` (places of elements below `count`). Time: linear in what the groups list.
GroupSets group_sets(std::size_t count, const std::vector<Group>& groups);

/// The groups of one dimension, in the mesh's order.
std::vector<Group> groups_of(const Mesh& mesh, int dimension);

/// One tag per group, distinct and at least `least`: its own where it can be kept, else the
/// smallest positive one that is free.
std::vector<std::int32_t> distinct_tags(const std::vector<Group>& groups, std::int32_t least);

/// The integer that a name of digits is, as to_string writes it; 0 for other names.
std::int32_t tag_of_name(const std::string& name);

/// Collects groups while elements are read in order.
class GroupCollector {
 public:
  /// The element at place `element` of `dimension` carries `tag`; a repetition changes nothing.
  void add(int dimension, std::int32_t tag, Index element);

  /// Makes the group exist, perhaps without elements, and names it.
  void name(int dimension, std::int32_t tag, std::string name);

  /// The groups by dimension, then tag; those without a name are named by their tag.
  std::vector<Group> finish();

 private:
  Group& group(int dimension, std::int32_t tag);

  std::map<std::pair<int, std::int32_t>, Group> groups_;
  Group* last_ = nullptr;  // most elements carry the tag of the element before them
};

}  // namespace cleave::app
