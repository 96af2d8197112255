#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "mesh.hpp"

namespace cleave::app {

/// The elements of one dimension as they come to be in an output. An element of the file keeps its
/// place in the order or is gone; further elements follow. Until `finish` knows the places, groups
/// hold handles: the place in the file of an element that stays, numbers from there on for others.
class ElementBuilder {
 public:
  using Handle = std::uint32_t;

  /// Refers to `before`, which must outlive it.
  ElementBuilder(const Elements& before, int dimension);

  /// Adds an element made from element `source` of the file; the first one takes its place.
  Handle add_image(std::uint32_t source, std::span<const std::uint32_t> vertices);

  /// Adds an element behind those of the file.
  Handle add(std::span<const std::uint32_t> vertices);

  /// The elements; new ones are numbered from `next_number` on, which is advanced. In each of
  /// `groups` handles are replaced by places, ascending and distinct.
  Elements finish(std::uint64_t& next_number, std::span<Group> groups) const;

 private:
  const Elements& before_;
  std::size_t corners_;
  std::vector<bool> stays_;                 // per element of the file
  std::vector<std::uint32_t> kept_, more_;  // vertices: of all of the file's elements; of new ones
};

}  // namespace cleave::app
