#pragma once
#include <cstddef>
#include <cstdint>

namespace cleave::topology::detail {

/// The slot of `key` in a hash table of 2^bits slots: multiplication by 2^64 over the golden ratio
/// (Knuth, The Art of Computer Programming 3, section 6.4).
constexpr std::size_t hash_bits(std::uint64_t key, int bits) {
  return static_cast<std::size_t>(key * 0x9E3779B97F4A7C15u >> (64 - bits));
}

}  // namespace cleave::topology::detail
