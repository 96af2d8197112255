#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

namespace cleave::topology::detail {

/// Reserves room for `more` entries, at least doubling what there is, so that many small additions
/// cost no more than one large one.
template <class T>
void make_room(std::vector<T>& entries, std::size_t more) {
  const std::size_t needed = entries.size() + more;
  if (entries.capacity() < needed) entries.reserve(std::max(needed, 2 * entries.capacity()));
}

}  // namespace cleave::topology::detail
