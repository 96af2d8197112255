#include "element_builder.hpp"

#include <algorithm>

namespace cleave::app {

ElementBuilder::ElementBuilder(const Elements& before, int dimension)
    : before_(before),
      corners_(static_cast<std::size_t>(dimension) + 1),
      stays_(before.size()),
      kept_(before.vertices) {}

ElementBuilder::Handle ElementBuilder::add_image(std::uint32_t source,
                                                 std::span<const std::uint32_t> vertices) {
  if (stays_[source]) return add(vertices);
  stays_[source] = true;
  std::copy(vertices.begin(), vertices.end(),
            kept_.begin() + static_cast<std::ptrdiff_t>(corners_ * source));
  return source;
}

ElementBuilder::Handle ElementBuilder::add(std::span<const std::uint32_t> vertices) {
  more_.insert(more_.end(), vertices.begin(), vertices.end());
  return static_cast<Handle>(stays_.size() + more_.size() / corners_ - 1);
}

Elements ElementBuilder::finish(std::uint64_t& next_number, std::span<Group> groups) const {
  Elements after;
  const std::size_t more = more_.size() / corners_;
  std::vector<std::uint32_t> place_of(stays_.size() + more);
  for (std::uint32_t e = 0; e < stays_.size(); ++e) {
    if (!stays_[e]) continue;
    place_of[e] = static_cast<std::uint32_t>(after.size());
    const auto from = kept_.begin() + static_cast<std::ptrdiff_t>(corners_ * e);
    after.vertices.insert(after.vertices.end(), from, from + static_cast<std::ptrdiff_t>(corners_));
    after.numbers.push_back(before_.numbers[e]);
  }
  for (std::size_t i = 0; i < more; ++i) {
    place_of[stays_.size() + i] = static_cast<std::uint32_t>(after.size());
    after.numbers.push_back(next_number++);
  }
  after.vertices.insert(after.vertices.end(), more_.begin(), more_.end());

  for (Group& group : groups) {
    for (std::uint32_t& e : group.elements) e = place_of[e];
    std::sort(group.elements.begin(), group.elements.end());
    group.elements.erase(std::unique(group.elements.begin(), group.elements.end()),
                         group.elements.end());
  }
  return after;
}

}  // namespace cleave::app
