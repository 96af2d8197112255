#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "body.hpp"

namespace cleave::app {

constexpr Index kNoPlace = topology::kNoIndex;

/// Where the vertices of a file are after a cut.
template <int D>
struct Renaming {
  const Body<D>* body;
  const topology::Complex<D>* after;
  std::vector<Index> place_of;  // in the output, per vertex of `after`; kNoPlace: not in use

  /// The place in the output of the vertex that `cell` has now where it had file place `place`.
  /// Requires that it had.
  Index in_cell(topology::CellId cell, Index place) const;
};

/// How many vertices of the output each vertex of the file has become. Time: linear in the cells.
template <int D>
std::vector<Index> count_copies(const Renaming<D>& renaming);

/// The images of the elements of one dimension: an element below the dimension of the cells is,
/// after a cut, once in the output for each distinct tuple that the cells around it make of it.
struct Images {
  std::vector<Index> first;     // per element and one more: its images are [first[e], first[e+1])
  std::vector<Index> vertices;  // element_dimension+1 places in the output per image, in
                                // the order of the element's own tuple
};

/// Images of `elements`, each element_dimension+1 places in the body's mesh, by ascending cell. An
/// element with a vertex that no cell uses has none; an element that no cell contains has one, on
/// the original vertices. Time: linear in the cells, and sorting the elements that the cut touched.
template <int D>
Images images_of(const Renaming<D>& renaming, int element_dimension, const Elements& elements);

}  // namespace cleave::app
