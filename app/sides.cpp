#include "sides.hpp"

#include <algorithm>
#include <deque>
#include <numeric>

#include "mesh.hpp"

namespace cleave::app {

using topology::Complex;
using topology::HalfFacetId;
using topology::VertexId;

namespace {

// One of the ridges of a facet, seen from the facet's lesser half-facet.
template <int D>
struct RidgeSide {
  std::array<VertexId, static_cast<std::size_t>(D - 1)> ridge;  // ascending
  Index facet;                                                  // place among the facets
  int sign;  // orientation that the half-facet's orientation induces on the ascending ridge

  friend bool operator<(const RidgeSide& a, const RidgeSide& b) {
    return a.ridge != b.ridge ? a.ridge < b.ridge : a.facet < b.facet;
  }
};

// A facet on the other side of a ridge of exactly two. `same`: the lesser half-facets of both lie
// on the same side of the sheet, which is so when they induce opposite orientations on the ridge.
struct Neighbour {
  Index facet;
  bool same;
};

// Sorts `tuple` ascending and returns the parity of that.
template <std::size_t N>
int sort_with_parity(std::array<VertexId, N>& tuple) {
  int parity = 1;
  for (std::size_t i = 1; i < N; ++i)
    for (std::size_t j = i; j > 0 && tuple[j] < tuple[j - 1]; --j) {
      std::swap(tuple[j], tuple[j - 1]);
      parity = -parity;
    }
  return parity;
}

template <int D>
std::vector<std::vector<Neighbour>> neighbours(const Complex<D>& k,
                                               std::span<const HalfFacetId> facets) {
  std::vector<std::vector<Neighbour>> next(facets.size());
  if constexpr (D >= 2) {
    std::vector<RidgeSide<D>> sides;
    for (Index f = 0; f < facets.size(); ++f) {
      auto tuple = k.facet(facets[f]);
      int sign = sort_with_parity(tuple) * k.facet_sign(facets[f]);
      for (std::size_t left_out = 0; left_out < tuple.size(); ++left_out, sign = -sign) {
        RidgeSide<D> side{{}, f, sign};
        for (std::size_t from = 0, to = 0; from < tuple.size(); ++from)
          if (from != left_out) side.ridge[to++] = tuple[from];
        sides.push_back(side);
      }
    }
    std::sort(sides.begin(), sides.end());
    for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
      while (last < sides.size() && sides[last].ridge == sides[first].ridge) ++last;
      if (last - first != 2) continue;
      const auto &a = sides[first], &b = sides[first + 1];
      next[a.facet].push_back({b.facet, a.sign != b.sign});
      next[b.facet].push_back({a.facet, a.sign != b.sign});
    }
  }
  return next;
}

// The facets from `one` up to the flood's common root and down to `other`: with the ridge between
// these two, a closed loop.
std::vector<Index> loop_between(Index one, Index other, const std::vector<Index>& reached_from) {
  const auto path_to_root = [&](Index f) {
    std::vector<Index> path{f};
    for (; reached_from[f] != f; f = reached_from[f]) path.push_back(reached_from[f]);
    return path;
  };
  auto up = path_to_root(one), down = path_to_root(other);
  while (up.size() > 1 && down.size() > 1 && up[up.size() - 2] == down[down.size() - 2]) {
    up.pop_back();
    down.pop_back();
  }
  down.pop_back();  // the root of the loop is in `up`
  up.insert(up.end(), down.rbegin(), down.rend());
  return up;
}

}  // namespace

template <int D>
Sides choose_sides(const Complex<D>& k, std::span<const HalfFacetId> facets,
                   std::span<const HalfFacetId> preferred) {
  const auto next = neighbours(k, facets);
  constexpr Index kNotYet = topology::kNoIndex;
  std::vector<Index> reached_from(facets.size(), kNotYet);
  std::vector<bool> lesser_is_minus(facets.size());
  Sides sides;
  for (Index start = 0; start < facets.size(); ++start) {
    if (reached_from[start] != kNotYet) continue;
    reached_from[start] = start;
    lesser_is_minus[start] = preferred[start] == facets[start];
    bool two_sided = true;
    for (std::deque<Index> flood{start}; !flood.empty(); flood.pop_front()) {
      const Index at = flood.front();
      for (const Neighbour& n : next[at]) {
        const bool minus = lesser_is_minus[at] == n.same;
        if (reached_from[n.facet] == kNotYet) {
          reached_from[n.facet] = at;
          lesser_is_minus[n.facet] = minus;
          flood.push_back(n.facet);
        } else if (two_sided && lesser_is_minus[n.facet] != minus) {
          two_sided = false;
          auto& loop = sides.one_sided.emplace_back();
          for (const Index f : loop_between(at, n.facet, reached_from)) loop.push_back(facets[f]);
        }
      }
    }
  }
  for (Index f = 0; f < facets.size(); ++f)
    sides.minus.push_back(lesser_is_minus[f] ? facets[f] : *k.mate(facets[f]));
  return sides;
}

template Sides choose_sides<1>(const Complex<1>&, std::span<const HalfFacetId>,
                               std::span<const HalfFacetId>);
template Sides choose_sides<2>(const Complex<2>&, std::span<const HalfFacetId>,
                               std::span<const HalfFacetId>);
template Sides choose_sides<3>(const Complex<3>&, std::span<const HalfFacetId>,
                               std::span<const HalfFacetId>);

}  // namespace cleave::app
