#include "files/msh_nodes.hpp"

#include <algorithm>

namespace cleave::app {
namespace {

bool is_run(const std::vector<std::uint64_t>& numbers) {
  for (std::size_t i = 1; i < numbers.size(); ++i)
    if (numbers[i] != numbers[0] + i) return false;
  return true;
}

}  // namespace

std::optional<std::uint64_t> MshNodes::index(const std::vector<std::uint64_t>& numbers) {
  if (numbers.empty()) return {};
  const auto [least, greatest] = std::minmax_element(numbers.begin(), numbers.end());
  first_ = *least;
  if (is_run(numbers)) {
    run_ = numbers.size();
    return {};
  }
  constexpr std::uint64_t kSparse = 8;  // table entries per vertex above which a list is smaller
  const auto count = static_cast<Index>(numbers.size());
  if (*greatest - first_ < kSparse * count) {
    table_.assign(*greatest - first_ + 1, kNone);
    for (Index i = 0; i < count; ++i) {
      Index& place = table_[numbers[i] - first_];
      if (place != kNone) return numbers[i];
      place = i;
    }
    return {};
  }
  sorted_.reserve(count);
  for (Index i = 0; i < count; ++i) sorted_.emplace_back(numbers[i], i);
  std::sort(sorted_.begin(), sorted_.end());
  const auto twice = std::adjacent_find(sorted_.begin(), sorted_.end(),
                                        [](auto& a, auto& b) { return a.first == b.first; });
  if (twice != sorted_.end()) return twice->first;
  return {};
}

Index MshNodes::find(std::uint64_t number) const {
  if (run_ > 0)
    return number >= first_ && number - first_ < run_ ? static_cast<Index>(number - first_) : kNone;
  if (!table_.empty())
    return number >= first_ && number - first_ < table_.size() ? table_[number - first_] : kNone;
  const auto found = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair{number, Index{0}});
  return found != sorted_.end() && found->first == number ? found->second : kNone;
}

}  // namespace cleave::app
