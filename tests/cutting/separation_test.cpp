#include <gtest/gtest.h>

#include <cstdio>
#include <ostream>

#include "bodies.hpp"
#include "cleave/topology/pieces.hpp"
#include "cleave/topology/unglue.hpp"

namespace cleave::cutting {
namespace {

using bodies::Body;
using topology::Complex;

/// Planes normal . x = offset (in spacings), from `first` to `last` in steps of one.
struct Planes {
  const char* name;
  std::array<int, 3> normal;
  double first, last;
};

/// How many sweeps separated the body, and of how many.
struct Count {
  int separated = 0, of = 0;
  Count& operator+=(bool separates) {
    separated += separates ? 1 : 0;
    ++of;
    return *this;
  }
  friend bool operator==(const Count&, const Count&) = default;
  friend std::ostream& operator<<(std::ostream& out, const Count& count) {
    return out << count.separated << " of " << count.of;
  }
};

/// Cuts along all of `sweep` as one step.
bool separates(const Body<3>& body, const Sweep<3>& sweep, SelectOptions options) {
  Complex<3> cut = body.k;
  topology::unglue(cut, Selector<3>(body.k, body.points, options).select(sweep.simplices));
  return topology::pieces(cut).count >= 2;
}

Count separating(const Body<3>& body, const Planes& planes, SelectOptions options) {
  Count count;
  for (double offset = planes.first; offset <= planes.last; ++offset)
    count += separates(body, bodies::aligned_plane<3>(body, planes.normal, offset), options);
  return count;
}

constexpr std::array<Planes, 7> kFamilies{{{"faces: x = i", {1, 0, 0}, 1, 5},
                                           {"middles: x = i + 1/2", {1, 0, 0}, 0.5, 5.5},
                                           {"diagonal faces: x - y = i", {1, -1, 0}, -5, 5},
                                           {"diagonal middles", {1, -1, 0}, -4.5, 4.5},
                                           {"vertices: x + y = i", {1, 1, 0}, 1, 11},
                                           {"vertices: x + y + z = i", {1, 1, 1}, 2, 16},
                                           {"middles: x + y + z = i + 1/2", {1, 1, 1}, 1.5, 15.5}}};

struct Expected {
  Count dual_edge, by_id, both;
};

/// Counts and prints a row per family. The table of docs/selection.md.
void expect_table(double spacing, const std::array<Expected, kFamilies.size()>& expected) {
  const Body<3> body = bodies::kuhn<3>({7, 7, 7}, spacing);
  for (std::size_t i = 0; i < kFamilies.size(); ++i) {
    const Count dual_edge = separating(body, kFamilies[i], {Rule::dual_edge, Ties::by_id});
    const Count by_id = separating(body, kFamilies[i], {Rule::nearest_vertex, Ties::by_id});
    const Count both = separating(body, kFamilies[i], {Rule::nearest_vertex, Ties::both});
    std::printf("spacing %g, %-28s of %2d planes: dual-edge %2d, by id %2d, both %2d\n", spacing,
                kFamilies[i].name, dual_edge.of, dual_edge.separated, by_id.separated,
                both.separated);
    EXPECT_EQ(dual_edge, expected[i].dual_edge) << kFamilies[i].name;
    EXPECT_EQ(by_id, expected[i].by_id) << kFamilies[i].name;
    EXPECT_EQ(both, expected[i].both) << kFamilies[i].name;
  }
}

// Each of these planes has dual points on both sides, so dual-edge must separate along all of them.
// On a grid whose coordinates are exact, all ties are.
TEST(AlignedPlanes, OfAnIntegerGrid) {
  expect_table(1, {{{{5, 5}, {5, 5}, {5, 5}},
                    {{6, 6}, {5, 6}, {0, 6}},
                    {{11, 11}, {11, 11}, {11, 11}},
                    {{10, 10}, {10, 10}, {0, 10}},
                    {{11, 11}, {10, 11}, {0, 11}},
                    {{15, 15}, {15, 15}, {15, 15}},
                    {{15, 15}, {14, 15}, {0, 15}}}});
}

// Of coordinates that are multiples of 0.1, rounding breaks some ties and makes others.
TEST(AlignedPlanes, OfADecimalGrid) {
  expect_table(0.1, {{{{5, 5}, {5, 5}, {5, 5}},
                      {{6, 6}, {5, 6}, {2, 6}},
                      {{11, 11}, {11, 11}, {11, 11}},
                      {{10, 10}, {10, 10}, {7, 10}},
                      {{11, 11}, {11, 11}, {10, 11}},
                      {{15, 15}, {15, 15}, {15, 15}},
                      {{15, 15}, {15, 15}, {15, 15}}}});
}

// Sheets that cross the body with folds, on grids with all points moved at random.
TEST(BentSweeps, DualEdgeSeparatesAlongAllNearestVertexAlongSome) {
  bodies::Rng rng(2000);
  Count dual_edge, by_id;
  for (int run = 0; run < 100; ++run) {
    const Body<3> body = bodies::jittered<3>({7, 7, 7}, 0.1, 0.2, rng);
    const Sweep<3> sweep = bodies::full_crossing(body, rng);
    dual_edge += separates(body, sweep, {Rule::dual_edge, Ties::by_id});
    by_id += separates(body, sweep, {Rule::nearest_vertex, Ties::by_id});
  }
  std::printf("100 bent sweeps: dual-edge %d, nearest-vertex %d\n", dual_edge.separated,
              by_id.separated);
  EXPECT_EQ(dual_edge, (Count{100, 100}));
  EXPECT_EQ(by_id, (Count{71, 100}));
}

}  // namespace
}  // namespace cleave::cutting
