#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cleave/topology/cell_soup.hpp"

/// What the benchmarks ask of other programs. Each peer is one file, peer_*.cpp, which adds itself
/// to these lists; CMake leaves out the files whose packages are missing.
namespace cleave::bench {

/// What another program holds of the cells it was given.
class PeerMesh {
 public:
  PeerMesh() = default;
  PeerMesh(const PeerMesh&) = delete;
  PeerMesh& operator=(const PeerMesh&) = delete;
  virtual ~PeerMesh() = default;

  /// Goes from each cell to all its neighbours; returns how many steps that were: two for each
  /// interior facet, more if the structure has cells of its own at the boundary.
  virtual std::uint64_t visit_neighbours() = 0;

  /// Visits the cells around each vertex; returns how many visits that were: D+1 for each cell.
  virtual std::uint64_t visit_stars() = 0;
};

/// A structure made of tuples of vertices.
template <int D>
struct Assembler {
  std::string name;  // library_structure
  /// Null if the program refuses the cells.
  std::function<std::unique_ptr<PeerMesh>(const topology::CellSoup<D>&)> assemble;
  std::size_t most_cells;      // beyond these it takes minutes, or too much memory
  std::size_t most_traversed;  // the same for visiting; 0: do not
};

template <int D>
std::vector<Assembler<D>>& assemblers() {
  static std::vector<Assembler<D>> all;
  return all;
}

/// A mesh with a cut through it, as other programs want it: with coordinates, and the rim declared
/// where the cut meets the surface of the body.
template <int D>
struct CutMesh {
  topology::CellSoup<D> soup;
  std::vector<double> coordinates;  // three to a vertex
  std::vector<topology::Facet<D>> cut;
  std::vector<std::array<topology::VertexId, 2>> rim;  // D = 3: edges of the cut on the surface
};

struct Split {
  double seconds = 0;  // of the call that splits, and nothing else
  std::size_t new_vertices = 0;
};

/// A program that divides a mesh along facets of it.
template <int D>
struct Splitter {
  std::string name;
  std::function<Split(const CutMesh<D>&)> split;
  std::size_t most_cells, most_facets;
};

template <int D>
std::vector<Splitter<D>>& splitters() {
  static std::vector<Splitter<D>> all;
  return all;
}

/// Adds its argument to one of the lists; peers have one of these in an unnamed namespace.
struct Registration {
  template <int D>
  explicit Registration(Assembler<D> peer) {
    assemblers<D>().push_back(std::move(peer));
  }
  template <int D>
  explicit Registration(Splitter<D> peer) {
    splitters<D>().push_back(std::move(peer));
  }
};

}  // namespace cleave::bench
