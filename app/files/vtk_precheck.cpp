#include "files/vtk_precheck.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "files/input_text.hpp"
#include "files/row.hpp"

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
    text.fail(digits, std::string(keyword.substr(1)) + std::string(digits, rest) +
                          " is not possible in a file of " + std::to_string(bytes.size()) +
                          " bytes; the count is wrong or the file truncated");
  }
}

/// The first `count` bytes that the base64 digits from `at` on stand for; fewer if they end before.
std::vector<unsigned char> decode_base64(const char* at, const char* end, std::size_t count) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<unsigned char> bytes;
  std::uint32_t bits = 0;
  int bit_count = 0;
  for (; bytes.size() < count && at != end; ++at) {
    const auto digit = kDigits.find(*at);
    if (digit == kDigits.npos) break;
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    bit_count += 6;
    if (bit_count < 8) continue;
    bit_count -= 8;
    bytes.push_back(static_cast<unsigned char>(bits >> bit_count & 0xff));
  }
  return bytes;
}

/// The value of an attribute in the text of an XML tag; empty if it has none.
std::string_view attribute(std::string_view tag, std::string_view name) {
  for (auto at = tag.find(name); at != tag.npos; at = tag.find(name, at + 1)) {
    const auto quote = at + name.size() + 1;
    if (at == 0 || tag[at - 1] > ' ' || quote >= tag.size() || tag[quote - 1] != '=') continue;
    return tag.substr(quote + 1, tag.find(tag[quote], quote + 1) - quote - 1);
  }
  return {};
}

/// The data arrays of a .vtu file. Each must say where its data is, which starts with its length;
/// compressed ones start with their number of blocks, the sizes of a block and of the last one, and
/// of each when compressed.
class DataArrays {
 public:
  explicit DataArrays(const InputText& text)
      : text_(text),
        bytes_(text.bytes()),
        compressed_(bytes_.find(" compressor=") != bytes_.npos),
        width_(bytes_.find("header_type=\"UInt64\"") != bytes_.npos ? 8 : 4),
        big_endian_(bytes_.find("byte_order=\"BigEndian\"") != bytes_.npos),
        appended_(bytes_.find("<AppendedData")) {}

  void check() const {
    const std::string_view xml = bytes_.substr(0, appended_);
    for (auto at = xml.find("<DataArray"); at != xml.npos; at = xml.find("<DataArray", at + 1)) {
      const auto close = xml.find('>', at);
      if (close == xml.npos) return;
      check_array(xml.substr(at, close - at), xml.find_first_not_of(" \t\r\n", close + 1));
    }
  }

 private:
  void check_array(std::string_view tag, std::size_t content) const {
    const std::string_view format = attribute(tag, "format");
    if (format != "ascii" && format != "binary" && format != "appended")
      text_.fail(tag.data(), "a data array must have the format ascii, binary or appended");
    if (format == "binary") check_data(content, true);
    if (format != "appended") return;
    const std::string_view offset = attribute(tag, "offset");
    std::size_t distance = 0;
    const auto error = std::from_chars(offset.data(), offset.data() + offset.size(), distance).ec;
    const auto start = appended_ == bytes_.npos ? appended_ : bytes_.find('_', appended_);
    if (error != std::errc{} || start == bytes_.npos || distance >= bytes_.size() - start)
      text_.fail(tag.data(), "a data array of format appended has no data at its offset");
    const auto base64 = bytes_.substr(appended_, start - appended_).find("base64");
    check_data(start + 1 + distance, base64 != bytes_.npos);
  }

  void check_data(std::size_t at, bool base64) const {
    if (compressed_) return check_blocks(at, base64);
    if (at == bytes_.npos || at + width_ > bytes_.size()) return;
    const std::vector<std::uint64_t> length = numbers(bytes_.data() + at, 1, base64);
    if (!length.empty() && length[0] > bytes_.size() - at)
      text_.fail(bytes_.data() + at, "a data array claims " + std::to_string(length[0]) +
                                         " bytes, more than follow; it is damaged");
  }

  void check_blocks(std::size_t at, bool base64) const {
    if (at == bytes_.npos || at + width_ > bytes_.size()) return;
    const char* place = bytes_.data() + at;
    const std::uint64_t size = bytes_.size();
    const std::vector<std::uint64_t> blocks = numbers(place, 1, base64);
    if (!blocks.empty() && blocks[0] > size)
      text_.fail(place, "a data array claims " + std::to_string(blocks[0]) +
                            " compressed blocks, more than the file has bytes; it is damaged");
    const std::size_t count = blocks.empty() ? 0 : static_cast<std::size_t>(blocks[0]);
    const std::vector<std::uint64_t> header = numbers(place, 3 + count, base64);
    for (std::size_t i = 1; i < header.size(); ++i) {
      const std::uint64_t greatest = i < 3 ? kGreatestCompression * size : size;
      if (header[i] > greatest)
        text_.fail(place, "a data array claims a block of " + std::to_string(header[i]) +
                              " bytes, which is not possible in a file of " + std::to_string(size) +
                              "; it is damaged");
    }
    // VTK divides by the size of a block, and subtracts one of no blocks if there is a last one.
    const bool good = count == 0
                          ? header.size() < 3 || header[2] == 0
                          : header.size() == 3 + count && header[1] > 0 && header[2] <= header[1];
    if (!good)
      text_.fail(place, "a data array claims blocks whose sizes do not go together; it is damaged");
  }

  /// Up to `count` numbers of a header; fewer if the file ends before.
  std::vector<std::uint64_t> numbers(const char* place, std::size_t count, bool base64) const {
    const auto rest = static_cast<std::size_t>(text_.end() - place);
    const std::size_t wanted = count * width_;
    const std::vector<unsigned char> raw =
        base64 ? decode_base64(place, text_.end(), wanted)
               : std::vector<unsigned char>(place, place + std::min(rest, wanted));
    std::vector<std::uint64_t> result;
    for (std::size_t at = 0; at + width_ <= raw.size(); at += width_) {
      std::uint64_t value = 0;
      for (std::size_t i = 0; i < width_; ++i)
        value = value << 8 | raw[at + (big_endian_ ? i : width_ - 1 - i)];
      result.push_back(value);
    }
    return result;
  }

  const InputText& text_;
  std::string_view bytes_;
  bool compressed_;
  std::size_t width_;
  bool big_endian_;
  std::size_t appended_;
};

/// The integers of a legacy CELLS section in either encoding.
class CellNumbers {
 public:
  CellNumbers(const InputText& text, const char* begin, bool binary)
      : text_(text), at_(begin), binary_(binary) {}

  std::int32_t next() {
    if (!binary_) {
      while (at_ != text_.end() && std::string_view(" \t\r\n").find(*at_) != std::string_view::npos)
        ++at_;
      std::int32_t value = 0;
      const auto [rest, error] = std::from_chars(at_, text_.end(), value);
      if (error != std::errc{})
        text_.fail(at_, "expected a number of the CELLS section; it is shorter than it says");
      at_ = rest;
      return value;
    }
    if (text_.end() - at_ < 4) text_.fail(at_, "the CELLS section is truncated");
    std::uint32_t value = 0;
    for (int i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(*at_++);
    return static_cast<std::int32_t>(value);
  }

 private:
  const InputText& text_;
  const char* at_;
  bool binary_;
};

/// Where the line that starts with `keyword` starts, or the end.
const char* find_line(const InputText& text, std::string_view keyword) {
  const auto at = text.bytes().find("\n" + std::string(keyword) + " ");
  return at == std::string_view::npos ? text.end() : text.begin() + at + 1;
}

/// Versions below 5 list for each cell its number of points, then these: lengths must add up.
void check_lengths(const InputText& text, const Row& section, std::size_t count, std::size_t size) {
  const char* data = section.rest().data();
  while (data != text.end() && *data++ != '\n') continue;
  const auto before = text.bytes().substr(0, static_cast<std::size_t>(data - text.begin()));
  CellNumbers numbers(text, data, before.find("\nBINARY") != before.npos);
  std::size_t used = 0;
  for (std::size_t c = 0; c < count; ++c) {
    const std::int32_t corners = numbers.next();
    if (corners < 0 || static_cast<std::size_t>(corners) >= size - used)
      section.fail("cell " + std::to_string(c) + " claims " + std::to_string(corners) +
                   " points, which does not fit the size of the CELLS section");
    used += 1 + static_cast<std::size_t>(corners);
    for (std::int32_t k = 0; k < corners; ++k) numbers.next();
  }
  if (used != size)
    section.fail("the cells fill " + std::to_string(used) + " numbers of the CELLS section, not " +
                 std::to_string(size));
}

/// VTK would read a section that comes twice into the room of the first one, and it knows keywords
/// in small letters, too. What stands before the data of points and cells must have each but once.
void check_stands_once(const InputText& text, std::string_view keyword) {
  const auto same = [](char a, char b) {
    return std::toupper(static_cast<unsigned char>(a)) == static_cast<unsigned char>(b);
  };
  const auto space = [](char c) {
    return std::string_view(" \t\r\n").find(c) != std::string_view::npos;
  };
  const char* const end = std::min(find_line(text, "CELL_DATA"), find_line(text, "POINT_DATA"));
  int count = 0;
  const char* at = std::min(find_line(text, "DATASET"), end);
  while ((at = std::search(at, end, keyword.begin(), keyword.end(), same)) != end) {
    const char* const after = at + keyword.size();
    if (space(at[-1]) && (after == end || space(*after)) && ++count > 1)
      text.fail(at, "a second section " + std::string(keyword) + "; there must be one");
    at = after;
  }
}

void check_legacy_cells(const InputText& text) {
  check_stands_once(text, "CELLS");
  check_stands_once(text, "CELL_TYPES");
  const char* const cells = find_line(text, "CELLS");
  const char* const types = find_line(text, "CELL_TYPES");
  if (types <= cells || types == text.end())
    text.fail(text.end() - 1, "the file has no line CELLS followed by a line CELL_TYPES");
  RowReader rows(text, cells, text.end());
  Row row = rows.next("CELLS");
  row.word();
  std::size_t count = rows.count(row, "the number of cells");
  const std::size_t size = rows.count(row, "the size of the CELLS section");
  const bool has_offsets = text.bytes().substr(0, 26).find("Version 5") != std::string_view::npos;
  if (!has_offsets)
    check_lengths(text, row, count, size);
  else if (count > 0)
    --count;  // version 5 counts the offsets, one more than the cells
  RowReader type_rows(text, types, text.end());
  Row type_row = type_rows.next("CELL_TYPES");
  type_row.word();
  const std::size_t type_count = type_rows.count(type_row, "the number of cell types");
  if (type_count != count)
    type_row.fail("CELL_TYPES has " + std::to_string(type_count) + " entries for " +
                  std::to_string(count) + " cells");
}

}  // namespace

void precheck_vtk(const std::filesystem::path& path, VtkFormat format) {
  require_readable_file(path);
  const InputText text(path);
  const std::uint64_t size = text.bytes().size();
  if (format == VtkFormat::kXml) {
    const auto first = text.bytes().find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos || text.bytes()[first] != '<')
      text.fail_format("a .vtu file, which starts with <?xml or <VTKFile");
    for (const char* keyword : {" NumberOfPoints=\"", " NumberOfCells=\"", " NumberOfTuples=\""})
      check_counts(text, keyword, kGreatestCompression * size);
    DataArrays(text).check();
    return;
  }
  if (text.bytes().substr(0, 14) != "# vtk DataFile")
    text.fail_format("a legacy VTK file, which starts with # vtk DataFile");
  if (text.bytes().find("\nDATASET UNSTRUCTURED_GRID") == std::string_view::npos)
    text.fail(text.begin(),
              "the file has no line DATASET UNSTRUCTURED_GRID, the only kind of data that is read");
  for (const char* keyword : {"\nPOINTS ", "\nCELLS ", "\nCELL_TYPES ", "\nPOINT_DATA ",
                              "\nCELL_DATA ", "\nFIELD FieldData "})
    check_counts(text, keyword, size);
  check_legacy_cells(text);
}

}  // namespace cleave::app
