#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>

#include "error.hpp"
#include "files/msh_output.hpp"
#include "files/numbers.hpp"

namespace cleave::app {
namespace {

std::vector<std::uint64_t> numbers_of(const std::vector<std::uint64_t>& wanted,
                                      std::uint64_t greatest) {
  std::vector<std::uint64_t> numbers = kept_or_counted(wanted, greatest);
  if (!numbers.empty() && numbers.back() > greatest)
    throw OutputError("the mesh has more than " + std::to_string(greatest) +
                      " nodes or elements, which this form of a .msh file cannot number; write "
                      "version 4.1");
  return numbers;
}

/// Corners and midside nodes of each element, in gmsh's order.
std::vector<Index> second_order_nodes(const Elements& elements, const MshKind& kind) {
  std::vector<Index> nodes;
  nodes.reserve(kind.nodes() * elements.size());
  for (std::size_t e = 0; e < elements.size(); ++e) {
    for (std::size_t k = 0; k < kind.corners; ++k)
      nodes.push_back(elements.vertices[kind.corners * e + k]);
    for (std::size_t k = 0; k < kind.midside; ++k)
      nodes.push_back(elements.midside[kind.midside * e + msh_midside(kind.dimension, k)]);
  }
  return nodes;
}

/// The groups that the names of the cohesive elements say, as groups of cells' dimension. A name
/// that the cells' groups have is the same group.
void add_cohesive_groups(const Mesh& mesh, MshLevel& cells, MshLevel& cohesive) {
  std::map<std::string, std::size_t> places;
  for (std::size_t g = 0; g < cells.groups.size(); ++g) places.emplace(cells.groups[g].name, g);
  std::vector<std::vector<Index>> members(cells.groups.size());
  for (std::size_t e = 0; e < cohesive.count; ++e) {
    const std::string& name = mesh.cohesive.names[e];
    if (name.empty()) continue;
    const auto [known, is_new] = places.emplace(name, cells.groups.size());
    if (is_new) {
      cells.groups.push_back({name, cells.kind.dimension, 0, {}});
      members.emplace_back();
    }
    members[known->second].push_back(static_cast<Index>(e));
  }
  cells.tags = distinct_tags(cells.groups, 1);
  cohesive.groups = cells.groups;
  cohesive.tags = cells.tags;
  for (std::size_t g = 0; g < members.size(); ++g)
    cohesive.groups[g].elements = std::move(members[g]);
}

MshLevel simplices(const Mesh& mesh, int dimension) {
  const Elements& elements = mesh.elements[static_cast<std::size_t>(dimension)];
  MshLevel level;
  level.kind = msh_simplex(dimension, elements.second_order());
  level.count = elements.size();
  level.groups = groups_of(mesh, dimension);
  level.tags = distinct_tags(level.groups, 1);
  level.vertices = &elements.vertices;
  if (elements.second_order()) level.reordered = second_order_nodes(elements, level.kind);
  return level;
}

MshLevel cohesive_level(const Mesh& mesh, MshLevel& cells) {
  MshLevel level;
  level.kind = msh_cohesive(mesh.dimension);
  level.count = mesh.cohesive.size();
  add_cohesive_groups(mesh, cells, level);
  for (std::size_t e = 0; e < level.count; ++e)
    for (std::size_t k = 0; k < level.kind.corners; ++k)
      level.reordered.push_back(
          mesh.cohesive.vertices[level.kind.corners * e + msh_cohesive_node(mesh.dimension, k)]);
  return level;
}

/// The periodic entities of one dimension that each vertex lies on.
class PeriodicEntities {
 public:
  PeriodicEntities(const Mesh& mesh, int dimension) {
    for (const Periodicity& periodic : mesh.periodic) {
      if (periodic.dimension != dimension) continue;
      for (const auto& pair : periodic.pairs) {
        of_vertex_[pair.vertex].insert(static_cast<std::int32_t>(periodic.entity));
        of_vertex_[pair.master].insert(static_cast<std::int32_t>(periodic.master));
      }
    }
  }
  bool any() const { return !of_vertex_.empty(); }

  /// An entity that all `corners` lie on, 0 if there is none.
  std::int32_t of(const Index* corners, std::size_t count) const {
    const auto first = of_vertex_.find(corners[0]);
    if (first == of_vertex_.end()) return 0;
    for (const std::int32_t entity : first->second) {
      std::size_t k = 1;
      while (k < count && holds(corners[k], entity)) ++k;
      if (k == count) return entity;
    }
    return 0;
  }

 private:
  bool holds(Index vertex, std::int32_t entity) const {
    const auto found = of_vertex_.find(vertex);
    return found != of_vertex_.end() && found->second.count(entity) > 0;
  }

  std::unordered_map<Index, std::set<std::int32_t>> of_vertex_;
};

/// Gives the elements on a periodic entity that entity, whose tag gmsh looks for; elements there in
/// other groups than the first get an entity of their own. Returns the tags that are so fixed, by
/// place of the set.
std::map<std::size_t, std::int32_t> keep_periodic(MshLevel& level,
                                                  const PeriodicEntities& periodic) {
  std::map<std::size_t, std::int32_t> fixed;
  std::map<std::pair<std::uint32_t, std::int32_t>, std::uint32_t> refined;
  std::set<std::int32_t> used;
  for (std::size_t e = 0; periodic.any() && e < level.count; ++e) {
    const std::int32_t entity = periodic.of(level.nodes(e), level.kind.corners);
    if (entity == 0) continue;
    if (level.kind.dimension == 0) {
      if (used.insert(entity).second) fixed[e] = entity;
      continue;
    }
    std::uint32_t& set = level.sets.of_element[e];
    const auto next = static_cast<std::uint32_t>(level.sets.sets.size());
    const auto [known, is_new] = refined.try_emplace({set, entity}, next);
    if (is_new) {
      level.sets.sets.push_back(std::vector<std::size_t>(level.sets.sets[set]));
      if (used.insert(entity).second) fixed[next] = entity;
    }
    set = known->second;
  }
  return fixed;
}

/// Tags from 1 on for the entities that have elements and no fixed tag, those in `taken` left out.
void number_entities(MshLevel& level, const std::map<std::size_t, std::int32_t>& fixed,
                     std::set<std::int32_t>& taken) {
  const std::size_t count = level.kind.dimension == 0 ? level.count : level.sets.sets.size();
  std::vector<bool> has_elements(count);
  for (std::size_t e = 0; e < level.count; ++e) has_elements[level.entity_of(e)] = true;
  level.entities.assign(count, 0);
  for (const auto& [entity, tag] : fixed) level.entities[entity] = tag;
  std::int32_t next = 1;
  for (std::size_t entity = 0; entity < count; ++entity, ++next) {
    while (!taken.empty() && taken.count(next) > 0) ++next;
    if (has_elements[entity] && level.entities[entity] == 0) level.entities[entity] = next;
  }
  if (level.kind.dimension > 0) taken.insert(level.entities.begin(), level.entities.end());
}

}  // namespace

MshNumbers::MshNumbers(const Mesh& mesh, std::uint64_t greatest_node,
                       std::uint64_t greatest_element)
    : nodes(numbers_of(mesh.vertex_numbers, greatest_node)) {
  std::vector<std::uint64_t> all;
  for (const Elements& of_dimension : mesh.elements)
    all.insert(all.end(), of_dimension.numbers.begin(), of_dimension.numbers.end());
  all.insert(all.end(), mesh.cohesive.numbers.begin(), mesh.cohesive.numbers.end());
  elements = numbers_of(all, greatest_element);
}

std::vector<MshLevel> msh_levels(const Mesh& mesh) {
  std::vector<MshLevel> levels;
  for (int d = 0; d <= 3; ++d) levels.push_back(simplices(mesh, d));
  if (mesh.cohesive.size() > 0)
    levels.push_back(cohesive_level(mesh, levels[static_cast<std::size_t>(mesh.dimension)]));
  std::array<std::set<std::int32_t>, 4> taken;
  for (const Periodicity& periodic : mesh.periodic)
    for (const std::int64_t tag : {periodic.entity, periodic.master})
      taken[static_cast<std::size_t>(periodic.dimension)].insert(static_cast<std::int32_t>(tag));
  for (MshLevel& level : levels) {
    level.sets = group_sets(level.count, level.groups);
    const auto fixed = keep_periodic(level, PeriodicEntities(mesh, level.kind.dimension));
    number_entities(level, fixed, taken[static_cast<std::size_t>(level.kind.dimension)]);
  }
  return levels;
}

}  // namespace cleave::app
