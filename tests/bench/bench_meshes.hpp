#pragma once
#include <string>
#include <vector>

#include "cleave/topology/cell_soup.hpp"

/// Meshes of the benchmarks that are no grids, read from files.
namespace cleave::bench {

/// Those there are, by name: `liver`, an organ of about 1M tetrahedra, and `points`, the 6.7M of
/// the Delaunay triangulation of 1M random points in CGAL's order, which the build makes if it
/// finds CGAL (CMakeLists.txt); and `mesh`, a Medit file named by the environment variable
/// CLEAVE_BENCH_MESH.
std::vector<std::string> mesh_files();

/// A mesh by name: one of mesh_files(), `cube-N` for kuhn_soup<3>(N), or either of these with
/// `-shuffled` at its end. Coherently oriented and cut-regular: vertices of a file whose star is in
/// several parts are split. Throws std::runtime_error if it cannot be read.
topology::CellSoup<3> named_mesh(std::string name);

}  // namespace cleave::bench
