#include "json_value.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "error.hpp"

namespace cleave::app {
namespace {

std::string listed(std::initializer_list<std::string_view> words) {
  std::string out;
  for (const auto word : words) out.append(out.empty() ? "" : ", ").append(word);
  return out;
}

// A key inside a JSON pointer (RFC 6901).
std::string escaped(std::string_view key) {
  std::string out;
  for (const char c : key) out += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return out;
}

// nlohmann's text without its own prefix "[json.exception.parse_error.101] ".
std::string reason(const nlohmann::json::exception& e) {
  const std::string text = e.what();
  const auto end = text.find("] ");
  return end == std::string::npos ? text : text.substr(end + 2);
}

}  // namespace

nlohmann::json parse_json(std::string_view text, const std::string& source) {
  std::vector<std::set<std::string>> keys;
  const auto refuse_repeated_keys = [&](int, nlohmann::json::parse_event_t event,
                                        nlohmann::json& parsed) {
    using Event = nlohmann::json::parse_event_t;
    if (event == Event::object_start) keys.emplace_back();
    if (event == Event::object_end) keys.pop_back();
    if (event == Event::key && !keys.back().insert(parsed.get<std::string>()).second)
      throw InputError(source + ": the key \"" + parsed.get<std::string>() +
                       "\" stands twice in one object; keep one of them");
    return true;
  };
  try {
    return nlohmann::json::parse(text.begin(), text.end(), refuse_repeated_keys);
  } catch (const nlohmann::json::exception& e) {
    throw InputError(source + ": not JSON: " + reason(e));
  }
}

JsonValue::JsonValue(const nlohmann::json& value, std::string source, std::string pointer)
    : value_(&value), source_(std::move(source)), pointer_(std::move(pointer)) {}

void JsonValue::fail(const std::string& what) const {
  throw InputError(source_ + ": at " + (pointer_.empty() ? "the top" : pointer_) + ": " + what);
}

bool JsonValue::is_object() const { return value_->is_object(); }
bool JsonValue::is_array() const { return value_->is_array(); }
bool JsonValue::is_string() const { return value_->is_string(); }
bool JsonValue::is_boolean() const { return value_->is_boolean(); }

bool JsonValue::has(std::string_view key) const {
  if (!is_object()) fail(std::string("an object {..} is needed, this is ") + value_->type_name());
  return value_->find(key) != value_->end();
}

JsonValue JsonValue::operator[](std::string_view key) const {
  if (!has(key)) fail("the key \"" + std::string(key) + "\" is missing");
  return {*value_->find(key), source_, pointer_ + "/" + escaped(key)};
}

void JsonValue::only(std::initializer_list<std::string_view> known) const {
  for (const auto& [key, value] : members())
    if (std::find(known.begin(), known.end(), key) == known.end())
      value.fail("unknown key \"" + key + "\"; known here: " + listed(known));
}

std::string_view JsonValue::one_of(std::initializer_list<std::string_view> keys) const {
  std::string_view found;
  for (const auto key : keys) {
    if (!has(key)) continue;
    if (!found.empty())
      fail("\"" + std::string(found) + "\" and \"" + std::string(key) + "\" exclude each other");
    found = key;
  }
  if (found.empty()) fail("one of these keys is needed: " + listed(keys));
  return found;
}

std::vector<JsonValue> JsonValue::items() const {
  if (!is_array()) fail(std::string("a list [..] is needed, this is ") + value_->type_name());
  std::vector<JsonValue> items;
  for (std::size_t i = 0; i < value_->size(); ++i)
    items.emplace_back((*value_)[i], source_, pointer_ + "/" + std::to_string(i));
  return items;
}

std::vector<std::pair<std::string, JsonValue>> JsonValue::members() const {
  std::vector<std::pair<std::string, JsonValue>> members;
  if (has("comment") && !(*this)["comment"].is_string() && !(*this)["comment"].is_array())
    (*this)["comment"].fail("a comment is a text or a list of texts");
  for (const auto& item : value_->items())
    if (item.key() != "comment") members.emplace_back(item.key(), (*this)[item.key()]);
  return members;
}

double JsonValue::number() const {
  if (!value_->is_number()) fail(std::string("a number is needed, this is ") + value_->type_name());
  return value_->get<double>();
}

std::uint64_t JsonValue::count() const {
  if (!value_->is_number_unsigned()) fail("a whole number from 0 on is needed");
  return value_->get<std::uint64_t>();
}

bool JsonValue::boolean() const {
  if (!is_boolean()) fail(std::string("true or false is needed, this is ") + value_->type_name());
  return value_->get<bool>();
}

std::string JsonValue::string() const {
  if (!is_string()) fail(std::string("a text is needed, this is ") + value_->type_name());
  return value_->get<std::string>();
}

std::array<double, 3> JsonValue::vector() const {
  const auto parts = items();
  if (parts.size() != 3)
    fail("three numbers [x, y, z] are needed, there are " + std::to_string(parts.size()));
  return {parts[0].number(), parts[1].number(), parts[2].number()};
}

std::size_t JsonValue::choice(std::initializer_list<std::string_view> choices) const {
  const std::string word = string();
  const auto found = std::find(choices.begin(), choices.end(), word);
  if (found == choices.end())
    fail("unknown value \"" + word + "\"; known here: " + listed(choices));
  return static_cast<std::size_t>(found - choices.begin());
}

}  // namespace cleave::app
