#include <algorithm>

#include "files/msh_output.hpp"

namespace cleave::app {
namespace {

/// One number of a node, an element or a tag: text has any, binary 32 bits.
void put_number(MshRows& rows, std::uint64_t number) {
  rows.binary() ? rows.put(static_cast<std::int32_t>(number)) : rows.put(number);
}

/// So many rows an element has: one per group, at least one.
std::size_t rows_of(const MshLevel& level, std::size_t element) {
  return std::max<std::size_t>(1, level.groups_of_entity(level.entity_of(element)).size());
}

std::size_t rows_of(const MshLevel& level) {
  std::size_t rows = 0;
  for (std::size_t e = 0; e < level.count; ++e) rows += rows_of(level, e);
  return rows;
}

void write_nodes(MshRows& rows, const Mesh& mesh, const MshNumbers& numbers) {
  rows.open("Nodes");
  rows.text() << numbers.nodes.size() << '\n';
  for (std::size_t v = 0; v < numbers.nodes.size(); ++v) {
    put_number(rows, numbers.nodes[v]);
    rows.row(mesh.points[v]);
  }
  rows.close("Nodes");
}

/// Writes the rows of one level; the first row of an element has its number, further ones get
/// numbers that are not used. In binary a header says what all rows have in common.
void write_level(MshRows& rows, const MshLevel& level, const std::vector<std::uint64_t>& nodes,
                 const std::uint64_t* number, std::uint64_t& further) {
  const std::int32_t type = level.kind.type, tag_count = 2;
  if (rows.binary() && level.count > 0)
    rows.row(type, static_cast<std::int32_t>(rows_of(level)), tag_count);
  for (std::size_t e = 0; e < level.count; ++e, ++number) {
    const auto& groups = level.groups_of_entity(level.entity_of(e));
    for (std::size_t r = 0; r < rows_of(level, e); ++r) {
      put_number(rows, r == 0 ? *number : ++further);
      if (!rows.binary()) {
        rows.put(type);
        rows.put(tag_count);
      }
      rows.put(groups.empty() ? 0 : level.tags[groups[r]]);
      rows.put(level.tag_of(e));
      for (std::size_t k = 0; k < level.kind.nodes(); ++k)
        put_number(rows, nodes[level.nodes(e)[k]]);
      rows.end_row();
    }
  }
}

/// Always text, as gmsh has it.
void write_periodic(MshRows& rows, const Mesh& mesh, const MshNumbers& numbers) {
  TextOutput& out = rows.text();
  out << "$Periodic\n" << mesh.periodic.size() << '\n';
  for (const Periodicity& periodic : mesh.periodic) {
    out << periodic.dimension << ' ' << periodic.entity << ' ' << periodic.master << '\n';
    if (!periodic.affine.empty()) {
      out << "Affine";
      for (const double x : periodic.affine) out << ' ' << x;
      out << '\n';
    }
    out << periodic.pairs.size() << '\n';
    for (const auto& pair : periodic.pairs)
      out << numbers.nodes[pair.vertex] << ' ' << numbers.nodes[pair.master] << '\n';
  }
  out << "$EndPeriodic\n";
}

}  // namespace

void write_msh22(MshRows& rows, const Mesh& mesh, const std::vector<MshLevel>& levels,
                 const MshNumbers& numbers) {
  write_nodes(rows, mesh, numbers);
  std::size_t count = 0;
  for (const MshLevel& level : levels) count += rows_of(level);
  rows.open("Elements");
  rows.text() << count << '\n';
  const std::uint64_t* number = numbers.elements.data();
  std::uint64_t further = 0;
  for (const std::uint64_t used : numbers.elements) further = std::max(further, used);
  for (const MshLevel& level : levels) {
    write_level(rows, level, numbers.nodes, number, further);
    number += level.count;
  }
  rows.close("Elements");
  if (!mesh.periodic.empty()) write_periodic(rows, mesh, numbers);
}

}  // namespace cleave::app
