#pragma once
#include <algorithm>
#include <cstddef>
#include <set>
#include <vector>

#include "cleave/cutting/predicates.hpp"
#include "cleave/cutting/sweep.hpp"

namespace cleave::cutting {

/// The faces of codimension 1 that an odd number of simplices have: where the sweep ends.
template <int D>
std::vector<std::vector<Point<D>>> rim(const Sweep<D>& sweep) {
  std::set<std::vector<Point<D>>> odd;
  for (const auto& simplex : sweep.simplices)
    for (std::size_t left_out = 0; left_out < simplex.size(); ++left_out) {
      std::vector<Point<D>> face;
      for (std::size_t i = 0; i < simplex.size(); ++i)
        if (i != left_out) face.push_back(simplex[i]);
      std::sort(face.begin(), face.end());
      if (!odd.insert(face).second) odd.erase(face);
    }
  return {odd.begin(), odd.end()};
}

template <int D>
Box<D> box_around(const std::vector<Point<D>>& points, double margin) {
  Box<D> box{points.front(), points.front()};
  for (const Point<D>& p : points)
    for (std::size_t i = 0; i < p.size(); ++i) {
      box.low[i] = std::min(box.low[i], p[i] - margin);
      box.high[i] = std::max(box.high[i], p[i] + margin);
    }
  return box;
}

template <int D>
bool disjoint(const Box<D>& a, const Box<D>& b) {
  for (std::size_t i = 0; i < a.low.size(); ++i)
    if (a.high[i] < b.low[i] || b.high[i] < a.low[i]) return true;
  return false;
}

}  // namespace cleave::cutting
