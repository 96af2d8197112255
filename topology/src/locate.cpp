#include "cleave/topology/locate.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <unordered_map>

#include "cleave/topology/cell_soup.hpp"

namespace cleave::topology {
namespace {

constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15u;  // 2^64 over the golden ratio

/// A set of vertices that may answer yes for a vertex it does not hold, never no for one it holds.
/// Spares the hash most facets of a mesh, whatever the numbers of the vertices are.
class VertexSieve {
 public:
  explicit VertexSieve(std::size_t expected)
      : shift_(64 - static_cast<int>(std::bit_width(16 * expected + 64))),
        bits_(std::size_t{1} << (64 - shift_)) {}
  void insert(VertexId vertex) { bits_[slot(vertex)] = true; }
  bool may_contain(VertexId vertex) const { return bits_[slot(vertex)]; }

 private:
  std::size_t slot(VertexId vertex) const { return (vertex.value * kGolden) >> shift_; }

  int shift_;
  std::vector<bool> bits_;
};

template <int D>
struct FacetHash {
  std::size_t operator()(const Facet<D>& facet) const {
    std::uint64_t hash = 0;
    for (const VertexId vertex : facet) hash = (std::rotl(hash, 23) ^ vertex.value) * kGolden;
    return hash ^ (hash >> 32);
  }
};

template <int D>
Facet<D> ascending(Facet<D> facet) {
  std::sort(facet.begin(), facet.end());
  return facet;
}

}  // namespace

template <int D>
std::vector<std::optional<HalfFacetId>> locate_facets(std::span<const Cell<D>> cells,
                                                      std::span<const Facet<D>> facets) {
  require_ids_suffice(D, cells.size(), 0);
  using Least = std::optional<HalfFacetId>;
  std::unordered_map<Facet<D>, Least, FacetHash<D>> least(facets.size());
  VertexSieve sieve(facets.size() * D);
  for (const Facet<D>& facet : facets) {
    least.try_emplace(ascending<D>(facet));
    for (const VertexId vertex : facet) sieve.insert(vertex);
  }

  for (Index c = 0; c < cells.size(); ++c) {
    std::array<bool, D + 1> known{};
    int unknown = 0;
    for (std::size_t i = 0; i <= D; ++i) {
      known[i] = sieve.may_contain(cells[c][i]);
      unknown += known[i] ? 0 : 1;
    }
    if (unknown > 1) continue;  // each facet of the cell lacks one vertex only
    for (std::size_t i = 0; i <= D; ++i) {
      if (unknown == 1 && known[i]) continue;
      Facet<D> facet{};
      for (std::size_t from = 0, to = 0; from <= D; ++from)
        if (from != i) facet[to++] = cells[c][from];
      const auto found = least.find(ascending<D>(facet));
      if (found != least.end() && !found->second)
        found->second = half_facet<D>({c}, static_cast<int>(i));
    }
  }

  std::vector<Least> located;
  located.reserve(facets.size());
  for (const Facet<D>& facet : facets) located.push_back(least.at(ascending<D>(facet)));
  return located;
}

template std::vector<std::optional<HalfFacetId>> locate_facets<1>(std::span<const Cell<1>>,
                                                                  std::span<const Facet<1>>);
template std::vector<std::optional<HalfFacetId>> locate_facets<2>(std::span<const Cell<2>>,
                                                                  std::span<const Facet<2>>);
template std::vector<std::optional<HalfFacetId>> locate_facets<3>(std::span<const Cell<3>>,
                                                                  std::span<const Facet<3>>);
template std::vector<std::optional<HalfFacetId>> locate_facets<4>(std::span<const Cell<4>>,
                                                                  std::span<const Facet<4>>);

}  // namespace cleave::topology
