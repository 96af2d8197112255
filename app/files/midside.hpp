#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "mesh.hpp"

namespace cleave::app {

/// By dimension and node of second order as a format lists them: its place in Elements::midside.
using MidsideOrder = std::array<std::array<std::uint8_t, 6>, 4>;

/// VTK's and Abaqus's: around the first triangle, then up to the last corner.
inline constexpr MidsideOrder kCyclicMidside{{{}, {0}, {0, 2, 1}, {0, 3, 1, 2, 4, 5}}};

/// TetGen's and Triangle's: of a triangle, opposite its corners.
inline constexpr MidsideOrder kTetgenMidside{{{}, {0}, {2, 1, 0}, {5, 2, 0, 3, 4, 1}}};

/// Edges of a simplex, which are as many as it has nodes of second order.
constexpr std::size_t edges_of_simplex(std::size_t dimension) {
  return dimension * (dimension + 1) / 2;
}

/// Appends the nodes of second order of one element, in a format's order.
inline void add_midside(Elements& elements, std::size_t dimension, const MidsideOrder& order,
                        std::span<const Index> nodes) {
  const std::size_t at = elements.midside.size();
  elements.midside.resize(at + nodes.size());
  for (std::size_t k = 0; k < nodes.size(); ++k)
    elements.midside[at + order[dimension][k]] = nodes[k];
}

/// The k-th node of second order, in a format's order, of an element.
inline Index midside_node(const Elements& elements, std::size_t dimension,
                          const MidsideOrder& order, std::size_t element, std::size_t k) {
  return elements.midside[edges_of_simplex(dimension) * element + order[dimension][k]];
}

}  // namespace cleave::app
