#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "mesh.hpp"
#include "mesh_file.hpp"

namespace cleave::app {

/// The numbers that a file gives to what it lists; empty for what it has no numbers for.
struct FileNumbers {
  std::vector<std::uint64_t> vertices, cohesive;
  std::array<std::vector<std::uint64_t>, 4> elements;
};

/// The numbers that vertices and elements of `mesh` have in a file of `format`. Where points are
/// marks on vertices, theirs are the vertices'.
FileNumbers numbers_in(const Mesh& mesh, MeshFormat format, const WriteOptions& options);

/// How many of `before` are others in `after`, of the same length (or empty: none). Counting from 0
/// instead of 1, or the other way, is no change where numbers are places.
std::size_t numbers_changed(const std::vector<std::uint64_t>& before,
                            const std::vector<std::uint64_t>& after);

}  // namespace cleave::app
