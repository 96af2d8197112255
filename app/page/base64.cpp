#include "page/base64.hpp"

#include <bit>
#include <vector>

namespace cleave::app::page {
namespace {

constexpr std::string_view kDigits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

template <class Unsigned>
std::string little_endian(std::span<const Unsigned> numbers) {
  std::vector<std::byte> bytes;
  bytes.reserve(sizeof(Unsigned) * numbers.size());
  for (const auto number : numbers)
    for (std::size_t i = 0; i < sizeof(Unsigned); ++i)
      bytes.push_back(static_cast<std::byte>(number >> (8 * i) & 255U));
  return base64(std::span<const std::byte>(bytes));
}

}  // namespace

std::string base64(std::span<const std::byte> bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    const auto left = bytes.size() - at;
    std::uint32_t three = 0;
    for (std::size_t i = 0; i < 3; ++i)
      three = three << 8 | (i < left ? std::to_integer<std::uint32_t>(bytes[at + i]) : 0U);
    for (std::size_t i = 0; i < 4; ++i)
      text += i <= left ? kDigits[three >> (18 - 6 * i) & 63U] : '=';
  }
  return text;
}

std::string base64(std::string_view bytes) {
  return base64(std::as_bytes(std::span(bytes.data(), bytes.size())));
}

std::string base64(std::span<const std::uint32_t> numbers) { return little_endian(numbers); }
std::string base64(std::span<const std::uint64_t> numbers) { return little_endian(numbers); }

std::string base64(std::span<const float> numbers) {
  std::vector<std::uint32_t> bits;
  bits.reserve(numbers.size());
  for (const auto number : numbers) bits.push_back(std::bit_cast<std::uint32_t>(number));
  return little_endian(std::span<const std::uint32_t>(bits));
}

}  // namespace cleave::app::page
