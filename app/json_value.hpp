#pragma once
#include <array>
#include <cstdint>
#include <initializer_list>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cleave::app {

/// Parses the JSON text `text` of the file `source`. Throws InputError with line and column for a
/// syntax error (NaN and infinities are none of JSON's numbers), and for a key that an object has
/// twice.
nlohmann::json parse_json(std::string_view text, const std::string& source);

/// A value inside a JSON document together with its place, for strict reading: whatever is not as
/// asked is an InputError that names the file and the JSON pointer of the place. Refers to the
/// document, which must outlive it.
class JsonValue {
 public:
  JsonValue(const nlohmann::json& value, std::string source, std::string pointer = {});

  const std::string& pointer() const { return pointer_; }

  /// Throws InputError: "SOURCE: at POINTER: what".
  [[noreturn]] void fail(const std::string& what) const;

  bool is_object() const;
  bool is_array() const;
  bool is_string() const;
  bool is_boolean() const;

  /// Whether the object has the key. Fails unless the value is an object.
  bool has(std::string_view key) const;

  /// The member `key`. Fails if there is none.
  JsonValue operator[](std::string_view key) const;

  /// Fails for a key that is not among `known`. "comment" is known everywhere.
  void only(std::initializer_list<std::string_view> known) const;

  /// The one of these keys that the object has. Fails if it has none or several.
  std::string_view one_of(std::initializer_list<std::string_view> keys) const;

  /// The elements of an array; the members of an object, without "comment".
  std::vector<JsonValue> items() const;
  std::vector<std::pair<std::string, JsonValue>> members() const;

  double number() const;
  std::uint64_t count() const;  // an integer from 0 on
  bool boolean() const;
  std::string string() const;
  std::array<double, 3> vector() const;

  /// The place of the string among `choices`. Fails for another string and names the choices.
  std::size_t choice(std::initializer_list<std::string_view> choices) const;

 private:
  const nlohmann::json* value_;
  std::string source_, pointer_;
};

}  // namespace cleave::app
