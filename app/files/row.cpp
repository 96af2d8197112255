#include "files/row.hpp"

#include "cleave/topology/ids.hpp"

namespace cleave::app {
namespace {

constexpr std::size_t kShown = 40;  // bytes of a field that a message quotes

}  // namespace

void Row::finish(const char* what) const {
  if (!at_end())
    fail("the line of " + std::string(what) + " goes on with '" + printable(peek(), kShown) +
         "'; nothing may follow");
}

void Row::fail_field(const char* what, bool integer, bool with_sign, int bits) const {
  const std::string wanted = "expected " + std::string(what);
  const std::string_view field = peek();
  if (field.empty()) fail(wanted + ", but the line ends");
  std::string kind = "a number in the range of doubles";
  if (integer)
    kind = std::string(with_sign ? "an integer" : "a non-negative integer") + " of at most " +
           std::to_string(bits) + " bits";
  fail(wanted + " (" + kind + "), found '" + printable(field, kShown) + "'");
}

void check_count(const InputText& text, const char* place, const char* end, std::uint64_t count,
                 std::size_t least, const char* what) {
  const std::string claim = std::string(what) + " is " + std::to_string(count);
  if (count >= topology::kNoIndex)
    text.fail(place, claim + ": more than " + std::to_string(topology::kIdBits) +
                         "-bit ids can number (" + std::to_string(topology::kNoIndex) +
                         "); split the mesh");
  const auto bytes_left = static_cast<std::uint64_t>(end - place);
  if (count > bytes_left / least)
    text.fail(place, claim + ", but only " + std::to_string(bytes_left) +
                         " bytes follow; the count is wrong or the file truncated");
}

std::size_t RowReader::count(Row& row, const char* what, std::size_t least) const {
  const auto count = row.number<std::int64_t>(what);
  if (count < 0) row.fail(std::string(what) + " is negative: " + std::to_string(count));
  check_count(*text_, row.begin(), end_, static_cast<std::uint64_t>(count), least, what);
  return static_cast<std::size_t>(count);
}

void RowReader::find() {
  found_ = true;
  row_begin_ = nullptr;
  if (at_ >= told_) told_ = text_->passed(at_);
  while (at_ != end_) {
    const auto size = static_cast<std::size_t>(end_ - at_);
    const auto* newline = static_cast<const char*>(std::memchr(at_, '\n', size));
    const char* line_begin = at_;
    const char* line_end = newline != nullptr ? newline : end_;
    at_ = newline != nullptr ? newline + 1 : end_;
    if (comment_ != '\n') {
      const auto length = static_cast<std::size_t>(line_end - line_begin);
      const auto* comment = static_cast<const char*>(std::memchr(line_begin, comment_, length));
      if (comment != nullptr) line_end = comment;
    }
    while (line_begin != line_end &&
           (line_end[-1] == '\r' || line_end[-1] == ' ' || line_end[-1] == '\t'))
      --line_end;
    const char* text = line_begin;
    while (text != line_end && (*text == ' ' || *text == '\t')) ++text;
    if (text == line_end) continue;
    row_begin_ = text;
    row_end_ = line_end;
    return;
  }
}

void RowReader::fail_at_end(const char* what) const {
  // The last line that is there, so that the message points into the file.
  const char* place = end_ != text_->begin() ? end_ - 1 : end_;
  text_->fail(place, "expected " + std::string(what) +
                         ", but there is nothing more; the count is wrong or the file truncated");
}

}  // namespace cleave::app
