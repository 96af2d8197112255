#include "files/vtk_counts.hpp"

#include <array>
#include <charconv>
#include <cstdint>
#include <string_view>

#include "files/input_text.hpp"

namespace cleave::app {
namespace {

/// The best that the compressors of .vtu files can do, in bytes per byte, with a wide margin.
constexpr std::uint64_t kGreatestCompression = 10000;

/// Requires each number that follows `keyword` to be at most `greatest`.
void check_counts(const InputText& text, std::string_view keyword, std::uint64_t greatest) {
  const std::string_view bytes = text.bytes();
  for (auto at = bytes.find(keyword); at != bytes.npos; at = bytes.find(keyword, at + 1)) {
    const char* digits = bytes.data() + at + keyword.size();
    std::int64_t count = 0;
    const auto [rest, error] = std::from_chars(digits, text.end(), count);
    if (rest == digits) continue;
    if (error == std::errc{} && count >= 0 && static_cast<std::uint64_t>(count) <= greatest)
      continue;
    std::string_view shown = keyword;
    shown.remove_prefix(keyword.front() == '\n' ? 1 : 0);
    text.fail(digits, std::string(shown) + std::string(digits, rest) +
                          " is not possible in a file of " + std::to_string(bytes.size()) +
                          " bytes; the count is wrong or the file truncated");
  }
}

}  // namespace

void check_vtk_counts(const std::filesystem::path& path, VtkFormat format) {
  require_readable_file(path);
  const InputText text(path);
  const std::uint64_t size = text.bytes().size();
  if (format == VtkFormat::kXml) {
    if (describe_content(text.bytes()) != "an XML file (.vtu?)")
      text.fail_format("a .vtu file, which starts with <?xml or <VTKFile");
    for (const char* keyword : {" NumberOfPoints=\"", " NumberOfCells=\"", " NumberOfTuples=\""})
      check_counts(text, keyword, kGreatestCompression * size);
  } else {
    if (text.bytes().substr(0, 14) != "# vtk DataFile")
      text.fail_format("a legacy VTK file, which starts with # vtk DataFile");
    for (const char* keyword : {"\nPOINTS ", "\nCELLS ", "\nCELL_TYPES ", "\nPOINT_DATA ",
                                "\nCELL_DATA ", "\nFIELD FieldData "})
      check_counts(text, keyword, size);
  }
}

}  // namespace cleave::app
