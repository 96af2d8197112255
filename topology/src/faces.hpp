#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "cleave/topology/ids.hpp"

/// Faces of single cells, for what lists all simplices of one dimension.
namespace cleave::topology::detail {

/// Sorts `vertices` and returns the parity of the permutation that does it: +1 even, -1 odd.
inline int sort_with_parity(std::span<VertexId> vertices) {
  int parity = 1;
  for (std::size_t end = 1; end < vertices.size(); ++end)
    for (std::size_t i = end; i > 0 && vertices[i] < vertices[i - 1]; --i) {
      std::swap(vertices[i], vertices[i - 1]);
      parity = -parity;
    }
  return parity;
}

/// Calls visit(face) for the k-faces of `cell`, which is ascending: every subset of K+1 different
/// vertices, ascending. A vertex that the cell repeats counts once, but faces with it may come more
/// than once.
template <int K, int D, class Visit>
void for_each_face(const Cell<D>& cell, Visit visit) {
  for (std::uint32_t subset = 1; subset < (1u << (D + 1)); ++subset) {
    if (std::popcount(subset) != K + 1) continue;
    std::array<VertexId, K + 1> face{};
    std::size_t size = 0;
    for (std::size_t i = 0; i <= D; ++i)
      if ((subset >> i & 1u) != 0) face[size++] = cell[i];
    if (std::adjacent_find(face.begin(), face.end()) == face.end()) visit(face);
  }
}

/// The number of k-faces of a D-simplex: k+1 of D+1 vertices.
constexpr std::size_t face_count(int d, int k) {
  std::size_t count = 1;
  for (int i = 0; i <= k; ++i)
    count = count * static_cast<std::size_t>(d + 1 - i) / static_cast<std::size_t>(i + 1);
  return count;
}

/// Calls visit(std::integral_constant<int, k>) for the run-time number `k` in 0 .. D.
template <int D, class Visit>
void with_dimension(int k, Visit visit) {
  [&]<int... K>(std::integer_sequence<int, K...>) {
    ((K == k ? visit(std::integral_constant<int, K>{}) : void()), ...);
  }
  (std::make_integer_sequence<int, D + 1>{});
}

}  // namespace cleave::topology::detail
