#include "files/numbers.hpp"

#include <algorithm>

namespace cleave::app {

std::vector<std::uint64_t> counted(std::size_t count) {
  std::vector<std::uint64_t> numbers(count);
  for (std::size_t i = 0; i < count; ++i) numbers[i] = i + 1;
  return numbers;
}

bool can_be_kept(std::vector<std::uint64_t> numbers, std::uint64_t greatest) {
  if (!std::is_sorted(numbers.begin(), numbers.end())) std::sort(numbers.begin(), numbers.end());
  return numbers.empty() || (numbers.front() > 0 && numbers.back() <= greatest &&
                             std::adjacent_find(numbers.begin(), numbers.end()) == numbers.end());
}

std::vector<std::uint64_t> kept_or_counted(const std::vector<std::uint64_t>& numbers,
                                           std::uint64_t greatest) {
  return can_be_kept(numbers, greatest) ? numbers : counted(numbers.size());
}

}  // namespace cleave::app
