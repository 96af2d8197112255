#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "mesh.hpp"

namespace cleave::app {

/// The vertices of an element, and its nodes of second order if the mesh has any, as places in an
/// output.
struct ElementTuple {
  std::span<const Index> vertices, midside;
};

/// The elements of one dimension as they come to be in an output. An element of the file keeps its
/// place in the order or is gone; further elements follow. Until `finish` knows the places, groups
/// hold handles: the place in the file of an element that stays, numbers from there on for others.
class ElementBuilder {
 public:
  using Handle = Index;
  static constexpr Index kNoSource = topology::kNoIndex;

  /// Refers to `before`, which must outlive it. `second_order`: every tuple has its nodes.
  ElementBuilder(const Elements& before, int dimension, bool second_order);

  /// Adds an element made from element `source` of the file; the first one takes its place.
  Handle add_image(Index source, ElementTuple tuple);

  /// Adds an element behind those of the file. `source`: the element of the file whose values it
  /// takes, if any.
  Handle add(ElementTuple tuple, Index source = kNoSource);

  struct Built {
    Elements elements;
    std::vector<Index> source;  // of each, an element of the file or kNoSource
  };

  /// The elements; new ones are numbered from `next_number` on, which is advanced. In each of
  /// `groups` handles are replaced by places, ascending and distinct.
  Built finish(std::uint64_t& next_number, std::span<Group> groups) const;

 private:
  const Elements& before_;
  std::size_t corners_, edges_;                           // vertices and nodes of an element
  std::vector<bool> stays_;                               // per element of the file
  std::vector<Index> kept_, kept_midside_;                // of all of the file's elements
  std::vector<Index> more_, more_midside_, more_source_;  // of new ones
};

}  // namespace cleave::app
