#include <algorithm>
#include <map>
#include <utility>

#include "files/msh_content.hpp"

namespace cleave::app {
namespace {

/// The row of a reader of rows.
template <class Rows>
using RowOf = decltype(std::declval<Rows&>().next(""));

/// A block of nodes or elements: what its first row says.
template <class Rows>
struct Block {
  RowOf<Rows> row;
  int dimension;
  std::int32_t entity;
  int kind;  // nodes: 1 if they have parameters; elements: their type
  std::size_t count;
};

template <class Rows>
Block<Rows> read_block(Rows& rows, const char* kind, const char* count) {
  Block<Rows> block{rows.next("a block"), 0, 0, 0, 0};
  auto row = block.row;
  block.dimension = row.template number<std::int32_t>("the dimension of an entity");
  if (block.dimension < 0 || block.dimension > 3)
    row.fail("the dimension of an entity must be 0, 1, 2 or 3");
  block.entity = row.template number<std::int32_t>("the number of an entity");
  block.kind = row.template number<std::int32_t>(kind);
  block.count = rows.count(row, count);
  row.finish("a block");
  return block;
}

struct Totals {
  const char* begin;
  std::size_t blocks, entries;
};

/// The first row of $Nodes or $Elements: counts of blocks and entries, least and greatest number.
template <class Rows>
Totals read_totals(Rows& rows, const char* what, std::size_t least) {
  auto row = rows.next("the counts of the section");
  Totals totals{};
  totals.begin = row.begin();
  totals.blocks = rows.count(row, "the number of blocks");
  totals.entries = rows.count(row, what, least);
  row.template number<std::uint64_t>("the least number");
  row.template number<std::uint64_t>("the greatest number");
  row.finish("the counts of the section");
  return totals;
}

template <class Rows>
void check_total(Rows& rows, const Totals& totals, std::size_t found, const char* what) {
  if (rows.more()) rows.next("a block").fail("more blocks than the count says");
  if (found != totals.entries)
    rows.text().fail(totals.begin, std::string(what) + " is " + std::to_string(totals.entries) +
                                       ", but the blocks hold " + std::to_string(found));
}

template <class Rows>
void read_point(Rows& rows, const Block<Rows>& block, std::vector<std::array<double, 3>>& points) {
  auto row = rows.next("the coordinates of a node");
  const auto x = row.template number<double>("the x coordinate of a node");
  const auto y = row.template number<double>("the y coordinate of a node");
  const auto z = row.template number<double>("the z coordinate of a node");
  const int parameters = block.kind != 0 ? block.dimension : 0;
  for (int k = 0; k < parameters; ++k) row.template number<double>("a parameter of a node");
  row.finish("a node");
  points.push_back({x, y, z});
}

}  // namespace

template <class Rows>
MshEntities read_msh41_entities(Rows& rows) {
  auto header = rows.next("the numbers of entities");
  std::size_t counts[4];
  for (std::size_t& count : counts) count = rows.count(header, "the number of entities");
  header.finish("the numbers of entities");
  MshEntities entities;
  for (int dimension = 0; dimension <= 3; ++dimension) {
    for (std::size_t i = 0; i < counts[dimension]; ++i) {
      auto row = rows.next("an entity");
      const auto tag = row.template number<std::int32_t>("the number of an entity");
      for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k)
        row.template number<double>("a bound of an entity");
      std::vector<std::int32_t> groups;
      const auto group_count = row.template number<std::uint64_t>("the number of physical groups");
      for (std::uint64_t k = 0; k < group_count; ++k)
        if (const std::int32_t group = msh_physical_tag(row); group != 0) groups.push_back(group);
      const auto bounds =
          dimension == 0 ? 0 : row.template number<std::uint64_t>("the number of bounds");
      for (std::uint64_t k = 0; k < bounds; ++k)
        row.template number<std::int32_t>("a bounding entity");
      row.finish("an entity");
      if (!entities.emplace(std::pair{dimension, tag}, std::move(groups)).second)
        row.fail("entity " + std::to_string(tag) + " of dimension " + std::to_string(dimension) +
                 " is described a second time");
    }
  }
  if (rows.more()) rows.next("an entity").fail("more entities than the counts say");
  return entities;
}

template <class Rows>
void read_msh41_nodes(Rows& rows, MshContent& content) {
  constexpr bool kBinary = std::is_same_v<Rows, BinaryRows>;
  const Totals totals = read_totals(rows, "the number of nodes", kBinary ? 32 : 7);
  auto& points = content.mesh.points;
  auto& numbers = content.mesh.vertex_numbers;
  points.reserve(totals.entries);
  numbers.reserve(totals.entries);
  for (std::size_t b = 0; b < totals.blocks; ++b) {
    const auto block = read_block(rows, "whether nodes have parameters", "the number of nodes");
    for (std::size_t i = 0; i < block.count; ++i) {
      auto row = rows.next("the number of a node");
      numbers.push_back(row.template number<std::uint64_t>("the number of a node"));
      content.watched_node.look(row, numbers.back(), "node");
      row.finish("the number of a node");
    }
    for (std::size_t i = 0; i < block.count; ++i) read_point(rows, block, points);
  }
  check_total(rows, totals, points.size(), "the number of nodes");
}

template <class Rows>
void read_msh41_elements(Rows& rows, const MshEntities& entities, MshContent& content) {
  constexpr bool kBinary = std::is_same_v<Rows, BinaryRows>;
  const Totals totals = read_totals(rows, "the number of elements", kBinary ? 16 : 3);
  std::size_t found = 0;
  for (std::size_t b = 0; b < totals.blocks; ++b) {
    const auto block = read_block(rows, "the type of elements", "the number of elements");
    const MshKind& kind = msh_kind(block.row, block.kind, std::nullopt);
    const auto known = entities.find({block.dimension, block.entity});
    if (kind.dimension != block.dimension)
      block.row.fail("elements of dimension " + std::to_string(kind.dimension) +
                     " in an entity of dimension " + std::to_string(block.dimension));
    const std::size_t group_count = known != entities.end() ? known->second.size() : 0;
    if (kind.cohesive && group_count > 1) content.cohesive_in_several_groups = true;
    constexpr std::size_t kLeast = kBinary ? 8 : 2;  // bytes of a number; a count may lie
    content.expect(kind, std::min(block.count, rows.bytes_left() / kLeast / (1 + kind.nodes())));
    for (std::size_t i = 0; i < block.count; ++i) {
      auto row = rows.next("an element");
      const auto number = row.template number<std::uint64_t>("the number of an element");
      if (kind.cohesive) {
        content.template add_cohesive<false>(row, kind, number,
                                             group_count > 0 ? known->second.front() : 0);
        continue;
      }
      const Index place = content.template add_element<false>(row, kind, number);
      for (std::size_t g = 0; g < group_count; ++g)
        content.groups.add(kind.dimension, known->second[g], place);
    }
    found += block.count;
  }
  check_total(rows, totals, found, "the number of elements");
}

template <class Rows>
void read_msh41_periodic(Rows& rows, MshContent& content) {
  auto header = rows.next("the number of periodic entities");
  const std::size_t count = rows.count(header, "the number of periodic entities");
  header.finish("the number of periodic entities");
  for (std::size_t i = 0; i < count; ++i) {
    Periodicity periodic;
    auto row = rows.next("a periodic entity");
    periodic.dimension = row.template number<std::int32_t>("the dimension of an entity");
    if (periodic.dimension < 0 || periodic.dimension > 2)
      row.fail("the dimension of a periodic entity must be 0, 1 or 2");
    periodic.entity = row.template number<std::int32_t>("the number of an entity");
    periodic.master = row.template number<std::int32_t>("the number of an entity");
    row.finish("a periodic entity");
    auto affine = rows.next("the size of an affine map");
    const auto size = affine.template number<std::uint64_t>("the size of an affine map");
    if (size != 0 && size != 16)
      affine.fail("an affine map has 0 or 16 numbers, not " + std::to_string(size));
    for (std::uint64_t k = 0; k < size; ++k)
      periodic.affine.push_back(affine.template number<double>("a number of an affine map"));
    affine.finish("an affine map");
    auto pairs = rows.next("the number of pairs of nodes");
    const std::size_t pair_count = rows.count(pairs, "the number of pairs of nodes", 3);
    pairs.finish("the number of pairs of nodes");
    const auto entity = static_cast<std::uint64_t>(std::abs(periodic.entity));
    periodic.pairs.reserve(pair_count);
    for (std::size_t p = 0; p < pair_count; ++p) {
      auto pair = rows.next("a pair of nodes");
      const auto vertex = content.template node<false>(pair, "periodic entity", entity);
      const auto master = content.template node<false>(pair, "periodic entity", entity);
      periodic.pairs.push_back({vertex, master});
      pair.finish("a pair of nodes");
    }
    content.mesh.periodic.push_back(std::move(periodic));
  }
  if (rows.more()) rows.next("a pair").fail("more periodic entities than the count says");
}

template MshEntities read_msh41_entities(RowReader&);
template MshEntities read_msh41_entities(BinaryRows&);
template void read_msh41_nodes(RowReader&, MshContent&);
template void read_msh41_nodes(BinaryRows&, MshContent&);
template void read_msh41_elements(RowReader&, const MshEntities&, MshContent&);
template void read_msh41_elements(BinaryRows&, const MshEntities&, MshContent&);
template void read_msh41_periodic(RowReader&, MshContent&);
template void read_msh41_periodic(BinaryRows&, MshContent&);

}  // namespace cleave::app
