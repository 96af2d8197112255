#include <algorithm>
#include <functional>
#include <map>
#include <string>

#include "files/msh_format.hpp"
#include "files/msh_sections.hpp"

namespace cleave::app {
namespace {

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
    if (tag < 1) row.fail("the number of a group must be positive; 0 means none");
    const std::string_view name = row.rest();
    if (name.size() < 3 || name.front() != '"' || name.find('"', 1) != name.size() - 1)
      row.fail("expected the name of a group in quotation marks at the end of the line");
    content.groups.name(dimension, tag, std::string(name.substr(1, name.size() - 2)));
  }
  if (rows.more()) rows.next("a name").fail("more names than the count says");
}

/// Whether the numbers ascend in each dimension, and those of two dimensions do not mingle, which
/// is what most files hold; so nothing needs to be copied and sorted.
bool ascend_apart(const MshContent& content) {
  if (!content.repeated.empty()) return false;
  std::vector<std::pair<std::uint64_t, std::uint64_t>> ranges;
  const auto ascends = [&](const std::vector<std::uint64_t>& numbers) {
    if (!numbers.empty()) ranges.emplace_back(numbers.front(), numbers.back());
    return std::adjacent_find(numbers.begin(), numbers.end(), std::greater_equal<>()) ==
           numbers.end();
  };
  for (const Elements& of_dimension : content.mesh.elements)
    if (!ascends(of_dimension.numbers)) return false;
  for (const MshCohesive& list : content.cohesive)
    if (!ascends(list.numbers)) return false;
  std::sort(ranges.begin(), ranges.end());
  for (std::size_t i = 1; i < ranges.size(); ++i)
    if (ranges[i].first <= ranges[i - 1].second) return false;
  return true;
}

/// A number that two elements of any dimension share, if there is one.
std::optional<std::uint64_t> repeated_number(const MshContent& content) {
  if (ascend_apart(content)) return std::nullopt;
  std::vector<std::uint64_t> all;
  for (const Elements& of_dimension : content.mesh.elements)
    all.insert(all.end(), of_dimension.numbers.begin(), of_dimension.numbers.end());
  for (const MshCohesive& list : content.cohesive)
    all.insert(all.end(), list.numbers.begin(), list.numbers.end());
  for (const MshRepeated& repeated : content.repeated) all.push_back(repeated.number);
  if (!std::is_sorted(all.begin(), all.end())) std::sort(all.begin(), all.end());
  const auto twice = std::adjacent_find(all.begin(), all.end());
  return twice != all.end() ? std::optional(*twice) : std::nullopt;
}

/// When a section is read, if the order in the file is free: names, nodes, entities, elements, then
/// what speaks of them.
int rank(const std::string& name) {
  constexpr std::array kFirst = {"PhysicalNames", "Nodes", "Entities", "Elements"};
  return static_cast<int>(std::find(kFirst.begin(), kFirst.end(), name) - kFirst.begin());
}

class MshReader {
 public:
  explicit MshReader(const InputText& text)
      : text_(text), head_(read_msh_head(text)), content_(text) {
    content_.mesh.source = text.source();
    content_.mesh.msh_version = head_.version;
    content_.mesh.msh_binary = head_.binary;
  }

  Mesh read() {
    head_.binary ? read_in_order() : read_by_rank();
    require("Nodes");
    require("Elements");
    content_.mesh.groups = content_.groups.finish();
    content_.finish_cohesive();
    return std::move(content_.mesh);
  }

 private:
  /// Text: sections end where a line says so, and may come in any order.
  void read_by_rank() {
    std::vector<MshSection> sections;
    RowReader lines(text_, head_.end, text_.end());
    while (lines.more()) {
      sections.push_back(msh_section(text_, lines.next("a section")));
      const MshSection& last = sections.back();
      lines = RowReader(text_, msh_closed(text_, last.end, last.name), text_.end());
    }
    std::stable_sort(sections.begin(), sections.end(),
                     [](const auto& a, const auto& b) { return rank(a.name) < rank(b.name); });
    for (const MshSection& section : sections) read_section<RowReader>(section);
  }

  /// Binary: only reading a section tells where it ends, unless it is text or is not read.
  void read_in_order() {
    RowReader lines(text_, head_.end, text_.end());
    while (lines.more()) {
      MshSection section = msh_section(text_, lines.next("a section"));
      const bool text_inside = !is_binary(section.name) || (is_22() && section.name == "Periodic");
      const char* end = section.end;
      if (text_inside) {
        read_section<RowReader>(section);
      } else {
        section.end = text_.end();
        end = read_section<BinaryRows>(section);
      }
      lines = RowReader(text_, msh_closed(text_, end, section.name), text_.end());
    }
  }

  static bool is_binary(const std::string& name) {
    constexpr std::array kBinary = {"Nodes",    "Entities", "Elements",
                                    "Periodic", "NodeData", "ElementData"};
    return std::find(kBinary.begin(), kBinary.end(), name) != kBinary.end();
  }

  bool is_22() const { return head_.version == MshVersion::k22; }

  template <class Rows>
  Rows rows_of(const MshSection& section) const {
    if constexpr (std::is_same_v<Rows, BinaryRows>)
      return Rows(text_, section.begin, section.end, head_.swapped);
    else
      return Rows(text_, section.begin, section.end);
  }

  /// Reads a section and returns where its content ends.
  template <class Rows>
  const char* read_section(const MshSection& section) {
    refuse_partitions(section);
    const bool is_data = section.name == "NodeData" || section.name == "ElementData";
    const bool is_known = is_data || rank(section.name) < 4 || section.name == "Periodic";
    if (!is_known) {
      if (section.name != "Comments")
        content_.drop(section.opened, "the section $" + printable(section.name, 40) +
                                          " says nothing that Cleave keeps; it is dropped");
      return section.end;
    }
    if (!is_data && !seen_.emplace(section.name, section).second)
      text_.fail(section.opened, "a second section $" + section.name);
    Rows rows = rows_of<Rows>(section);
    if (section.name == "PhysicalNames") {
      read_physical_names(text_, section, content_);
      return section.end;
    }
    if (section.name == "Nodes") {
      read_nodes<Rows>(rows);
    } else if (section.name == "Entities") {
      if (seen_.count("Elements") > 0)
        text_.fail(section.opened, "$Entities must come before $Elements in a binary file");
      if (!is_22()) entities_ = read_msh41_entities(rows);
    } else if (section.name == "Elements") {
      require("Nodes");
      read_elements<Rows>(rows);
    } else if (section.name == "Periodic") {
      require("Nodes");
      read_periodic(rows);
    } else {
      require(section.name == "NodeData" ? "Nodes" : "Elements");
      read_msh_data(rows, section, content_);
    }
    return rows.position();
  }

  /// A number that comes twice is noticed at the end; reading again finds its place.
  template <class Rows>
  void read_nodes(Rows& rows) {
    const Rows first = rows;
    const auto into = [&](Rows& from, MshContent& content) {
      is_22() ? read_msh22_nodes(from, content) : read_msh41_nodes(from, content);
    };
    into(rows, content_);
    if (const auto number = content_.nodes.index(content_.mesh.vertex_numbers)) {
      MshContent again(text_);
      again.watched_node.number = number;
      Rows second = first;
      into(second, again);
    }
  }

  template <class Rows>
  void read_elements(Rows& rows) {
    const Rows first = rows;
    const auto into = [&](Rows& from) {
      is_22() ? read_msh22_elements(from, content_)
              : read_msh41_elements(from, entities_, content_);
    };
    into(rows);
    if (const auto number = repeated_number(content_)) {
      content_.watched_element.number = number;
      Rows second = first;
      into(second);
    }
  }

  template <class Rows>
  void read_periodic(Rows& rows) {
    if (!is_22()) return read_msh41_periodic(rows, content_);
    if constexpr (std::is_same_v<Rows, RowReader>) read_msh22_periodic(rows, content_);
  }

  void refuse_partitions(const MshSection& section) const {
    if (section.name == "PartitionedEntities" || section.name == "GhostElements")
      text_.fail(section.opened,
                 "this mesh is partitioned; unpartition it in gmsh (Mesh > Unpartition) and save "
                 "it again");
  }

  void require(const char* name) const {
    if (seen_.count(name) == 0)
      text_.fail(text_.end() - 1, "the file has no section $" + std::string(name) +
                                      (head_.binary ? " before those that need it" : "") +
                                      "; it may be truncated, or hold no mesh");
  }

  const InputText& text_;
  const MshHead head_;
  MshContent content_;
  MshEntities entities_;
  std::map<std::string, MshSection> seen_;
};

}  // namespace

Mesh read_msh(const InputText& text) { return MshReader(text).read(); }

}  // namespace cleave::app
