#include "record_origin.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace cleave::app {

Origins::Origins(std::vector<Index> of_points, std::size_t places)
    : of(std::move(of_points)), first(places, kNoPlace) {
  for (Index point = 0; point < of.size(); ++point)
    if (first[of[point]] == kNoPlace) first[of[point]] = point;
}

std::vector<Periodicity> without_copies(const std::vector<Periodicity>& periodic,
                                        const Origins& origins) {
  std::vector<Periodicity> result;
  for (const Periodicity& condition : periodic) {
    Periodicity& mapped = result.emplace_back(condition);
    mapped.pairs.clear();
    std::set<std::pair<Index, Index>> seen;
    for (const auto& pair : condition.pairs) {
      const Periodicity::Pair original{origins.of[pair.vertex], origins.of[pair.master]};
      if (seen.emplace(original.vertex, original.master).second) mapped.pairs.push_back(original);
    }
  }
  return result;
}

bool same_pairs(const std::vector<Periodicity>& a, const std::vector<Periodicity>& b) {
  const auto same_pair = [](const Periodicity::Pair& p, const Periodicity::Pair& q) {
    return p.vertex == q.vertex && p.master == q.master;
  };
  const auto same = [&](const Periodicity& p, const Periodicity& q) {
    return p.dimension == q.dimension && p.entity == q.entity && p.master == q.master &&
           p.affine == q.affine &&
           std::equal(p.pairs.begin(), p.pairs.end(), q.pairs.begin(), q.pairs.end(), same_pair);
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

}  // namespace cleave::app
