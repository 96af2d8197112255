#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "cleave/topology/cell_soup.hpp"
#include "faces.hpp"

namespace cleave::topology::detail {

/// All simplices of a complex by number alone: those of dimension k are 0 .. count(k)-1 in the
/// order of their vertices, and `faces[k]` holds the k+1 faces of each, which are numbers of
/// dimension k-1.
struct Incidence {
  std::vector<std::size_t> counts;
  std::vector<std::vector<Index>> faces;  // faces[0] is empty
};

/// All different k-simplices of `cells` (each ascending), sorted.
template <int K, int D>
std::vector<std::array<VertexId, K + 1>> distinct_simplices(std::span<const Cell<D>> cells) {
  std::vector<std::array<VertexId, K + 1>> simplices;
  simplices.reserve(cells.size() * face_count(D, K));
  for (const Cell<D>& cell : cells)
    for_each_face<K, D>(cell, [&](const auto& simplex) { simplices.push_back(simplex); });
  std::sort(simplices.begin(), simplices.end());
  simplices.erase(std::unique(simplices.begin(), simplices.end()), simplices.end());
  return simplices;
}

/// For each k-simplex its faces, as places in `lower`, the sorted list of all (k-1)-simplices.
template <int K>
std::vector<Index> faces_of(const std::vector<std::array<VertexId, K + 1>>& simplices,
                            const std::vector<std::array<VertexId, K>>& lower) {
  std::vector<std::pair<std::array<VertexId, K>, Index>> all;
  all.reserve(simplices.size() * (K + 1));
  for (Index s = 0; s < simplices.size(); ++s)
    for (std::size_t left_out = 0; left_out <= K; ++left_out) {
      std::array<VertexId, K> face{};
      for (std::size_t i = 0; i < K; ++i) face[i] = simplices[s][i < left_out ? i : i + 1];
      all.emplace_back(face, s);
    }
  std::sort(all.begin(), all.end());
  std::vector<Index> faces(all.size());
  std::vector<std::uint8_t> filled(simplices.size(), 0);
  Index place = 0;
  for (const auto& [face, s] : all) {
    while (lower[place] != face) ++place;
    faces[std::size_t{s} * (K + 1) + filled[s]++] = place;
  }
  return faces;
}

/// Adds the dimensions K .. D to `found`; `lower` are the simplices of dimension K-1. False: there
/// are more than `left` simplices.
template <int K, int D>
bool add_dimensions(std::span<const Cell<D>> cells, std::vector<std::array<VertexId, K>> lower,
                    std::size_t left, Incidence& found) {
  auto simplices = distinct_simplices<K, D>(cells);
  if (simplices.size() > left) return false;
  found.counts.push_back(simplices.size());
  found.faces.push_back(faces_of<K>(simplices, lower));
  lower = {};
  if constexpr (K < D)
    return add_dimensions<K + 1, D>(cells, std::move(simplices), left - found.counts.back(), found);
  return true;
}

/// Nothing, if there are more than `limit` simplices. Time: O(n log n).
template <int D>
std::optional<Incidence> incidence(const CellSoup<D>& soup, std::size_t limit) {
  std::vector<Cell<D>> cells = soup.cells;
  for (Cell<D>& cell : cells) std::sort(cell.begin(), cell.end());
  auto vertices = distinct_simplices<0, D>(cells);
  if (vertices.size() > limit) return std::nullopt;
  Incidence found{{vertices.size()}, {{}}};
  const std::size_t left = limit - vertices.size();
  if (!add_dimensions<1, D>(cells, std::move(vertices), left, found)) return std::nullopt;
  return found;
}

}  // namespace cleave::topology::detail
