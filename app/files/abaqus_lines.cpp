#include "files/abaqus_lines.hpp"

#include <cctype>

namespace cleave::app {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == text.npos) return text.substr(text.size());
  return text.substr(first, text.find_last_not_of(" \t") + 1 - first);
}

/// Where the first of `marks` outside of quotation marks is.
std::size_t find_unquoted(std::string_view text, char mark) {
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"') quoted = !quoted;
    if (!quoted && text[i] == mark) return i;
  }
  return text.npos;
}

/// Takes the part before the first comma off `rest`.
std::string_view take_part(std::string_view& rest) {
  const auto comma = find_unquoted(rest, ',');
  const std::string_view part = rest.substr(0, comma);
  rest.remove_prefix(comma == rest.npos ? rest.size() : comma + 1);
  return trimmed(part);
}

}  // namespace

std::string upper(std::string_view text) {
  std::string result(trimmed(text));
  for (char& c : result) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

AbaqusName abaqus_name(std::string_view text) {
  text = trimmed(text);
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') {
    const std::string name(text.substr(1, text.size() - 2));
    return {name, name};
  }
  return {std::string(text), upper(text)};
}

std::string_view CommaFields::word() {
  const auto comma = find_unquoted(rest_, ',');
  goes_on_ = comma != rest_.npos && trimmed(rest_.substr(comma + 1)).empty();
  const std::string_view field = trimmed(rest_.substr(0, comma));
  rest_.remove_prefix(comma == rest_.npos || goes_on_ ? rest_.size() : comma + 1);
  return field;
}

double CommaFields::number_or_zero(const char* what) {
  CommaFields ahead = *this;
  if (at_end() || ahead.word().empty()) {
    *this = ahead;
    return 0;
  }
  return number<double>(what);
}

const std::string* AbaqusKeyword::find(std::string_view key) const {
  for (const auto& parameter : parameters)
    if (parameter.first == key) return &parameter.second;
  return nullptr;
}

const std::string& AbaqusKeyword::value(std::string_view key) const {
  const std::string* found = find(key);
  if (found == nullptr || found->empty())
    row.fail("*" + name + " needs the parameter " + std::string(key) + "=..");
  return *found;
}

bool AbaqusLines::more() {
  while (!ahead_ && rows_.more()) {
    const Row row = rows_.next("a line");
    if (row.rest().substr(0, 2) != "**") ahead_ = row;
  }
  return ahead_.has_value();
}

Row AbaqusLines::next() {
  const Row row = *ahead_;
  ahead_.reset();
  return row;
}

AbaqusKeyword AbaqusLines::keyword() {
  more();
  const Row row = next();
  std::string_view rest = row.rest();
  if (rest.front() != '*')
    row.fail("expected a keyword, *NODE or the like, found '" + printable(rest, 40) + "'");
  rest.remove_prefix(1);
  AbaqusKeyword keyword{row, upper(take_part(rest)), {}};
  bool goes_on = row.rest().back() == ',';
  for (;;) {
    while (!trimmed(rest).empty()) {
      const std::string_view part = take_part(rest);
      const auto equals = find_unquoted(part, '=');
      keyword.parameters.emplace_back(
          upper(part.substr(0, equals)),
          equals == part.npos ? std::string() : std::string(trimmed(part.substr(equals + 1))));
    }
    if (!goes_on || !more()) return keyword;
    const Row continued = next();
    if (std::string_view("*+-.0123456789").find(continued.rest().front()) != std::string_view::npos)
      continued.fail("the line before ends with a comma, so *" + printable(keyword.name, 40) +
                     " must go on here");
    rest = continued.rest();
    goes_on = rest.back() == ',';
  }
}

CommaFields AbaqusLines::data(const char* what) {
  if (!more()) text_.fail(text_.end() - 1, "expected " + std::string(what) + ", but the file ends");
  const Row row = next();
  if (row.rest().front() == '*')
    row.fail("expected " + std::string(what) + ", found the keyword '" + printable(row.rest(), 40) +
             "'");
  return {text_, row};
}

}  // namespace cleave::app
