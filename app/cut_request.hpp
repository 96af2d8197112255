#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

#include "cleave/cutting/sweep.hpp"
#include "mesh.hpp"

/// The files that say where to cut ("-": standard input): docs/schemas/facets.schema.json and
/// sweep.schema.json. Read strictly: an unknown key, a wrong type or a number that is not finite is
/// an InputError with the file and the JSON pointer; a syntax error one with line and column.
namespace cleave::app {

/// The facets that a file {"facets": [[a, b, c], ..]} names by the numbers of `mesh`: as many
/// places in mesh.points per facet as mesh.dimension. Throws InputError, also for a number that is
/// no vertex of `mesh`.
std::vector<Index> read_facets(const std::filesystem::path& path, const Mesh& mesh);

/// A sweep: {"blade": [[p, q], ..]} or {"triangles": [[p, q, r], ..], "step_of_triangle": [..]} for
/// D = 3, {"polyline": [p, ..]} for D = 2; points are lists of D numbers. Throws InputError.
template <int D>
cutting::Sweep<D> read_sweep(const std::filesystem::path& path);

}  // namespace cleave::app
