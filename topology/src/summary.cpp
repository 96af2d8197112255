#include "cleave/topology/summary.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>
#include <vector>

#include "faces.hpp"

namespace cleave::topology {
namespace {

/// Disjoint sets of 0 .. size-1, joined one pair at a time.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size) : parent_(size), count_(size) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    if (a == b) return;
    parent_[std::max(a, b)] = std::min(a, b);
    --count_;
  }
  std::size_t count() const { return count_; }

 private:
  std::uint32_t find(std::uint32_t a) {
    while (parent_[a] != a) a = parent_[a] = parent_[parent_[a]];
    return a;
  }

  std::vector<std::uint32_t> parent_;
  std::size_t count_;
};

/// A face of `of`, which is a cell or a boundary facet by its position in a list.
template <std::size_t Size>
struct FaceOf {
  std::array<VertexId, Size> face;
  std::uint32_t of;
  friend auto operator<=>(const FaceOf&, const FaceOf&) = default;
};

/// All k-faces of `simplices` (each ascending), sorted; one that a simplex has twice is named once.
template <int K, int D>
std::vector<FaceOf<K + 1>> sorted_faces(const std::vector<Cell<D>>& simplices) {
  std::vector<FaceOf<K + 1>> faces;
  faces.reserve(simplices.size() * detail::face_count(D, K));
  for (std::uint32_t s = 0; s < simplices.size(); ++s)
    detail::for_each_face<K, D>(simplices[s], [&](const auto& face) {
      faces.push_back({face, s});
    });
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

/// The number of sets that `count` simplices form when those with a common face are joined.
template <std::size_t Size>
std::size_t components(std::size_t count, const std::vector<FaceOf<Size>>& faces) {
  DisjointSets sets(count);
  for (std::size_t i = 1; i < faces.size(); ++i)
    if (faces[i].face == faces[i - 1].face) sets.join(faces[i].of, faces[i - 1].of);
  return sets.count();
}

/// The faces that belong to exactly one simplex.
template <std::size_t Size>
std::vector<std::array<VertexId, Size>> in_one_only(const std::vector<FaceOf<Size>>& faces) {
  std::vector<std::array<VertexId, Size>> single;
  for (std::size_t first = 0, last = 0; first < faces.size(); first = last) {
    while (last < faces.size() && faces[last].face == faces[first].face) ++last;
    if (last - first == 1) single.push_back(faces[first].face);
  }
  return single;
}

template <int K, int D>
std::int64_t distinct_faces(const std::vector<Cell<D>>& cells) {
  std::vector<std::array<VertexId, K + 1>> faces;
  faces.reserve(cells.size() * detail::face_count(D, K));
  for (const Cell<D>& cell : cells)
    detail::for_each_face<K, D>(cell, [&](const auto& face) { faces.push_back(face); });
  std::sort(faces.begin(), faces.end());
  return std::unique(faces.begin(), faces.end()) - faces.begin();
}

template <int D>
std::int64_t euler_characteristic(const std::vector<Cell<D>>& cells) {
  return [&]<int... K>(std::integer_sequence<int, K...>) {
    return ((K % 2 == 0 ? distinct_faces<K, D>(cells) : -distinct_faces<K, D>(cells)) + ...);
  }
  (std::make_integer_sequence<int, D + 1>{});
}

}  // namespace

template <int D>
Summary summarize(const CellSoup<D>& soup) {
  require_ids_suffice(D, soup.cells.size(), soup.vertex_count);
  std::vector<Cell<D>> cells = soup.cells;
  for (Cell<D>& cell : cells) std::sort(cell.begin(), cell.end());

  Summary summary;
  summary.euler_characteristic = euler_characteristic<D>(cells);
  const auto facets = sorted_faces<D - 1, D>(cells);
  summary.pieces = components(cells.size(), facets);
  const auto boundary = in_one_only(facets);
  if constexpr (D == 1)
    summary.boundary_components = boundary.size();
  else
    summary.boundary_components = components(boundary.size(), sorted_faces<D - 2, D - 1>(boundary));
  return summary;
}

template Summary summarize(const CellSoup<1>&);
template Summary summarize(const CellSoup<2>&);
template Summary summarize(const CellSoup<3>&);
template Summary summarize(const CellSoup<4>&);

}  // namespace cleave::topology
