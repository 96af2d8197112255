#include "files/msh_sections.hpp"

#include <cstring>

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

}  // namespace

MshHead read_msh_head(const InputText& text) {
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
  if (type != 0 && type != 1) row.fail("the file type must be 0 (text) or 1 (binary)");
  const int size = row.number<int>("the size of a real number");
  if (type == 1 && size != 8)
    row.fail("the size of a real number is " + std::to_string(size) +
             "; binary files are read with 8" + kHowToConvert);
  row.finish("the version");
  MshHead head{MshVersion::k41, type == 1, false, rows.position()};
  if (head.binary) {
    BinaryRows bytes(text, head.end, text.end(), false);
    const auto one = bytes.number<std::uint32_t>("the number 1, which tells the order of bytes");
    constexpr std::uint32_t kSwapped = 0x01000000;
    if (one != 1 && one != kSwapped)
      row.fail("the binary number 1, which tells the order of the bytes, does not follow");
    head.swapped = one == kSwapped;
    rows = RowReader(text, bytes.position(), text.end());
  }
  Row closing = rows.next("$EndMeshFormat");
  if (closing.rest() != "$EndMeshFormat") closing.fail("expected $EndMeshFormat");
  head.end = rows.position();
  if (version == "4.1") return head;
  head.version = MshVersion::k22;
  for (const char* old : {"2.2", "2.1", "2.0", "2"})
    if (version == old) return head;
  row.fail("this is version " + printable(version, 10) +
           " of gmsh's format; versions 2.2 and 4.1 are read" + kHowToConvert);
}

MshSection msh_section(const InputText& text, const Row& line) {
  const std::string_view opened = line.rest();
  if (opened.front() != '$' || opened.substr(0, 4) == "$End")
    line.fail("expected the name of a section, $Nodes or the like, found '" +
              printable(opened, 40) + "'");
  const std::string name(opened.substr(1));
  const char* begin = line_end(opened.data(), text.end());
  const char* end = next_dollar_line(text, begin);
  while (end != text.end() && line_at(end, text.end()) != "$End" + name)
    end = next_dollar_line(text, end + 1);
  if (end == text.end())
    line.fail("the section $" + printable(name, 40) + " is not closed by $End" +
              printable(name, 40) + "; the file may be truncated");
  return {name, opened.data(), begin + 1, end};
}

const char* msh_closed(const InputText& text, const char* section_end, std::string_view name) {
  RowReader rows(text, section_end, text.end());
  const std::string closing = "$End" + std::string(name);
  const Row row = rows.next(closing.c_str());
  if (row.rest() != closing)
    row.fail("expected " + closing + "; the counts of the section are wrong");
  return rows.position();
}

}  // namespace cleave::app
