#pragma once
#include <charconv>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>

#include "files/input_text.hpp"

namespace cleave::app {

/// One line of a text, read field by field; fields are separated by blanks and tabs. Numbers are
/// read by std::from_chars, so that no locale matters; one leading '+' is allowed. Everything that
/// does not fit throws InputError with the line.
class Row {
 public:
  Row(const InputText& text, const char* begin, const char* end)
      : text_(&text), begin_(begin), at_(begin), end_(end) {
    skip_blanks();
  }

  const char* begin() const { return begin_; }
  bool at_end() const { return at_ == end_; }
  std::string_view rest() const { return {at_, static_cast<std::size_t>(end_ - at_)}; }

  /// The next field, whatever it is; empty at the end.
  std::string_view word() {
    const std::string_view field = peek();
    at_ += field.size();
    skip_blanks();
    return field;
  }

  /// The next field as a number; `what` names it in the message, with its article.
  template <class Number>
  Number number(const char* what) {
    const char* from = at_;
    if (end_ - from > 1 && *from == '+' && from[1] != '-' && from[1] != '+') ++from;
    Number value{};
    const auto [rest, error] = std::from_chars(from, end_, value);
    if (error != std::errc{} || (rest != end_ && !is_blank(*rest))) fail_number<Number>(what);
    at_ = rest;
    skip_blanks();
    return value;
  }

  /// Requires the line to end here; `what` names what it holds.
  void finish(const char* what) const;

  [[noreturn]] void fail(const std::string& message) const { text_->fail(begin_, message); }

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t'; }
  void skip_blanks() {
    while (at_ != end_ && is_blank(*at_)) ++at_;
  }
  std::string_view peek() const {
    const char* stop = at_;
    while (stop != end_ && !is_blank(*stop)) ++stop;
    return {at_, static_cast<std::size_t>(stop - at_)};
  }

  template <class Number>
  [[noreturn]] void fail_number(const char* what) const {
    fail_field(what, std::numeric_limits<Number>::is_integer,
               std::numeric_limits<Number>::is_signed, static_cast<int>(8 * sizeof(Number)));
  }
  [[noreturn]] void fail_field(const char* what, bool integer, bool with_sign, int bits) const;

  const InputText* text_;
  const char* begin_;
  const char* at_;
  const char* end_;
};

/// Requires that `count` rows of at least `least` bytes can follow `place`, the count's, up to
/// `end` and that ids can number them. Throws InputError otherwise.
void check_count(const InputText& text, const char* place, const char* end, std::uint64_t count,
                 std::size_t least, const char* what);

/// Walks over the lines of a text from `begin` to `end`, leaving out blank ones and, if a comment
/// character is given, what follows it on a line. Windows line ends are accepted.
class RowReader {
 public:
  RowReader(const InputText& text, const char* begin, const char* end, char comment = '\n')
      : text_(&text), at_(begin), end_(end), told_(begin), comment_(comment) {}

  /// True if there is another row.
  bool more() {
    if (!found_) find();
    return row_begin_ != nullptr;
  }

  /// The next row; `what` names, with its article, what it should be, for the message when there is
  /// none.
  Row next(const char* what) {
    if (!more()) fail_at_end(what);
    found_ = false;
    return {*text_, row_begin_, row_end_};
  }

  /// Reads a count of rows to come, of `least` bytes each, and makes sure that the text can hold so
  /// many and that ids can number them, so that a count that lies cannot take memory.
  std::size_t count(Row& row, const char* what, std::size_t least = 1) const;

  /// The place after the row that next() returned last.
  const char* position() const { return at_; }
  std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - at_); }
  const InputText& text() const { return *text_; }

 private:
  void find();
  [[noreturn]] void fail_at_end(const char* what) const;

  const InputText* text_;
  const char* at_;
  const char* end_;
  const char* told_;  // `text` is told when this is passed
  char comment_;
  bool found_ = false;  // row_begin_, row_end_ hold the row that next() will return
  const char* row_begin_ = nullptr;
  const char* row_end_ = nullptr;
};

}  // namespace cleave::app
