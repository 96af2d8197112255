#pragma once
#include <array>
#include <optional>
#include <string_view>

#include "sample.hpp"

namespace cleave::proofs {

/// What can be done to a result. `renamed` is harmless always, some of the others by chance.
enum class Mutation {
  renamed,        // other numbers for all vertices
  wrong_vertex,   // one corner has a vertex of another corner
  other_copy,     // one corner has another copy of its own vertex
  lost_split,     // two copies of a vertex made one
  extra_split,    // some corners of a vertex made another vertex
  swapped_cells,  // two cells in each other's place
  permuted_cell,  // the corners of a cell in another order
  dropped_cell,
  added_cell,
  other_cut  // a facet more or less was cut
};

inline constexpr std::array kMutations{
    Mutation::renamed,     Mutation::wrong_vertex,  Mutation::other_copy,    Mutation::lost_split,
    Mutation::extra_split, Mutation::swapped_cells, Mutation::permuted_cell, Mutation::dropped_cell,
    Mutation::added_cell,  Mutation::other_cut};

std::string_view name(Mutation mutation);

/// The cells after, mutated; nothing where there is nothing to do it to.
std::optional<std::vector<std::uint32_t>> mutated(const Sample& sample, Mutation mutation,
                                                  Rng& rng);

}  // namespace cleave::proofs
