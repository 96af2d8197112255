#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "error.hpp"
#include "files/msh_format.hpp"

namespace cleave::app {
namespace {

/// What is written of the groups and elements of one dimension. Elements in the same groups form
/// a geometrical entity, numbered from 1 on; a vertex is an entity of its own, as gmsh wants it.
struct Level {
  int dimension = 0;
  const Elements* elements = nullptr;
  std::vector<Group> groups;
  std::vector<std::int32_t> tags;  // per group
  GroupSets sets;
  std::vector<bool> has_elements;  // per entity; those without are not written

  std::size_t entity_of(std::size_t element) const {
    return dimension == 0 ? element : sets.of_element[element];
  }
  const std::vector<std::size_t>& groups_of_entity(std::size_t entity) const {
    return sets.sets[dimension == 0 ? sets.of_element[entity] : entity];
  }
};

std::array<Level, 4> levels_of(const Mesh& mesh) {
  std::array<Level, 4> levels;
  for (std::size_t d = 0; d <= 3; ++d) {
    Level& level = levels[d];
    level.dimension = static_cast<int>(d);
    level.elements = &mesh.elements[d];
    level.groups = groups_of(mesh, level.dimension);
    level.tags = distinct_tags(level.groups, 1);
    level.sets = group_sets(level.elements->size(), level.groups);
    level.has_elements.resize(d == 0 ? level.elements->size() : level.sets.sets.size());
    for (std::size_t e = 0; e < level.elements->size(); ++e)
      level.has_elements[level.entity_of(e)] = true;
  }
  return levels;
}

void write_physical_names(TextOutput& out, const std::array<Level, 4>& levels) {
  std::string rows;
  std::size_t count = 0;
  for (const Level& level : levels) {
    for (std::size_t g = 0; g < level.groups.size(); ++g) {
      const std::string& name = level.groups[g].name;
      const std::string tag = std::to_string(level.tags[g]);
      if (name.empty() || (name == tag && !level.groups[g].elements.empty())) continue;
      if (name.size() > 127 || name.find_first_of("\"\r\n") != std::string::npos)
        throw OutputError("the group '" + name +
                          "' cannot be named in a .msh file: no quotation mark or line break is "
                          "allowed, and at most 127 bytes; rename it");
      rows += std::to_string(level.dimension) + " " + tag + " \"" + name + "\"\n";
      ++count;
    }
  }
  if (count > 0) out << "$PhysicalNames\n" << count << '\n' << rows << "$EndPhysicalNames\n";
}

/// True if numbers can be kept in a .msh file: all positive, no two equal.
bool can_be_kept(std::vector<std::uint64_t> numbers) {
  if (!std::is_sorted(numbers.begin(), numbers.end())) std::sort(numbers.begin(), numbers.end());
  return numbers.empty() || (numbers.front() > 0 &&
                             std::adjacent_find(numbers.begin(), numbers.end()) == numbers.end());
}

std::vector<std::uint64_t> counted(std::size_t count) {
  std::vector<std::uint64_t> numbers(count);
  for (std::size_t i = 0; i < count; ++i) numbers[i] = i + 1;
  return numbers;
}

std::vector<std::uint64_t> node_numbers(const Mesh& mesh) {
  return can_be_kept(mesh.vertex_numbers) ? mesh.vertex_numbers : counted(mesh.points.size());
}

/// The numbers of all elements, by dimension, then place.
std::vector<std::uint64_t> element_numbers(const Mesh& mesh) {
  std::vector<std::uint64_t> all;
  for (const Elements& elements : mesh.elements)
    all.insert(all.end(), elements.numbers.begin(), elements.numbers.end());
  return can_be_kept(all) ? all : counted(all.size());
}

std::uint64_t greatest(const std::vector<std::uint64_t>& numbers) {
  return numbers.empty() ? 0 : *std::max_element(numbers.begin(), numbers.end());
}

std::uint64_t least(const std::vector<std::uint64_t>& numbers) {
  return numbers.empty() ? 0 : *std::min_element(numbers.begin(), numbers.end());
}

void write_vertices(TextOutput& out, const Level& level, std::size_t element,
                    const std::vector<std::uint64_t>& nodes) {
  const auto corners = static_cast<std::size_t>(level.dimension) + 1;
  for (std::size_t k = 0; k < corners; ++k)
    out << ' ' << nodes[level.elements->vertices[corners * element + k]];
  out << '\n';
}

void write_point(TextOutput& out, const std::array<double, 3>& point) {
  out << point[0] << ' ' << point[1] << ' ' << point[2];
}

/// Version 2.2: one row per element and group. The first row of an element has its number, further
/// ones get numbers that are not used.
void write_elements_22(TextOutput& out, const Mesh& mesh, const std::array<Level, 4>& levels,
                       const std::vector<std::uint64_t>& nodes) {
  std::vector<std::uint64_t> numbers = element_numbers(mesh);
  std::size_t rows = 0;
  for (const Level& level : levels)
    for (const std::uint32_t set : level.sets.of_element)
      rows += std::max<std::size_t>(1, level.sets.sets[set].size());
  if (greatest(numbers) > std::numeric_limits<std::uint64_t>::max() - rows)
    numbers = counted(numbers.size());
  std::uint64_t further = greatest(numbers);
  out << "$Elements\n" << rows << '\n';
  auto number = numbers.begin();
  for (const Level& level : levels) {
    for (std::size_t e = 0; e < level.elements->size(); ++e, ++number) {
      const std::size_t entity = level.entity_of(e);
      const auto& groups = level.groups_of_entity(entity);
      for (std::size_t g = 0; g < std::max<std::size_t>(1, groups.size()); ++g) {
        const std::int32_t physical = groups.empty() ? 0 : level.tags[groups[g]];
        out << (g == 0 ? *number : ++further) << ' ' << kMshType[level.dimension] << " 2 "
            << physical << ' ' << entity + 1;
        write_vertices(out, level, e, nodes);
      }
    }
  }
  out << "$EndElements\n";
}

void write_22(TextOutput& out, const Mesh& mesh, const std::array<Level, 4>& levels) {
  const auto nodes = node_numbers(mesh);
  out << "$Nodes\n" << nodes.size() << '\n';
  for (std::size_t v = 0; v < nodes.size(); ++v) {
    out << nodes[v] << ' ';
    write_point(out, mesh.points[v]);
    out << '\n';
  }
  out << "$EndNodes\n";
  write_elements_22(out, mesh, levels, nodes);
}

/// Least and greatest coordinates; points that are not finite do not count.
struct Bounds {
  std::array<double, 3> low{}, high{};
  std::array<bool, 3> any{};

  void add(const std::array<double, 3>& point) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (!std::isfinite(point[k])) continue;
      low[k] = any[k] ? std::min(low[k], point[k]) : point[k];
      high[k] = any[k] ? std::max(high[k], point[k]) : point[k];
      any[k] = true;
    }
  }
};

void write_entities(TextOutput& out, const Mesh& mesh, const std::array<Level, 4>& levels) {
  out << "$Entities\n";
  for (const Level& level : levels)
    out << std::count(level.has_elements.begin(), level.has_elements.end(), true)
        << (level.dimension < 3 ? ' ' : '\n');
  for (const Level& level : levels) {
    const auto corners = static_cast<std::size_t>(level.dimension) + 1;
    std::vector<Bounds> bounds(level.has_elements.size());
    for (std::size_t i = 0; i < level.elements->vertices.size(); ++i)
      bounds[level.entity_of(i / corners)].add(mesh.points[level.elements->vertices[i]]);
    for (std::size_t entity = 0; entity < bounds.size(); ++entity) {
      if (!level.has_elements[entity]) continue;
      out << entity + 1 << ' ';
      write_point(out, bounds[entity].low);
      if (level.dimension > 0) {
        out << ' ';
        write_point(out, bounds[entity].high);
      }
      const auto& groups = level.groups_of_entity(entity);
      out << ' ' << groups.size();
      for (const std::size_t g : groups) out << ' ' << level.tags[g];
      out << (level.dimension > 0 ? " 0\n" : "\n");
    }
  }
  out << "$EndEntities\n";
}

/// The end of the run of elements from `first` on that are in the same entity.
std::size_t run_end(const Level& level, std::size_t first) {
  std::size_t end = first + 1;
  while (end < level.elements->size() && level.entity_of(end) == level.entity_of(first)) ++end;
  return end;
}

/// Version 4.1: one block per run of elements of the same entity, so that the order is kept.
void write_elements_41(TextOutput& out, const Mesh& mesh, const std::array<Level, 4>& levels,
                       const std::vector<std::uint64_t>& nodes) {
  const auto numbers = element_numbers(mesh);
  std::size_t blocks = 0;
  for (const Level& level : levels)
    for (std::size_t e = 0; e < level.elements->size(); e = run_end(level, e)) ++blocks;
  out << "$Elements\n"
      << blocks << ' ' << numbers.size() << ' ' << least(numbers) << ' ' << greatest(numbers)
      << '\n';
  auto number = numbers.begin();
  for (const Level& level : levels) {
    for (std::size_t first = 0; first < level.elements->size();) {
      const std::size_t end = run_end(level, first);
      out << level.dimension << ' ' << level.entity_of(first) + 1 << ' '
          << kMshType[level.dimension] << ' ' << end - first << '\n';
      for (; first < end; ++first) {
        out << *number++;
        write_vertices(out, level, first, nodes);
      }
    }
  }
  out << "$EndElements\n";
}

void write_41(TextOutput& out, const Mesh& mesh, const std::array<Level, 4>& levels) {
  const auto nodes = node_numbers(mesh);
  const std::size_t owner = levels[static_cast<std::size_t>(mesh.dimension)].entity_of(0) + 1;
  write_entities(out, mesh, levels);
  out << "$Nodes\n1 " << nodes.size() << ' ' << least(nodes) << ' ' << greatest(nodes) << '\n'
      << mesh.dimension << ' ' << owner << " 0 " << nodes.size() << '\n';
  for (const std::uint64_t number : nodes) out << number << '\n';
  for (const auto& point : mesh.points) {
    write_point(out, point);
    out << '\n';
  }
  out << "$EndNodes\n";
  write_elements_41(out, mesh, levels, nodes);
}

}  // namespace

void write_msh(TextOutput& out, const Mesh& mesh) {
  const bool is_41 = mesh.msh_version == MshVersion::k41;
  const auto levels = levels_of(mesh);
  out << "$MeshFormat\n" << (is_41 ? "4.1" : "2.2") << " 0 8\n$EndMeshFormat\n";
  write_physical_names(out, levels);
  if (is_41)
    write_41(out, mesh, levels);
  else
    write_22(out, mesh, levels);
}

}  // namespace cleave::app
