#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "files/group_sets.hpp"
#include "files/input_text.hpp"
#include "files/msh_nodes.hpp"
#include "files/row.hpp"
#include "files/text_output.hpp"
#include "mesh.hpp"

namespace cleave::app {

/// Reads a gmsh file, versions 2.2 (and 2.0, 2.1, which differ only in tags that are not needed)
/// and 4.1, text form. Numbers are the file's tags of nodes and elements, up to 64 bits; groups are
/// the physical groups, with their sign dropped; sections that say nothing about elements
/// ($Periodic, $NodeData, ...) are skipped.
Mesh read_msh(const InputText& text);

struct MshForm {
  MshVersion version;
  bool binary;  // in the machine's order of bytes
};

/// Writes a gmsh file. Numbers are kept if they are distinct and positive (the elements' over all
/// dimensions together) and fit (binary 2.2 has 32 bits), else everything is numbered from 1 on.
/// Version 2.2 repeats an element that is in several groups, as gmsh does. Throws OutputError for a
/// group or field whose name the format cannot hold.
void write_msh(TextOutput& out, const Mesh& mesh, const MshForm& form);

/// One $Section .. $EndSection of a file.
struct MshSection {
  std::string name;    // without the dollar
  const char* opened;  // the line that opens it, for messages
  const char* begin;   // its content
  const char* end;
};

/// The sections in order. Throws InputError if one is not closed or text stands outside.
std::vector<MshSection> msh_sections(const InputText& text);

/// A number that is known to come twice: looking at each finds the second one's line.
struct WatchedNumber {
  std::optional<std::uint64_t> number;
  bool seen = false;

  void look(const Row& row, std::uint64_t at, const char* kind) {
    if (number && at == *number) look_at(row, kind);
  }

 private:
  void look_at(const Row& row, const char* kind);
};

/// What the sections of both versions fill.
struct MshContent {
  Mesh mesh;
  WatchedNumber watched_node, watched_element;
  MshNodes nodes;
  GroupCollector groups;

  /// Adds the element that the rest of `row` describes (the nodes of a linear simplex of
  /// `dimension`); returns its place.
  std::uint32_t add_element(Row& row, int dimension, std::uint64_t number);
};

/// The dimension of gmsh's element type. Throws InputError for all but points and linear lines,
/// triangles and tetrahedra; `number` is the element's, if one element is meant.
int msh_dimension(const Row& row, int type, std::optional<std::uint64_t> number);

/// The number of a physical group, without the sign that gmsh uses for orientation.
std::int32_t msh_physical_tag(Row& row);

void read_msh22_nodes(const InputText& text, const MshSection& section, MshContent& content);
void read_msh22_elements(const InputText& text, const MshSection& section, MshContent& content);

/// `entities` may be null; elements of entities that it does not describe have no group (meshio
/// writes such files).
void read_msh41_nodes(const InputText& text, const MshSection& section, MshContent& content);
void read_msh41_elements(const InputText& text, const MshSection& section,
                         const MshSection* entities, MshContent& content);

}  // namespace cleave::app
