#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace cleave::app {

/// 1 .. count.
std::vector<std::uint64_t> counted(std::size_t count);

/// Whether numbers can name things in a file: all positive, at most `greatest`, no two equal.
bool can_be_kept(std::vector<std::uint64_t> numbers, std::uint64_t greatest = UINT64_MAX);

/// `numbers` if they can be kept, else 1 .. their count.
std::vector<std::uint64_t> kept_or_counted(const std::vector<std::uint64_t>& numbers,
                                           std::uint64_t greatest = UINT64_MAX);

}  // namespace cleave::app
