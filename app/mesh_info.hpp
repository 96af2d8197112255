#pragma once
#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cleave/topology/summary.hpp"
#include "mesh.hpp"

namespace cleave::app {

/// How a file is written, as its first bytes say; empty where the format has no such thing.
struct FileForm {
  std::string format, version, encoding;
};

/// Throws InputError for an extension that is not known or a file that cannot be read.
FileForm form_of(const std::filesystem::path& path);

/// What `cleave info` says of a mesh.
struct MeshInfo {
  struct Kind {
    int dimension = 0;
    std::string name;  // "triangle", ..
    int order = 1;
    std::size_t count = 0;
    std::uint64_t least = 0, greatest = 0;  // of the file's numbers
  };
  struct FieldInfo {
    std::string name, on;  // "points", "cells" or "facets"
    int components = 1;
    bool integer = false;
    std::vector<std::optional<std::array<double, 2>>> ranges;  // per component; none: not finite
  };
  std::string source;
  FileForm form;
  int dimension = 0;
  Kind vertices;
  std::vector<Kind> elements;  // of the kinds there are, by dimension; cohesive ones last
  std::vector<FieldInfo> fields;
  std::optional<std::array<std::array<double, 3>, 2>> box;  // of the finite points
  std::size_t not_finite = 0;                               // points
  std::optional<topology::Summary> topology;                // none: too many cells for the ids
};

/// Time: O(n log n) in the cells, for the topology; linear without.
MeshInfo info_of(const Mesh& mesh, const std::filesystem::path& path);

/// As lines of text.
std::string text_of(const MeshInfo& info, const Mesh& mesh);

/// As JSON (docs/schemas/cleave-info-1.schema.json).
std::string json_of(const MeshInfo& info, const Mesh& mesh);

}  // namespace cleave::app
