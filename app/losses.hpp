#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "mesh.hpp"
#include "mesh_file.hpp"

namespace cleave::app {

/// One kind of content that a file cannot hold.
struct Loss {
  std::string kind;  // "cohesive-elements", ..: docs/files.md lists them
  std::size_t count = 0;
  std::string message;  // what becomes of it, in one sentence
};

/// What of `mesh` is lost when write_mesh writes it to `path`; empty: reading the file gives the
/// same mesh again, except that vertices and elements which are numbered by place may count from 0
/// instead of 1. Throws InputError as require_options_fit does. Time: linear.
std::vector<Loss> losses_of(const Mesh& mesh, const std::filesystem::path& path,
                            const WriteOptions& options);

}  // namespace cleave::app
