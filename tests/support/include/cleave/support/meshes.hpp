#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "cleave/topology/ids.hpp"

/// Meshes, cuts and slow references for the tests. Nothing here shares a header with topology/ but
/// the ids, so that what is checked and what checks it have no code in common.
namespace cleave::support {

using topology::Cell;
using topology::CellId;
using topology::CornerId;
using topology::Facet;
using topology::HalfFacetId;
using topology::VertexId;

/// Cells and the bound on their vertex numbers. The order of a tuple means nothing here: signs that
/// make the cells coherent come from coherent_signs (reference.hpp).
template <int D>
struct Mesh {
  std::vector<Cell<D>> cells;
  std::size_t vertex_count = 0;
};

/// The Kuhn subdivision of a box of nodes[0] x .. x nodes[D-1] integer points, D! cells per cube.
/// Vertices are numbered lexicographically by their coordinates, cubes likewise, the cells of a
/// cube by the permutation of axes that walks from its least to its greatest point.
template <int D>
struct KuhnGrid : Mesh<D> {
  using Point = std::array<int, static_cast<std::size_t>(D)>;
  explicit KuhnGrid(Point nodes_per_axis);

  Point nodes;
  Point point(VertexId v) const;
  VertexId vertex(Point p) const;

  /// The least point of the cube that a cell belongs to.
  Point cube(std::size_t cell) const;
};

/// One simplex.
template <int D>
Mesh<D> simplex();

/// The boundary of a simplex of dimension D+1: a sphere of D+2 cells.
template <int D>
Mesh<D> simplex_boundary();

/// The Kuhn subdivision of the D-torus, n >= 3 vertices along each axis: n^D D! cells.
template <int D>
Mesh<D> torus(int n);

/// All cells of `base` joined with one new vertex, which gets the number base.vertex_count.
template <int D>
Mesh<D> cone(const Mesh<D - 1>& base);

/// All cells of `base` joined with each of two new vertices.
template <int D>
Mesh<D> suspension(const Mesh<D - 1>& base);

/// A strip of `n` triangles, n >= 5, whose ends are joined with a twist if n is odd (Moebius band),
/// without if n is even.
Mesh<2> band(int n);

/// The projective plane with six vertices and ten triangles.
Mesh<2> projective_plane();

/// `a` and `b` side by side; the vertices of `b` are numbered after those of `a`.
template <int D>
Mesh<D> disjoint_union(Mesh<D> a, const Mesh<D>& b);

/// The cells whose `keep` is true, in their order; vertices keep their numbers.
template <int D>
Mesh<D> sub_mesh(const Mesh<D>& mesh, const std::vector<bool>& keep);

}  // namespace cleave::support
