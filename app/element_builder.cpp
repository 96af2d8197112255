#include "element_builder.hpp"

#include <algorithm>

#include "edge_nodes.hpp"

namespace cleave::app {
namespace {

void append(std::vector<Index>& to, const std::vector<Index>& from, std::size_t element,
            std::size_t width) {
  const auto begin = from.begin() + static_cast<std::ptrdiff_t>(width * element);
  to.insert(to.end(), begin, begin + static_cast<std::ptrdiff_t>(width));
}

}  // namespace

ElementBuilder::ElementBuilder(const Elements& before, int dimension, bool second_order)
    : before_(before),
      corners_(static_cast<std::size_t>(dimension) + 1),
      edges_(second_order ? edges_of_simplex(static_cast<std::size_t>(dimension)) : 0),
      stays_(before.size()),
      kept_(before.vertices),
      kept_midside_(before.midside) {}

ElementBuilder::Handle ElementBuilder::add_image(Index source, ElementTuple tuple) {
  if (stays_[source]) return add(tuple, source);
  stays_[source] = true;
  std::copy(tuple.vertices.begin(), tuple.vertices.end(),
            kept_.begin() + static_cast<std::ptrdiff_t>(corners_ * source));
  std::copy(tuple.midside.begin(), tuple.midside.end(),
            kept_midside_.begin() + static_cast<std::ptrdiff_t>(edges_ * source));
  return source;
}

ElementBuilder::Handle ElementBuilder::add(ElementTuple tuple, Index source) {
  more_.insert(more_.end(), tuple.vertices.begin(), tuple.vertices.end());
  more_midside_.insert(more_midside_.end(), tuple.midside.begin(), tuple.midside.end());
  more_source_.push_back(source);
  return static_cast<Handle>(stays_.size() + more_source_.size() - 1);
}

ElementBuilder::Built ElementBuilder::finish(std::uint64_t& next_number,
                                             std::span<Group> groups) const {
  Built built;
  Elements& after = built.elements;
  std::vector<Index> place_of(stays_.size() + more_source_.size());
  for (Index e = 0; e < stays_.size(); ++e) {
    if (!stays_[e]) continue;
    place_of[e] = static_cast<Index>(after.size());
    append(after.vertices, kept_, e, corners_);
    append(after.midside, kept_midside_, e, edges_);
    after.numbers.push_back(before_.numbers[e]);
    built.source.push_back(e);
  }
  for (std::size_t i = 0; i < more_source_.size(); ++i) {
    place_of[stays_.size() + i] = static_cast<Index>(after.size());
    after.numbers.push_back(next_number++);
    built.source.push_back(more_source_[i]);
  }
  after.vertices.insert(after.vertices.end(), more_.begin(), more_.end());
  after.midside.insert(after.midside.end(), more_midside_.begin(), more_midside_.end());

  for (Group& group : groups) {
    for (Index& e : group.elements) e = place_of[e];
    std::sort(group.elements.begin(), group.elements.end());
    group.elements.erase(std::unique(group.elements.begin(), group.elements.end()),
                         group.elements.end());
  }
  return built;
}

}  // namespace cleave::app
