#pragma once
#include <array>
#include <cstddef>

namespace cleave::app {

/// One of gmsh's types of elements that Cleave knows.
struct MshKind {
  int type;
  int dimension;
  std::size_t corners;
  std::size_t midside;  // nodes of second order, after the corners
  bool cohesive;

  std::size_t nodes() const { return corners + midside; }
};

/// Simplices of order 1 by dimension, then of order 2 from dimension 1 on, then the quadrangle and
/// the prism.
inline constexpr std::array<MshKind, 9> kMshKinds = {{{15, 0, 1, 0, false},
                                                      {1, 1, 2, 0, false},
                                                      {2, 2, 3, 0, false},
                                                      {4, 3, 4, 0, false},
                                                      {8, 1, 2, 1, false},
                                                      {9, 2, 3, 3, false},
                                                      {11, 3, 4, 6, false},
                                                      {3, 2, 4, 0, true},
                                                      {6, 3, 6, 0, true}}};

constexpr const MshKind& msh_simplex(int dimension, bool second_order) {
  return kMshKinds[static_cast<std::size_t>(dimension) + (second_order ? 3U : 0U)];
}

constexpr const MshKind& msh_cohesive(int dimension) {
  return kMshKinds[static_cast<std::size_t>(dimension) + 5];
}

/// Where Elements::midside has the i-th node of second order in gmsh's order of the edges, which is
/// (0,1) (1,2) (2,0) (3,0) (3,2) (3,1).
constexpr std::size_t msh_midside(int dimension, std::size_t i) {
  constexpr std::size_t kTriangle[] = {0, 2, 1};
  constexpr std::size_t kTetrahedron[] = {0, 3, 1, 2, 5, 4};
  return dimension == 3 ? kTetrahedron[i] : dimension == 2 ? kTriangle[i] : i;
}

/// Where CohesiveElements::vertices has the i-th node of an element in gmsh's order, which runs
/// around a quadrangle.
constexpr std::size_t msh_cohesive_node(int dimension, std::size_t i) {
  constexpr std::size_t kQuadrangle[] = {0, 1, 3, 2};
  return dimension == 2 ? kQuadrangle[i] : i;
}

}  // namespace cleave::app
