#include "cleave/topology/summary.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "disjoint_sets.hpp"
#include "faces.hpp"
#include "facet_matching.hpp"
#include "incidence.hpp"
#include "plain_mates.hpp"
#include "simplex_counts.hpp"
#include "soundness.hpp"

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

template <std::size_t Count>
void add_counts(const std::array<std::size_t, Count>& simplices, Summary& summary) {
  for (std::size_t k = 0; k < Count; ++k) {
    summary.simplices += simplices[k];
    const auto signed_count = static_cast<std::int64_t>(simplices[k]);
    summary.euler_characteristic += k % 2 == 0 ? signed_count : -signed_count;
  }
}

/// `boundary`: the facets in one cell only, each ascending.
template <int D>
std::size_t boundary_components(const std::vector<Facet<D>>& boundary) {
  if constexpr (D == 1)
    return boundary.size();
  else
    return components(boundary.size(), sorted_faces<D - 2, D - 1>(boundary));
}

/// The mates of cells that are sound, different and at most two at a facet; none of others.
template <int D>
std::optional<std::vector<HalfFacetId>> find_mates(const CellView<D>& soup) {
  detail::Crew alone;
  const auto as_written = [](CellId) { return false; };
  auto mates = detail::plain_mates<D>(soup.cells, soup.vertex_count, as_written, alone);
  if (mates) return mates;
  if (!detail::unsound_cells(soup).empty()) return std::nullopt;
  auto matching = detail::match_facets<D>(soup.cells, soup.vertex_count);
  if (!matching.duplicates.empty() || !matching.crowded.empty()) return std::nullopt;
  return std::move(matching.mates);
}

template <int D>
Summary summary_of_mates(const CellView<D>& soup, const std::vector<HalfFacetId>& mates) {
  Summary summary;
  add_counts(detail::simplex_counts<D>(soup.cells, mates, soup.vertex_count), summary);
  detail::DisjointSets pieces(soup.cells.size());
  std::vector<Facet<D>> boundary;
  for (Index h = 0; h < mates.size(); ++h) {
    const Index cell = cell_of<D>(HalfFacetId{h}).value;
    if (!detail::is_mate(mates[h])) {
      Facet<D>& facet = boundary.emplace_back();
      std::remove_copy(soup.cells[cell].begin(), soup.cells[cell].end(), facet.begin(),
                       soup.cells[cell][static_cast<std::size_t>(local_index<D>(HalfFacetId{h}))]);
      std::sort(facet.begin(), facet.end());
    } else if (mates[h].value > h) {
      pieces.join(cell, cell_of<D>(mates[h]).value);
    }
  }
  summary.pieces = pieces.count();
  summary.boundary_components = boundary_components<D>(boundary);
  return summary;
}

/// Of any soup.
template <int D>
Summary summary_of_sets(const CellView<D>& soup) {
  std::vector<Cell<D>> cells(soup.cells.begin(), soup.cells.end());
  for (Cell<D>& cell : cells) std::sort(cell.begin(), cell.end());
  Summary summary;
  [&]<int... K>(std::integer_sequence<int, K...>) {
    add_counts(std::array{detail::distinct_simplices<K, D>(cells).size()...}, summary);
  }
  (std::make_integer_sequence<int, D + 1>{});
  const auto facets = sorted_faces<D - 1, D>(cells);
  summary.pieces = components(cells.size(), facets);
  summary.boundary_components = boundary_components<D>(in_one_only(facets));
  return summary;
}

}  // namespace

template <int D>
Summary summarize(const CellView<D>& soup) {
  require_ids_suffice(D, soup.cells.size(), soup.vertex_count);
  const auto mates = find_mates(soup);
  return mates ? summary_of_mates(soup, *mates) : summary_of_sets(soup);
}

template Summary summarize(const CellView<1>&);
template Summary summarize(const CellView<2>&);
template Summary summarize(const CellView<3>&);
template Summary summarize(const CellView<4>&);

}  // namespace cleave::topology
