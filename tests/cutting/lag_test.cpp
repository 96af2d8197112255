// How far a cut stays behind the blade, and beside it, in lengths of an edge: section 3 of the
// paper says that the cut surface is close to the sweep, and that the incision lags behind the
// scalpel.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "bodies.hpp"
#include "cleave/cutting/stroke.hpp"

namespace cleave::cutting {
namespace {

using bodies::Body;

constexpr int kEdges = 8;  // along each axis, all of length 1 before they are disturbed

struct Distances {
  double lag = 0, most_lag = 0;        // behind the blade, mean and most
  double beside = 0, most_beside = 0;  // from vertices of opened facets to the blade's plane
};

/// A blade that stands upright is led through a disturbed grid, in steps of a quarter of an edge
/// along y, on a plane that is aligned with none of the grid's. After each step the incision ends,
/// at each height, with its foremost vertex.
Distances measured(Rule rule) {
  bodies::Rng rng(2000);
  Distances result;
  int fronts = 0, vertices = 0;
  for (int run = 0; run < 5; ++run) {
    const Body<3> body = bodies::jittered<3>({kEdges + 1, kEdges + 1, kEdges + 1}, 1, 0.2, rng);
    for (double reached = 2; reached <= 6; reached += 0.5) {
      std::vector<std::array<Point<3>, 2>> positions;
      for (double y = -1; y <= reached; y += 0.25)
        positions.push_back({{{2.3 + y / 2, y, -1}, {2.3 + y / 2, y, kEdges + 1.0}}});
      topology::Incision<3> incision(body.k);
      std::vector<Point<3>> points = body.points;
      cut_along(incision, points, sweep_of_blade(positions), {rule, Ties::by_id});
      std::array<double, kEdges> front;
      front.fill(-1);
      for (const topology::OpenedFacet& facet : incision.opened()) {
        double height = 0, foremost = -1;
        for (const topology::VertexId v : body.k.facet(facet.half_facet)) {
          const Point<3>& p = body.points[v.value];
          height += p[2] / 3;
          foremost = std::max(foremost, p[1]);
          const double beside = std::abs(p[0] - 2.3 - p[1] / 2) / std::sqrt(1.25);
          result.beside += beside;
          result.most_beside = std::max(result.most_beside, beside);
          ++vertices;
        }
        const int slab = std::clamp(static_cast<int>(height), 0, kEdges - 1);
        double& at = front[static_cast<std::size_t>(slab)];
        at = std::max(at, foremost);
      }
      for (const double y : front) {
        result.lag += reached - y;
        result.most_lag = std::max(result.most_lag, reached - y);
        ++fronts;
      }
    }
  }
  result.lag /= fronts;
  result.beside /= vertices;
  return result;
}

TEST(CutAndBlade, StayCloseToEachOther) {
  for (const Rule rule : {Rule::dual_edge, Rule::nearest_vertex}) {
    const Distances d = measured(rule);
    std::printf("%s: behind %.2f, at most %.2f; beside %.2f, at most %.2f\n",
                rule == Rule::dual_edge ? "dual-edge" : "nearest-vertex", d.lag, d.most_lag,
                d.beside, d.most_beside);
    EXPECT_GT(d.lag, 0);
    EXPECT_LT(d.most_lag, 1.5);
    EXPECT_LT(d.most_beside, 1);
  }
}

}  // namespace
}  // namespace cleave::cutting
