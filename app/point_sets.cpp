#include "point_sets.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cleave::app {
namespace {

using Point = std::array<double, 3>;

// Points in the same box of a grid; boxes are so small that such points are close.
struct Box {
  std::array<double, 3> key;  // whole numbers, as far as doubles have them
  std::size_t begin, end;     // in the list of places sorted by box
};

Point key_of(const Point& p, double side) {
  if (side == 0) return {p[0] + 0.0, p[1] + 0.0, p[2] + 0.0};  // -0 is 0
  return {std::floor(p[0] / side), std::floor(p[1] / side), std::floor(p[2] / side)};
}

class Sets {
 public:
  explicit Sets(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0u); }
  std::size_t find(std::size_t a) {
    while (parent_[a] != a) a = parent_[a] = parent_[parent_[a]];
    return a;
  }
  void join(std::size_t a, std::size_t b) { parent_[find(a)] = find(b); }

 private:
  std::vector<std::size_t> parent_;
};

bool close(const Point& a, const Point& b, double distance) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) <= distance;
}

// Joins boxes that have points within `distance` of each other. Boxes are sorted by key.
void join_neighbours(const std::vector<Box>& boxes, const std::vector<Point>& sorted,
                     double distance, Sets& sets) {
  const auto less = [](const Box& box, const Point& key) { return box.key < key; };
  for (std::size_t b = 0; b < boxes.size(); ++b)
    for (int x = 0; x <= 2; ++x)
      for (int y = -2; y <= 2; ++y) {
        // All boxes of this row that may be near, of which those before b have had their turn.
        const Point low = {boxes[b].key[0] + x, boxes[b].key[1] + y, boxes[b].key[2] - 2};
        auto other = std::lower_bound(boxes.begin(), boxes.end(), low, less);
        for (; other != boxes.end() && other->key[0] == low[0] && other->key[1] == low[1] &&
               other->key[2] <= low[2] + 4;
             ++other) {
          const auto o = static_cast<std::size_t>(other - boxes.begin());
          if (o <= b || sets.find(o) == sets.find(b)) continue;
          const auto near = [&] {
            for (std::size_t i = boxes[b].begin; i < boxes[b].end; ++i)
              for (std::size_t j = other->begin; j < other->end; ++j)
                if (close(sorted[i], sorted[j], distance)) return true;
            return false;
          };
          if (near()) sets.join(o, b);
        }
      }
}

}  // namespace

std::vector<std::vector<Index>> close_points(const std::vector<Point>& points,
                                             const std::vector<Index>& places, double distance) {
  const double side = distance / 1.75;  // a box's diagonal, the root of 3 times that, is shorter
  std::vector<std::pair<Point, Index>> keyed;
  keyed.reserve(places.size());
  for (const Index place : places) keyed.emplace_back(key_of(points[place], side), place);
  std::sort(keyed.begin(), keyed.end());
  std::vector<Box> boxes;
  std::vector<Point> sorted;
  for (std::size_t i = 0; i < keyed.size(); ++i) {
    if (i == 0 || keyed[i].first != keyed[i - 1].first) boxes.push_back({keyed[i].first, i, i});
    boxes.back().end = i + 1;
    if (distance > 0) sorted.push_back(points[keyed[i].second]);
  }
  Sets sets(boxes.size());
  if (distance > 0) join_neighbours(boxes, sorted, distance, sets);

  std::vector<std::vector<Index>> by_root(boxes.size());
  for (std::size_t b = 0; b < boxes.size(); ++b)
    for (std::size_t i = boxes[b].begin; i < boxes[b].end; ++i)
      by_root[sets.find(b)].push_back(keyed[i].second);
  std::vector<std::vector<Index>> together;
  for (auto& set : by_root) {
    if (set.size() < 2) continue;
    std::sort(set.begin(), set.end());
    together.push_back(std::move(set));
  }
  std::sort(together.begin(), together.end());
  return together;
}

}  // namespace cleave::app
