#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "bodies.hpp"
#include "cleave/cutting/predicates.hpp"
#include "cleave/cutting/select.hpp"
#include "properties.hpp"
#include "rational.hpp"

/// Theorem A (proofs/nearest_vertex.v, theoremA_cell, theoremA_by_id): why nearest-vertex separates
/// along a plane. Farthest vertices are found in rational numbers.
namespace cleave::cutting {
namespace {

using bodies::Body;
using bodies::Rng;
using topology::CellId;
using topology::FacetSet;
using topology::HalfFacetId;
using topology::VertexId;

/// A simplex about a hundred times as large as the body, in the plane of some of its vertices and
/// dual points; none if an edge that crosses that plane passes it by.
template <int D>
std::optional<rational::Simplex<D>> any_plane(const Body<D>& body, Rng& rng) {
  std::vector<Point<D>> places = bodies::duals(body);
  places.insert(places.end(), body.points.begin(), body.points.end());
  rational::Simplex<D> plane;
  Point<D> middle{};
  for (Point<D>& corner : plane) {
    corner = places[rng.below(places.size())];
    for (std::size_t i = 0; i < corner.size(); ++i) middle[i] += corner[i] / D;
  }
  for (Point<D>& corner : plane)
    for (std::size_t i = 0; i < corner.size(); ++i)
      corner[i] = middle[i] + 128 * (corner[i] - middle[i]);
  const SweptSimplex<D> simplex(plane);
  if (simplex.is_flat()) return std::nullopt;
  for (const topology::Cell<D>& cell : body.k.cells())
    for (const VertexId v : cell)
      for (const VertexId w : cell) {
        const Point<D>&p = body.points[v.value], &q = body.points[w.value];
        if (simplex.side(p) != simplex.side(q) && !simplex.crossed_between_sides(p, q))
          return std::nullopt;
      }
  return plane;
}

/// The side of the vertex farthest from the plane; of those as far, of the one with the largest id.
template <int D>
int far_side(const rational::Simplex<D>& plane, const std::vector<Point<D>>& points,
             std::span<const VertexId> vertices) {
  const auto closer = [&](VertexId v, VertexId w) {
    const int order = rational::compare_heights<D>(plane, points[v.value], points[w.value]);
    return order != 0 ? order < 0 : v < w;
  };
  const VertexId farthest = *std::max_element(vertices.begin(), vertices.end(), closer);
  return rational::side<D>(plane, points[farthest.value]);
}

template <int D>
void cells_choose_facets_of_the_other_label() {
  Rng rng = any_rng();
  std::array<int, static_cast<std::size_t>(D)> nodes;
  for (int& n : nodes) n = rng.between(2, D == 2 ? 7 : 4);
  // Cells of all shapes, inverted ones too: the theorem asks nothing of them.
  const Body<D> body =
      rng.chance(0.5) ? bodies::any_small<D>(rng) : bodies::jittered<D>(nodes, 0.1, 0.8, rng);
  std::optional<rational::Simplex<D>> plane;
  for (int n = 0; n < 50 && !plane; ++n) plane = any_plane(body, rng);
  RC_PRE(plane.has_value());
  const std::array<rational::Simplex<D>, 1> sweep{*plane};
  const FacetSet chosen =
      Selector<D>(body.k, body.points, {Rule::nearest_vertex, Ties::by_id}).select(sweep);

  std::vector<int> label;
  for (const topology::Cell<D>& cell : body.k.cells())
    label.push_back(far_side<D>(*plane, body.points, cell));
  std::size_t folds = 0;
  for (topology::Index c = 0; c < body.k.cell_count(); ++c) {
    const topology::Cell<D>& cell = body.k.vertices(CellId{c});
    std::array<Point<D>, D + 1> places;
    for (std::size_t i = 0; i < places.size(); ++i) places[i] = body.points[cell[i].value];
    const auto nearest = nearest_vertices<D>(cell, places, sweep, Ties::by_id);
    for (int i = 0; i <= D; ++i) {
      std::array<bool, D + 1> all_but_i;
      all_but_i.fill(true);
      all_but_i[static_cast<std::size_t>(i)] = false;
      std::vector<VertexId> facet(cell.begin(), cell.end());
      facet.erase(facet.begin() + i);
      const bool differ = label[c] != far_side<D>(*plane, body.points, facet);
      RC_ASSERT((nearest == all_but_i) == differ);

      const HalfFacetId h = topology::half_facet<D>(CellId{c}, i);
      const auto mate = body.k.mate(h);
      if (!mate || *mate < h) continue;
      const bool between = label[c] != label[topology::cell_of<D>(*mate).value];
      RC_ASSERT(chosen.contains(h) || !between);
      folds += chosen.contains(h) && !between ? 1u : 0u;
    }
  }
  RC_CLASSIFY(chosen.empty(), "nothing chosen");
  RC_CLASSIFY(folds > 0, "a facet is chosen from both sides");
}

RC_GTEST_PROP(TheoremAProperty, CellsChooseFacetsOfTheOtherLabelInThePlane, ()) {
  cells_choose_facets_of_the_other_label<2>();
}
RC_GTEST_PROP(TheoremAProperty, CellsChooseFacetsOfTheOtherLabelInSpace, ()) {
  cells_choose_facets_of_the_other_label<3>();
}

}  // namespace
}  // namespace cleave::cutting
