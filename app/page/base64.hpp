#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace cleave::app::page {

/// Base64 (RFC 4648, section 4, with padding) of some bytes.
std::string base64(std::span<const std::byte> bytes);
std::string base64(std::string_view bytes);

/// Base64 of numbers stored little-endian: what a JavaScript typed array reads.
std::string base64(std::span<const std::uint32_t> numbers);
std::string base64(std::span<const std::uint64_t> numbers);
std::string base64(std::span<const float> numbers);

}  // namespace cleave::app::page
