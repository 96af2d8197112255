#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "files/row.hpp"

namespace cleave::app {

/// Upper case, which Abaqus does not tell from lower case, and no blanks at the ends.
std::string upper(std::string_view text);

/// A name of a set or surface. Names that are not quoted are the same in upper and lower case.
struct AbaqusName {
  std::string shown, key;
};

/// "name" or name.
AbaqusName abaqus_name(std::string_view text);

/// The fields of a data line, which commas separate.
class CommaFields {
 public:
  CommaFields(const InputText& text, const Row& row) : text_(&text), row_(row), rest_(row.rest()) {}

  /// Whether nothing follows; a comma at the end of the line adds no field.
  bool at_end() const { return rest_.empty(); }

  /// Whether the line ended with a comma, as one that goes on below does.
  bool goes_on() const { return goes_on_; }

  /// The next field, without blanks at its ends.
  std::string_view word();

  /// The next field as a number.
  template <class Number>
  Number number(const char* what) {
    const std::string_view field = word();
    Row one(*text_, field.data(), field.data() + field.size());
    const auto value = one.template number<Number>(what);
    one.finish(what);
    return value;
  }

  /// The next field as a number, or 0 where it is blank or missing.
  double number_or_zero(const char* what);

  const Row& row() const { return row_; }

 private:
  const InputText* text_;
  Row row_;
  std::string_view rest_;
  bool goes_on_ = false;
};

/// A line *KEYWORD, PARAMETER, PARAMETER=VALUE, ..
struct AbaqusKeyword {
  Row row;                                                      // where it stands
  std::string name;                                             // upper case, without the star
  std::vector<std::pair<std::string, std::string>> parameters;  // key in upper case, value

  bool has(std::string_view key) const { return find(key) != nullptr; }
  /// The value of a parameter; null if the line has no such parameter.
  const std::string* find(std::string_view key) const;
  /// The value of a parameter that must be there and have one.
  const std::string& value(std::string_view key) const;
};

/// Walks over a file: keyword lines and the data lines that follow each. Comments (**) are left
/// out.
class AbaqusLines {
 public:
  explicit AbaqusLines(const InputText& text)
      : text_(text), rows_(text, text.begin(), text.end()) {}

  /// Whether a line follows.
  bool more();

  /// The next line, which must be a keyword; joined with those it continues on.
  AbaqusKeyword keyword();

  /// Whether the next line is a data line.
  bool more_data() { return more() && ahead_->rest().front() != '*'; }

  /// The next data line; `what` names it, with its article, for the message when there is none.
  CommaFields data(const char* what);

 private:
  Row next();

  const InputText& text_;
  RowReader rows_;
  std::optional<Row> ahead_;
};

}  // namespace cleave::app
