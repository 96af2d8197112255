#include <map>
#include <utility>

#include "files/msh_format.hpp"

namespace cleave::app {
namespace {

/// The physical groups of each geometrical entity, by dimension and tag.
using Entities = std::map<std::pair<int, std::int32_t>, std::vector<std::int32_t>>;

Entities read_entities(const InputText& text, const MshSection& section) {
  RowReader rows(text, section.begin, section.end);
  Row header = rows.next("the numbers of entities");
  std::size_t counts[4];
  for (std::size_t& count : counts) count = rows.count(header, "the number of entities");
  header.finish("the numbers of entities");
  Entities entities;
  for (int dimension = 0; dimension <= 3; ++dimension) {
    for (std::size_t i = 0; i < counts[dimension]; ++i) {
      Row row = rows.next("an entity");
      const auto tag = row.number<std::int32_t>("the number of an entity");
      for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k) row.number<double>("a bound of an entity");
      std::vector<std::int32_t> groups;
      const auto group_count = row.number<std::uint32_t>("the number of physical groups");
      for (std::uint32_t k = 0; k < group_count; ++k) groups.push_back(msh_physical_tag(row));
      const auto bounds = dimension == 0 ? 0 : row.number<std::uint32_t>("the number of bounds");
      for (std::uint32_t k = 0; k < bounds; ++k) row.number<std::int32_t>("a bounding entity");
      row.finish("an entity");
      if (!entities.emplace(std::pair{dimension, tag}, std::move(groups)).second)
        row.fail("entity " + std::to_string(tag) + " of dimension " + std::to_string(dimension) +
                 " is described a second time");
    }
  }
  if (rows.more()) rows.next("an entity").fail("more entities than the counts say");
  return entities;
}

/// A block of nodes or elements: what its first row says.
struct Block {
  Row row;
  int dimension;
  std::int32_t entity;
  int kind;  // nodes: 1 if they have parameters; elements: their type
  std::size_t count;
};

Block read_block(RowReader& rows, const char* kind, const char* count) {
  Block block{rows.next("a block"), 0, 0, 0, 0};
  Row row = block.row;
  block.dimension = row.number<int>("the dimension of an entity");
  if (block.dimension < 0 || block.dimension > 3)
    row.fail("the dimension of an entity must be 0, 1, 2 or 3");
  block.entity = row.number<std::int32_t>("the number of an entity");
  block.kind = row.number<int>(kind);
  block.count = rows.count(row, count);
  row.finish("a block");
  return block;
}

struct Totals {
  const char* begin;
  std::size_t blocks, entries;
};

/// The first row of $Nodes or $Elements: counts of blocks and entries, least and greatest number.
Totals read_totals(RowReader& rows, const char* what) {
  Row row = rows.next("the counts of the section");
  Totals totals{};
  totals.begin = row.begin();
  totals.blocks = rows.count(row, "the number of blocks");
  totals.entries = rows.count(row, what);
  row.number<std::uint64_t>("the least number");
  row.number<std::uint64_t>("the greatest number");
  row.finish("the counts of the section");
  return totals;
}

void check_total(RowReader& rows, const Totals& totals, std::size_t found, const char* what) {
  if (rows.more()) rows.next("a block").fail("more blocks than the count says");
  if (found != totals.entries)
    rows.text().fail(totals.begin, std::string(what) + " is " + std::to_string(totals.entries) +
                                       ", but the blocks hold " + std::to_string(found));
}

void read_point(RowReader& rows, const Block& block, std::vector<std::array<double, 3>>& points) {
  Row row = rows.next("the coordinates of a node");
  const auto x = row.number<double>("the x coordinate of a node");
  const auto y = row.number<double>("the y coordinate of a node");
  const auto z = row.number<double>("the z coordinate of a node");
  const int parameters = block.kind != 0 ? block.dimension : 0;
  for (int k = 0; k < parameters; ++k) row.number<double>("a parameter of a node");
  row.finish("a node");
  points.push_back({x, y, z});
}

}  // namespace

void read_msh41_nodes(const InputText& text, const MshSection& section, MshContent& content) {
  RowReader rows(text, section.begin, section.end);
  const Totals totals = read_totals(rows, "the number of nodes");
  auto& points = content.mesh.points;
  auto& numbers = content.mesh.vertex_numbers;
  points.reserve(totals.entries);
  numbers.reserve(totals.entries);
  for (std::size_t b = 0; b < totals.blocks; ++b) {
    const Block block = read_block(rows, "whether nodes have parameters", "the number of nodes");
    for (std::size_t i = 0; i < block.count; ++i) {
      Row row = rows.next("the number of a node");
      numbers.push_back(row.number<std::uint64_t>("the number of a node"));
      content.watched_node.look(row, numbers.back(), "node");
      row.finish("the number of a node");
    }
    for (std::size_t i = 0; i < block.count; ++i) read_point(rows, block, points);
  }
  check_total(rows, totals, points.size(), "the number of nodes");
}

void read_msh41_elements(const InputText& text, const MshSection& section,
                         const MshSection* entities, MshContent& content) {
  const Entities groups = entities != nullptr ? read_entities(text, *entities) : Entities();
  RowReader rows(text, section.begin, section.end);
  const Totals totals = read_totals(rows, "the number of elements");
  std::size_t found = 0;
  for (std::size_t b = 0; b < totals.blocks; ++b) {
    const Block block = read_block(rows, "the type of elements", "the number of elements");
    const int dimension = msh_dimension(block.row, block.kind, std::nullopt);
    const auto known = groups.find({block.dimension, block.entity});
    if (dimension != block.dimension)
      block.row.fail("elements of dimension " + std::to_string(dimension) +
                     " in an entity of dimension " + std::to_string(block.dimension));
    for (std::size_t i = 0; i < block.count; ++i) {
      Row row = rows.next("an element");
      const auto number = row.number<std::uint64_t>("the number of an element");
      const std::uint32_t place = content.add_element(row, dimension, number);
      if (known == groups.end()) continue;
      for (const std::int32_t group : known->second) content.groups.add(dimension, group, place);
    }
    found += block.count;
  }
  check_total(rows, totals, found, "the number of elements");
}

}  // namespace cleave::app
