#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

#include "bodies.hpp"
#include "cleave/topology/facet_set.hpp"

/// The cuts that are measured.
namespace cleave::bench {

/// The facets in square patches with a rim inside, `count` of them, on parallel planes spread over
/// a body whose numbers are in mesh order.
template <int D>
topology::FacetSet patches(const Body<D>& body, std::size_t count) {
  using topology::Index;
  const auto cubes = static_cast<std::size_t>(body.cubes), nodes = cubes + 1;
  const auto facets_of_side = [](std::size_t side) {  // (D-1)! in each square of the plane
    std::size_t facets = 1;
    for (std::size_t axis = 1; axis < D; ++axis) facets *= side * axis;
    return facets;
  };
  const std::size_t largest = facets_of_side(cubes - 2);
  const std::size_t planes = (count + largest - 1) / largest;
  std::size_t side = 1;
  while (D > 1 && facets_of_side(side) * planes < count) ++side;
  const std::size_t low = (cubes - side) / 2, high = low + side;
  const std::size_t cells_of_slab = body.complex.cell_count() / cubes;

  // Axis 0 counts slowest, in vertices as in cells.
  const auto in_patch = [&](topology::VertexId v, std::size_t plane) {
    std::size_t rest = v.value;
    for (std::size_t axis = D; axis-- > 1; rest /= nodes)
      if (rest % nodes < low || rest % nodes > high) return false;
    return rest == plane;
  };
  std::vector<topology::HalfFacetId> found;
  for (std::size_t n = 1; n <= planes; ++n) {
    const std::size_t plane = n * cubes / (planes + 1), begin = plane * cells_of_slab;
    for (std::size_t h = (D + 1) * begin; h < (D + 1) * (begin + cells_of_slab); ++h) {
      const topology::HalfFacetId half_facet{static_cast<Index>(h)};
      const topology::Facet<D> facet = body.complex.facet(half_facet);
      if (std::all_of(facet.begin(), facet.end(), [&](auto v) { return in_patch(v, plane); }))
        found.push_back(half_facet);
    }
  }
  if (found.size() < count) throw std::logic_error("the body is too small for the cut");
  found.resize(count);
  return topology::FacetSet::of(body.complex, found);
}

/// The same facets for the yardstick.
inline std::vector<std::uint32_t> numbers(std::span<const topology::HalfFacetId> half_facets) {
  std::vector<std::uint32_t> values;
  values.reserve(half_facets.size());
  for (const topology::HalfFacetId h : half_facets)
    values.push_back(static_cast<std::uint32_t>(h.value));
  return values;
}

/// The corners at the vertices of the cut, which is what a cut has to look at.
template <int D>
std::size_t corners_around(const Body<D>& body, const topology::FacetSet& cut) {
  std::vector<topology::VertexId> vertices;
  for (const topology::HalfFacetId h : cut.half_facets())
    for (const topology::VertexId v : body.complex.facet(h)) vertices.push_back(v);
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  std::size_t corners = 0;
  for (const topology::VertexId v : vertices) corners += topology::star(body.complex, v).size();
  return corners;
}

}  // namespace cleave::bench
