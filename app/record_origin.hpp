#pragma once
#include <cstdint>
#include <vector>

#include "element_images.hpp"
#include "mesh.hpp"

namespace cleave::app {

/// Which points of an output come from which place of the original.
struct Origins {
  std::vector<Index> of;     // per point of the output: its place in the original
  std::vector<Index> first;  // per place: the first point from there; kNoPlace: none

  Origins(std::vector<Index> of_points, std::size_t places);
};

/// Pairs of the output as the original names them, each once.
std::vector<Periodicity> without_copies(const std::vector<Periodicity>& periodic,
                                        const Origins& origins);

bool same_pairs(const std::vector<Periodicity>& a, const std::vector<Periodicity>& b);

}  // namespace cleave::app
