#include "cleave/topology/simplices.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <utility>

#include "faces.hpp"

namespace cleave::topology {
namespace {

/// A simplex and one cell that has it; sorted, the pairs list simplices with their stars.
template <int K>
struct InCell {
  std::array<VertexId, K + 1> simplex;
  CellId cell;
  friend auto operator<=>(const InCell&, const InCell&) = default;
};

template <int K, int D>
std::vector<InCell<K>> sorted_pairs(const Complex<D>& k) {
  std::vector<InCell<K>> pairs;
  pairs.reserve(k.cell_count() * detail::face_count(D, K));
  for (Index c = 0; c < k.cell_count(); ++c) {
    Cell<D> cell = k.vertices({c});
    std::sort(cell.begin(), cell.end());
    detail::for_each_face<K, D>(cell, [&](const auto& face) { pairs.push_back({face, {c}}); });
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace

template <int D>
Simplices<D>::Simplices(const Complex<D>& k, int simplex_dimension) : k_(simplex_dimension) {
  if (k_ < 0 || k_ > D)
    throw std::invalid_argument("a complex of dimension " + std::to_string(D) +
                                " has no simplices of dimension " + std::to_string(k_));
  if (k.cell_count() > kNoIndex / detail::face_count(D, k_))
    throw std::length_error("too many (cell, face) pairs for " + std::to_string(kIdBits) +
                            "-bit numbers: " + std::to_string(k.cell_count()) +
                            " cells of dimension " + std::to_string(D) + ", faces of dimension " +
                            std::to_string(k_));
  detail::with_dimension<D>(k_, [&](auto dimension) {
    const auto pairs = sorted_pairs<dimension.value>(k);
    cells_.reserve(pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (i == 0 || pairs[i].simplex != pairs[i - 1].simplex) {
        offsets_.push_back(static_cast<Index>(i));
        vertices_.insert(vertices_.end(), pairs[i].simplex.begin(), pairs[i].simplex.end());
      }
      cells_.push_back(pairs[i].cell);
    }
    offsets_.push_back(static_cast<Index>(pairs.size()));
  });
}

template <int D>
auto Simplices<D>::find(std::span<const VertexId> tuple) const -> std::optional<Found> {
  if (tuple.size() != static_cast<std::size_t>(k_) + 1) return std::nullopt;
  Cell<D> buffer{};
  std::copy(tuple.begin(), tuple.end(), buffer.begin());
  const std::span<VertexId> wanted = std::span(buffer).first(tuple.size());
  const int parity = detail::sort_with_parity(wanted);

  std::size_t first = 0, last = count();  // the first simplex that is not less is in between
  while (first < last) {
    const std::size_t middle = first + (last - first) / 2;
    const auto simplex = (*this)[middle];
    if (std::lexicographical_compare(simplex.begin(), simplex.end(), wanted.begin(), wanted.end()))
      first = middle + 1;
    else
      last = middle;
  }
  if (first == count()) return std::nullopt;
  const auto simplex = (*this)[first];
  if (!std::equal(wanted.begin(), wanted.end(), simplex.begin())) return std::nullopt;
  return Found{first, parity, star(first).front()};
}

namespace {

/// The parity of `tuple` relative to the order of `facet`; 0 if they are not the same vertices.
template <int D>
int relative_parity(Facet<D> tuple, Facet<D> facet) {
  const int parity = detail::sort_with_parity(tuple) * detail::sort_with_parity(facet);
  return tuple == facet ? parity : 0;
}

}  // namespace

template <int D>
std::optional<FoundHalfFacet> find_half_facet(const Complex<D>& k, const Facet<D>& tuple,
                                              int sign) {
  if (sign != 1 && sign != -1) throw std::invalid_argument("the sign of a facet is +1 or -1");
  if (tuple[0].value >= k.vertex_count()) return std::nullopt;
  for (const CornerId corner : star(k, tuple[0])) {
    const CellId cell = cell_of<D>(corner);
    for (int i = 0; i <= D; ++i) {
      const HalfFacetId h = half_facet<D>(cell, i);
      const int parity = h == corner ? 0 : relative_parity<D>(tuple, k.facet(h));
      if (parity == 0) continue;
      if (parity * k.facet_sign(h) == sign) return FoundHalfFacet{h, 1};
      if (const auto mate = k.mate(h)) return FoundHalfFacet{*mate, 1};
      return FoundHalfFacet{h, -1};
    }
  }
  return std::nullopt;
}

template <int D>
std::vector<std::vector<VertexId>> link(const Complex<D>& k, std::span<const VertexId> simplex) {
  std::vector<std::vector<VertexId>> opposite;
  if (simplex.empty() || simplex.size() > D || simplex[0].value >= k.vertex_count())
    return opposite;
  for (const CornerId corner : star(k, simplex[0])) {
    std::vector<VertexId> rest;
    for (const VertexId vertex : k.vertices(cell_of<D>(corner)))
      if (std::find(simplex.begin(), simplex.end(), vertex) == simplex.end())
        rest.push_back(vertex);
    if (rest.size() + simplex.size() != D + 1) continue;  // the cell lacks a vertex of `simplex`
    std::sort(rest.begin(), rest.end());
    opposite.push_back(std::move(rest));
  }
  std::sort(opposite.begin(), opposite.end());
  return opposite;
}

template class Simplices<1>;
template class Simplices<2>;
template class Simplices<3>;
template class Simplices<4>;

template std::optional<FoundHalfFacet> find_half_facet(const Complex<1>&, const Facet<1>&, int);
template std::optional<FoundHalfFacet> find_half_facet(const Complex<2>&, const Facet<2>&, int);
template std::optional<FoundHalfFacet> find_half_facet(const Complex<3>&, const Facet<3>&, int);
template std::optional<FoundHalfFacet> find_half_facet(const Complex<4>&, const Facet<4>&, int);

template std::vector<std::vector<VertexId>> link(const Complex<1>&, std::span<const VertexId>);
template std::vector<std::vector<VertexId>> link(const Complex<2>&, std::span<const VertexId>);
template std::vector<std::vector<VertexId>> link(const Complex<3>&, std::span<const VertexId>);
template std::vector<std::vector<VertexId>> link(const Complex<4>&, std::span<const VertexId>);

}  // namespace cleave::topology
