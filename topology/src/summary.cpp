#include "cleave/topology/summary.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "disjoint_sets.hpp"
#include "faces.hpp"
#include "incidence.hpp"

namespace cleave::topology {
namespace {

/// A face of `of`, which is a cell or a boundary facet by its position in a list.
template <std::size_t Size>
struct FaceOf {
  std::array<VertexId, Size> face;
  Index of;
  friend auto operator<=>(const FaceOf&, const FaceOf&) = default;
};

/// All k-faces of `simplices` (each ascending), sorted; one that a simplex has twice is named once.
template <int K, int D>
std::vector<FaceOf<K + 1>> sorted_faces(std::span<const Cell<D>> simplices) {
  std::vector<FaceOf<K + 1>> faces;
  faces.reserve(simplices.size() * detail::face_count(D, K));
  for (Index s = 0; s < simplices.size(); ++s)
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
  detail::DisjointSets sets(count);
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

template <int D>
std::int64_t euler_characteristic(std::span<const Cell<D>> cells) {
  return [&]<int... K>(std::integer_sequence<int, K...>) {
    return ((static_cast<std::int64_t>(detail::distinct_simplices<K, D>(cells).size()) *
             (K % 2 == 0 ? 1 : -1)) +
            ...);
  }
  (std::make_integer_sequence<int, D + 1>{});
}

}  // namespace

template <int D>
Summary summarize(const CellView<D>& soup) {
  require_ids_suffice(D, soup.cells.size(), soup.vertex_count);
  std::vector<Cell<D>> cells(soup.cells.begin(), soup.cells.end());
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

template Summary summarize(const CellView<1>&);
template Summary summarize(const CellView<2>&);
template Summary summarize(const CellView<3>&);
template Summary summarize(const CellView<4>&);

}  // namespace cleave::topology
