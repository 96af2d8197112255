#include <algorithm>
#include <array>
#include <cstdlib>

#include "files/msh_format.hpp"
#include "files/msh_kind.hpp"

namespace cleave::app {
namespace {

constexpr const char* kHowToConvert =
    "; convert it with `gmsh FILE -save -format msh41 -o NEW.msh`";

/// The end of the line that `place` is on.
const char* line_end(const char* place, const char* end) {
  const auto* newline =
      static_cast<const char*>(std::memchr(place, '\n', static_cast<std::size_t>(end - place)));
  return newline != nullptr ? newline : end;
}

/// The line at `place` without blanks at its end.
std::string_view line_at(const char* place, const char* end) {
  std::string_view line(place, static_cast<std::size_t>(line_end(place, end) - place));
  const auto last = line.find_last_not_of(" \t\r");
  return line.substr(0, last == std::string_view::npos ? 0 : last + 1);
}

/// The next place at or after `place` where a line starts with a dollar; `end` if there is none.
const char* next_dollar_line(const InputText& text, const char* place) {
  while (place != text.end()) {
    const auto left = static_cast<std::size_t>(text.end() - place);
    const auto* dollar = static_cast<const char*>(std::memchr(place, '$', left));
    if (dollar == nullptr) break;
    if (dollar == text.begin() || dollar[-1] == '\n') return dollar;
    place = dollar + 1;
  }
  return text.end();
}

/// Reads $MeshFormat, which comes first ($Comments may come before it). This must be done before
/// anything is looked for in the rest: that may be binary.
MshVersion read_version(const InputText& text) {
  RowReader rows(text, text.begin(), text.end());
  const auto next_line = [&]() -> std::string_view {
    return rows.more() ? rows.next("a line").rest() : std::string_view();
  };
  std::string_view line = next_line();
  if (line == "$Comments") {
    while (rows.more() && line != "$EndComments") line = next_line();
    line = next_line();
  }
  if (line != "$MeshFormat") text.fail_format("a gmsh file, which starts with $MeshFormat");
  Row row = rows.next("the version of the format");
  const std::string version(row.word());
  const int type = row.number<int>("the file type, 0 or 1");
  if (type != 0)
    row.fail("this is a binary gmsh file; only the text form is read" + std::string(kHowToConvert));
  row.number<int>("the size of a real number");
  row.finish("the version");
  Row closing = rows.next("$EndMeshFormat");
  if (closing.rest() != "$EndMeshFormat") closing.fail("expected $EndMeshFormat");
  if (version == "4.1") return MshVersion::k41;
  for (const char* old : {"2.2", "2.1", "2.0", "2"})
    if (version == old) return MshVersion::k22;
  row.fail("this is version " + printable(version, 10) +
           " of gmsh's format; versions 2.2 and 4.1 are read" + kHowToConvert);
}

const MshSection* find_section(const InputText& text, const std::vector<MshSection>& sections,
                               std::string_view name, bool required) {
  const MshSection* found = nullptr;
  for (const MshSection& section : sections) {
    if (section.name != name) continue;
    if (found != nullptr) text.fail(section.opened, "a second section $" + section.name);
    found = &section;
  }
  if (required && found == nullptr)
    text.fail(text.end() - 1, "the file has no section $" + std::string(name) +
                                  "; it may be truncated, or hold no mesh");
  return found;
}

void read_physical_names(const InputText& text, const MshSection& section, MshContent& content) {
  RowReader rows(text, section.begin, section.end);
  Row header = rows.next("the number of names");
  const std::size_t count = rows.count(header, "the number of names");
  header.finish("the number of names");
  for (std::size_t i = 0; i < count; ++i) {
    Row row = rows.next("a name");
    const int dimension = row.number<int>("the dimension of a group");
    if (dimension < 0 || dimension > 3) row.fail("the dimension of a group must be 0, 1, 2 or 3");
    const int tag = row.number<int>("the number of a group");
    const std::string_view name = row.rest();
    if (name.size() < 3 || name.front() != '"' || name.find('"', 1) != name.size() - 1)
      row.fail("expected the name of a group in quotation marks at the end of the line");
    content.groups.name(dimension, tag, std::string(name.substr(1, name.size() - 2)));
  }
  if (rows.more()) rows.next("a name").fail("more names than the count says");
}

/// What gmsh calls its element types, from number 1 on.
constexpr std::array<const char*, 31> kTypeNames = {"2-node line",
                                                    "3-node triangle",
                                                    "4-node quadrangle",
                                                    "4-node tetrahedron",
                                                    "8-node hexahedron",
                                                    "6-node prism",
                                                    "5-node pyramid",
                                                    "3-node second order line",
                                                    "6-node second order triangle",
                                                    "9-node second order quadrangle",
                                                    "10-node second order tetrahedron",
                                                    "27-node second order hexahedron",
                                                    "18-node second order prism",
                                                    "14-node second order pyramid",
                                                    "1-node point",
                                                    "8-node second order quadrangle",
                                                    "20-node second order hexahedron",
                                                    "15-node second order prism",
                                                    "13-node second order pyramid",
                                                    "9-node third order incomplete triangle",
                                                    "10-node third order triangle",
                                                    "12-node fourth order incomplete triangle",
                                                    "15-node fourth order triangle",
                                                    "15-node fifth order incomplete triangle",
                                                    "21-node fifth order triangle",
                                                    "4-node third order edge",
                                                    "5-node fourth order edge",
                                                    "6-node fifth order edge",
                                                    "20-node third order tetrahedron",
                                                    "35-node fourth order tetrahedron",
                                                    "56-node fifth order tetrahedron"};

/// A number that two elements of any dimension share, if there is one.
std::optional<std::uint64_t> repeated_number(const std::array<Elements, 4>& elements) {
  std::vector<std::uint64_t> all;
  for (const Elements& of_dimension : elements)
    all.insert(all.end(), of_dimension.numbers.begin(), of_dimension.numbers.end());
  if (!std::is_sorted(all.begin(), all.end())) std::sort(all.begin(), all.end());
  const auto twice = std::adjacent_find(all.begin(), all.end());
  return twice != all.end() ? std::optional(*twice) : std::nullopt;
}

bool is_simplex(std::string_view name) {
  return name.find("line") != name.npos || name.find("edge") != name.npos ||
         name.find("triangle") != name.npos || name.find("tetrahedron") != name.npos;
}

}  // namespace

std::vector<MshSection> msh_sections(const InputText& text) {
  std::vector<MshSection> sections;
  RowReader between(text, text.begin(), text.end());
  while (between.more()) {
    const Row row = between.next("a section");
    const std::string_view line = row.rest();
    if (line.front() != '$' || line.substr(0, 4) == "$End")
      row.fail("expected the name of a section, $Nodes or the like, found '" + printable(line, 40) +
               "'");
    const std::string name(line.substr(1));
    const char* begin = line_end(line.data(), text.end());
    const char* end = next_dollar_line(text, begin);
    while (end != text.end() && line_at(end, text.end()) != "$End" + name)
      end = next_dollar_line(text, end + 1);
    if (end == text.end())
      row.fail("the section $" + printable(name, 40) + " is not closed by $End" +
               printable(name, 40) + "; the file may be truncated");
    sections.push_back({name, line.data(), begin, end});
    between = RowReader(text, line_end(end, text.end()), text.end());
  }
  return sections;
}

void WatchedNumber::look_at(const Row& row, const char* kind) {
  if (seen)
    row.fail(std::string(kind) + " number " + std::to_string(*number) +
             " is used a second time; numbers must be distinct");
  seen = true;
}

std::int32_t msh_physical_tag(Row& row) {
  const auto tag = row.number<std::int32_t>("the number of a physical group");
  if (tag == INT32_MIN) row.fail("the number of a physical group is out of range");
  return std::abs(tag);
}

std::uint32_t MshContent::add_element(Row& row, int dimension, std::uint64_t number) {
  Elements& elements = mesh.elements[static_cast<std::size_t>(dimension)];
  for (int k = 0; k <= dimension; ++k) {
    const auto node = row.number<std::uint64_t>("the number of a node");
    const std::uint32_t place = nodes.find(node);
    if (place == MshNodes::kNone)
      row.fail("element " + std::to_string(number) + " uses node " + std::to_string(node) +
               ", which $Nodes does not hold");
    elements.vertices.push_back(place);
  }
  row.finish("an element");
  watched_element.look(row, number, "element");
  elements.numbers.push_back(number);
  return static_cast<std::uint32_t>(elements.size() - 1);
}

int msh_dimension(const Row& row, int type, std::optional<std::uint64_t> number) {
  for (int dimension = 0; dimension <= 3; ++dimension)
    if (msh_simplex(dimension, false).type == type) return dimension;
  const bool known = type >= 1 && type <= static_cast<int>(kTypeNames.size());
  const std::string name = known ? kTypeNames[static_cast<std::size_t>(type - 1)] : "element";
  const std::string who = number ? "element " + std::to_string(*number) + " is" : "these are";
  const std::string what =
      who + (number ? " a " : " elements of type ") + name + " (type " + std::to_string(type) + ")";
  row.fail(what +
           (is_simplex(name)
                ? "; Cleave works on linear simplices: write the mesh with Mesh.ElementOrder "
                  "= 1 (`gmsh -order 1`)"
                : "; Cleave works on linear simplices: mesh without recombining, or split "
                  "the elements into triangles or tetrahedra, and use order 1"));
}

Mesh read_msh(const InputText& text) {
  const MshVersion version = read_version(text);
  const std::vector<MshSection> sections = msh_sections(text);
  MshContent content;
  content.mesh.source = text.source();
  content.mesh.msh_version = version;
  if (const auto* partitioned = find_section(text, sections, "PartitionedEntities", false))
    text.fail(
        partitioned->opened,
        "this mesh is partitioned; unpartition it in gmsh (Mesh > Unpartition) and save it again");
  if (const auto* names = find_section(text, sections, "PhysicalNames", false))
    read_physical_names(text, *names, content);
  const auto* nodes = find_section(text, sections, "Nodes", true);
  const auto* elements = find_section(text, sections, "Elements", true);
  const auto* entities = find_section(text, sections, "Entities", false);
  const bool is_41 = version == MshVersion::k41;
  const auto read_nodes = [&](MshContent& into) {
    is_41 ? read_msh41_nodes(text, *nodes, into) : read_msh22_nodes(text, *nodes, into);
  };
  const auto read_elements = [&](MshContent& into) {
    is_41 ? read_msh41_elements(text, *elements, entities, into)
          : read_msh22_elements(text, *elements, into);
  };

  // A number that comes twice is noticed at the end; reading again finds its line.
  read_nodes(content);
  if (const auto number = content.nodes.index(content.mesh.vertex_numbers)) {
    MshContent again;
    again.watched_node.number = number;
    read_nodes(again);
  }
  read_elements(content);
  if (const auto number = repeated_number(content.mesh.elements)) {
    content.watched_element.number = number;
    read_elements(content);
  }
  content.mesh.groups = content.groups.finish();
  return std::move(content.mesh);
}

}  // namespace cleave::app
