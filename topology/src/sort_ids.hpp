#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <utility>
#include <vector>

#include "cleave/topology/ids.hpp"

namespace cleave::topology::detail {

/// Sorts ids by their digits, least digit first (Knuth, The Art of Computer Programming 3, section
/// 5.2.5): as many passes as the range of the ids needs digits, for a small cut in a large mesh as
/// for a large one. `spare` is working memory.
template <class AnId>
void sort_ids(std::vector<AnId>& ids, std::vector<AnId>& spare) {
  constexpr std::size_t kFew = 256;
  if (ids.size() < kFew) return std::sort(ids.begin(), ids.end());
  const auto [least, greatest] = std::minmax_element(ids.begin(), ids.end());
  const Index base = least->value;
  constexpr int kMost = 11;  // bits of a digit: the counters of one stay in the first cache
  const int bits = std::max(1, static_cast<int>(std::bit_width(greatest->value - base)));
  const int digits = (bits + kMost - 1) / kMost, width = (bits + digits - 1) / digits;
  const Index mask = (Index{1} << width) - 1;
  if (spare.size() < ids.size()) spare.resize(ids.size());
  for (int shift = 0; shift < bits; shift += width) {
    std::array<std::size_t, std::size_t{1} << kMost> place{};
    for (const AnId id : ids) ++place[(id.value - base) >> shift & mask];
    std::size_t before = 0;
    for (std::size_t digit = 0; digit <= mask; ++digit)
      before += std::exchange(place[digit], before);
    for (const AnId id : ids) spare[place[(id.value - base) >> shift & mask]++] = id;
    std::copy_n(spare.begin(), ids.size(), ids.begin());
  }
}

}  // namespace cleave::topology::detail
