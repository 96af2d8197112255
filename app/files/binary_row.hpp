#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string>

#include "files/input_text.hpp"
#include "files/row.hpp"

namespace cleave::app {

class BinaryRows;

/// The numbers of a binary file, with the interface of Row; the type of each is part of the format.
/// Rows must be read in order: all share one place in the data.
class BinaryRow {
 public:
  BinaryRow(BinaryRows& rows, const char* begin) : rows_(&rows), begin_(begin) {}

  const char* begin() const { return begin_; }
  template <class Number>
  Number number(const char* what);
  void finish(const char* /*what*/) const {}
  [[noreturn]] inline void fail(const std::string& message) const;

 private:
  BinaryRows* rows_;
  const char* begin_;
};

/// Walks over binary data from `begin` on, with the interface of RowReader.
class BinaryRows {
 public:
  /// `swapped`: the bytes of each number come in the order that is not the machine's.
  BinaryRows(const InputText& text, const char* begin, const char* end, bool swapped)
      : text_(&text), at_(begin), end_(end), told_(begin), swapped_(swapped) {}

  /// What follows the rows that the counts speak of is not the reader's business.
  bool more() const { return false; }
  BinaryRow next(const char* /*what*/) {
    if (at_ >= told_) told_ = text_->passed(at_);
    return {*this, at_};
  }
  std::size_t count(BinaryRow& row, const char* what, std::size_t least = 1) {
    const auto count = row.number<std::uint64_t>(what);
    check_count(*text_, row.begin(), end_, count, least, what);
    return static_cast<std::size_t>(count);
  }

  template <class Number>
  Number number(const char* what) {
    if (static_cast<std::size_t>(end_ - at_) < sizeof(Number))
      text_->fail(at_, "expected " + std::string(what) +
                           ", but the data ends; the count is wrong or the file truncated");
    std::array<char, sizeof(Number)> bytes;
    std::memcpy(bytes.data(), at_, sizeof(Number));
    if (swapped_) std::reverse(bytes.begin(), bytes.end());
    at_ += sizeof(Number);
    Number value;
    std::memcpy(&value, bytes.data(), sizeof(Number));
    return value;
  }

  /// A line of text among the data.
  Row line(const char* what) {
    RowReader rows(*text_, at_, end_);
    const Row row = rows.next(what);
    at_ = rows.position();
    return row;
  }

  const char* position() const { return at_; }
  const char* end() const { return end_; }
  std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - at_); }
  const InputText& text() const { return *text_; }

 private:
  const InputText* text_;
  const char* at_;
  const char* end_;
  const char* told_;  // `text` is told when this is passed
  bool swapped_;
};

template <class Number>
Number BinaryRow::number(const char* what) {
  return rows_->number<Number>(what);
}

void BinaryRow::fail(const std::string& message) const { rows_->text().fail(begin_, message); }

}  // namespace cleave::app
