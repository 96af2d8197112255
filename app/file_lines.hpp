#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>

namespace cleave::app {

/// Lines (from 1 on) on which elements of a mesh file stand, by the file's own numbers.
struct FileLines {
  std::map<std::uint64_t, std::size_t> cells, vertices;
};

/// The lines of the `cells` (of this dimension) and `vertices` asked for in a text file `.mesh` or
/// `.msh` that read_mesh has taken; nothing for other formats, binary and compressed files. Time:
/// one pass over the file.
FileLines find_lines(const std::string& path, int dimension, const std::set<std::uint64_t>& cells,
                     const std::set<std::uint64_t>& vertices);

}  // namespace cleave::app
