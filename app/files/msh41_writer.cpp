#include <algorithm>
#include <cmath>
#include <map>

#include "files/msh_output.hpp"

namespace cleave::app {
namespace {

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

struct Entity {
  Bounds bounds;
  std::vector<std::int32_t> groups;  // tags of its physical groups
};

/// The entities of one dimension by tag: those that elements are in, and those that are periodic.
std::map<std::int32_t, Entity> entities_of(const Mesh& mesh, const std::vector<MshLevel>& levels,
                                           int dimension) {
  std::map<std::int32_t, Entity> entities;
  for (const MshLevel& level : levels) {
    if (level.kind.dimension != dimension) continue;
    std::vector<Bounds> bounds(level.entities.size());
    for (std::size_t e = 0; e < level.count; ++e)
      for (std::size_t k = 0; k < level.kind.nodes(); ++k)
        bounds[level.entity_of(e)].add(mesh.points[level.nodes(e)[k]]);
    for (std::size_t entity = 0; entity < bounds.size(); ++entity) {
      if (level.entities[entity] == 0) continue;
      Entity& described = entities[level.entities[entity]];
      described.bounds = bounds[entity];
      for (const std::size_t g : level.groups_of_entity(entity))
        described.groups.push_back(level.tags[g]);
    }
  }
  for (const Periodicity& periodic : mesh.periodic) {
    if (periodic.dimension != dimension) continue;
    for (const auto& pair : periodic.pairs) {
      entities[static_cast<std::int32_t>(periodic.entity)].bounds.add(mesh.points[pair.vertex]);
      entities[static_cast<std::int32_t>(periodic.master)].bounds.add(mesh.points[pair.master]);
    }
  }
  return entities;
}

void write_entities(MshRows& rows, const Mesh& mesh, const std::vector<MshLevel>& levels) {
  std::array<std::map<std::int32_t, Entity>, 4> all;
  for (int d = 0; d <= 3; ++d) all[static_cast<std::size_t>(d)] = entities_of(mesh, levels, d);
  rows.open("Entities");
  for (const auto& entities : all) rows.put(std::uint64_t{entities.size()});
  rows.end_row();
  for (std::size_t d = 0; d <= 3; ++d) {
    for (const auto& [tag, entity] : all[d]) {
      rows.put(tag);
      rows.put(entity.bounds.low);
      if (d > 0) rows.put(entity.bounds.high);
      rows.put(std::uint64_t{entity.groups.size()});
      for (const std::int32_t group : entity.groups) rows.put(group);
      if (d > 0) rows.put(std::uint64_t{0});  // bounding entities
      rows.end_row();
    }
  }
  rows.close("Entities");
}

/// The first row of $Nodes and $Elements.
void write_totals(MshRows& rows, std::uint64_t blocks, const std::vector<std::uint64_t>& numbers) {
  const auto range = std::minmax_element(numbers.begin(), numbers.end());
  const bool any = !numbers.empty();
  rows.row(blocks, std::uint64_t{numbers.size()}, any ? *range.first : 0, any ? *range.second : 0);
}

void write_nodes(MshRows& rows, const Mesh& mesh, std::int32_t owner, const MshNumbers& numbers) {
  rows.open("Nodes");
  write_totals(rows, 1, numbers.nodes);
  rows.row(std::int32_t{mesh.dimension}, owner, std::int32_t{0},
           std::uint64_t{numbers.nodes.size()});
  for (const std::uint64_t number : numbers.nodes) rows.row(number);
  for (const auto& point : mesh.points) rows.row(point);
  rows.close("Nodes");
}

/// The end of the run of elements from `first` on that are in the same entity.
std::size_t run_end(const MshLevel& level, std::size_t first) {
  std::size_t end = first + 1;
  while (end < level.count && level.entity_of(end) == level.entity_of(first)) ++end;
  return end;
}

/// One block per run of elements of the same entity, so that the order is kept.
void write_elements(MshRows& rows, const std::vector<MshLevel>& levels, const MshNumbers& numbers) {
  std::uint64_t blocks = 0;
  for (const MshLevel& level : levels)
    for (std::size_t e = 0; e < level.count; e = run_end(level, e)) ++blocks;
  rows.open("Elements");
  write_totals(rows, blocks, numbers.elements);
  auto number = numbers.elements.begin();
  for (const MshLevel& level : levels) {
    for (std::size_t first = 0; first < level.count;) {
      const std::size_t end = run_end(level, first);
      rows.row(std::int32_t{level.kind.dimension}, level.tag_of(first),
               std::int32_t{level.kind.type}, std::uint64_t{end - first});
      for (; first < end; ++first) {
        rows.put(*number++);
        for (std::size_t k = 0; k < level.kind.nodes(); ++k)
          rows.put(numbers.nodes[level.nodes(first)[k]]);
        rows.end_row();
      }
    }
  }
  rows.close("Elements");
}

void write_periodic(MshRows& rows, const Mesh& mesh, const MshNumbers& numbers) {
  rows.open("Periodic");
  rows.row(std::uint64_t{mesh.periodic.size()});
  for (const Periodicity& periodic : mesh.periodic) {
    rows.row(std::int32_t{periodic.dimension}, static_cast<std::int32_t>(periodic.entity),
             static_cast<std::int32_t>(periodic.master));
    rows.put(std::uint64_t{periodic.affine.size()});
    for (const double x : periodic.affine) rows.put(x);
    rows.end_row();
    rows.row(std::uint64_t{periodic.pairs.size()});
    for (const auto& pair : periodic.pairs)
      rows.row(numbers.nodes[pair.vertex], numbers.nodes[pair.master]);
  }
  rows.close("Periodic");
}

}  // namespace

void write_msh41(MshRows& rows, const Mesh& mesh, const std::vector<MshLevel>& levels,
                 const MshNumbers& numbers) {
  write_entities(rows, mesh, levels);
  write_nodes(rows, mesh, levels[static_cast<std::size_t>(mesh.dimension)].tag_of(0), numbers);
  write_elements(rows, levels, numbers);
  if (!mesh.periodic.empty()) write_periodic(rows, mesh, numbers);
}

}  // namespace cleave::app
