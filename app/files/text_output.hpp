#pragma once
#include <charconv>
#include <string_view>
#include <type_traits>

#include "output_file.hpp"

namespace cleave::app {

/// Numbers and words into an OutputFile. Doubles get the shortest digits that read back to the same
/// bits; no locale matters.
class TextOutput {
 public:
  explicit TextOutput(OutputFile& file) : file_(&file) {}

  TextOutput& operator<<(std::string_view text) {
    file_->write(text);
    return *this;
  }
  TextOutput& operator<<(char c) { return *this << std::string_view(&c, 1); }

  template <class Number>
  requires std::is_arithmetic_v<Number> TextOutput& operator<<(Number value) {
    char digits[32];
    const auto result = std::to_chars(digits, digits + sizeof digits, value);
    return *this << std::string_view(digits, static_cast<std::size_t>(result.ptr - digits));
  }

 private:
  OutputFile* file_;
};

}  // namespace cleave::app
