#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "bodies.hpp"
#include "cleave/cutting/predicates.hpp"
#include "cleave/cutting/select.hpp"
#include "properties.hpp"
#include "rational.hpp"
#include "rim.hpp"

/// The hypothesis of Theorem B (proofs/dual_edge.v), for the predicate that the library runs: the
/// three sides of a triangle cross a sweep an odd number of times in all iff the rim of the sweep
/// passes through the triangle an odd number of times. And what the theorem makes of it.
namespace cleave::cutting {
namespace {

using bodies::Body;
using bodies::Rng;
using topology::CellId;
using topology::FacetSet;
using topology::HalfFacetId;

template <int D>
using Triangle = std::array<Point<D>, 3>;
template <int D>
using Face = std::vector<Point<D>>;

/// Whether the segment pq crosses an odd number of the simplices, as Selector decides it.
template <int D>
bool crosses(const Sweep<D>& sweep, const Point<D>& p, const Point<D>& q) {
  bool odd = false;
  for (const auto& corners : sweep.simplices)
    if (const SweptSimplex<D> simplex(corners); !simplex.is_flat() && simplex.crossed_by(p, q))
      odd = !odd;
  return odd;
}

/// The same in rational numbers.
template <int D>
bool crosses_rationally(const Sweep<D>& sweep, const Point<D>& p, const Point<D>& q) {
  bool odd = false;
  for (const auto& corners : sweep.simplices)
    if (!rational::is_flat<D>(corners) && rational::crosses<D>(corners, p, q)) odd = !odd;
  return odd;
}

template <std::size_t N>
std::array<double, N> mirrored(std::array<double, N> p) {
  for (double& x : p) x = -x;
  return p;
}

/// Whether a face of the rim, translated as the sweep is, passes through the triangle, in rational
/// numbers. Mirrored in the origin it is the triangle that is translated.
bool passes_through(const Face<3>& face, const Triangle<3>& triangle) {
  const Triangle<3> mirror{mirrored(triangle[0]), mirrored(triangle[1]), mirrored(triangle[2])};
  return !rational::is_flat<3>(mirror) &&
         rational::crosses<3>(mirror, mirrored(face[0]), mirrored(face[1]));
}

bool passes_through(const Face<2>& face, const Triangle<2>& triangle) {
  std::array<int, 3> sides;
  for (std::size_t i = 0; i < 3; ++i)
    sides[i] = rational::side<2>({mirrored(triangle[i]), mirrored(triangle[(i + 1) % 3])},
                                 mirrored(face[0]));
  return sides[0] != 0 && sides[0] == sides[1] && sides[1] == sides[2];
}

template <int D>
bool rim_passes_through(const std::vector<Face<D>>& rim, const Triangle<D>& triangle) {
  const Box<D> box = box_around<D>({triangle.begin(), triangle.end()}, 0);
  bool odd = false;
  for (const Face<D>& face : rim)
    if (!disjoint(box, box_around<D>(face, 0)) && passes_through(face, triangle)) odd = !odd;
  return odd;
}

template <int D>
void sides_of_triangles_cross_as_the_rim_does() {
  Rng rng = any_rng();
  const Body<D> body = bodies::any_small<D>(rng);
  const Sweep<D> sweep = bodies::any_sweep(body, rng);
  const auto ends = rim(sweep);
  std::vector<Point<D>> places = bodies::duals(body);
  places.insert(places.end(), body.points.begin(), body.points.end());
  int odd = 0, even = 0;  // triangles with a side that crosses
  for (int n = 0; n < 40; ++n) {
    Triangle<D> t;
    for (Point<D>& p : t) p = places[rng.below(places.size())];
    bool any = false, parity = false;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point<D>&p = t[i], &q = t[(i + 1) % 3];
      const bool across = crosses(sweep, p, q);
      RC_ASSERT(across == crosses(sweep, q, p));
      RC_ASSERT(across == crosses_rationally(sweep, p, q));
      any = any || across;
      parity = parity != across;
    }
    RC_ASSERT(parity == rim_passes_through<D>(ends, t));
    (parity ? odd : even) += any ? 1 : 0;
  }
  RC_CLASSIFY(odd > 0, "the rim passes through a triangle");
  RC_CLASSIFY(even > 0, "the sweep crosses a triangle, the rim does not");
}

RC_GTEST_PROP(TheoremBProperty, SidesOfTrianglesCrossAsTheRimDoesInThePlane, ()) {
  sides_of_triangles_cross_as_the_rim_does<2>();
}
RC_GTEST_PROP(TheoremBProperty, SidesOfTrianglesCrossAsTheRimDoesInSpace, ()) {
  sides_of_triangles_cross_as_the_rim_does<3>();
}

/// The half-facets through which one leaves the cells around a ridge one after the other, from
/// `first` on; the ridge is the facet `first` without the local vertex `other` of its cell. None if
/// that way ends at the boundary.
template <int D>
std::optional<std::vector<HalfFacetId>> dual_loop(const topology::Complex<D>& k, HalfFacetId first,
                                                  int other) {
  std::vector<HalfFacetId> loop;
  HalfFacetId leaving = first;
  do {
    loop.push_back(leaving);
    const std::optional<HalfFacetId> mate = k.mate(leaving);
    if (!mate) return std::nullopt;
    const auto& from = k.vertices(topology::cell_of<D>(leaving));
    const auto& to = k.vertices(topology::cell_of<D>(*mate));
    const auto at = std::find(to.begin(), to.end(), from[static_cast<std::size_t>(other)]);
    other = topology::local_index<D>(*mate);
    leaving =
        topology::half_facet<D>(topology::cell_of<D>(*mate), static_cast<int>(at - to.begin()));
  } while (leaving != first);
  return loop;
}

/// All loops, each from its least cell, in one of the two directions.
template <int D>
std::vector<std::vector<HalfFacetId>> dual_loops(const topology::Complex<D>& k) {
  std::vector<std::vector<HalfFacetId>> loops;
  for (topology::Index c = 0; c < k.cell_count(); ++c)
    for (int i = 0; i <= D; ++i)
      for (int other = 0; other < i; ++other) {
        const HalfFacetId first = topology::half_facet<D>(CellId{c}, i);
        auto loop = dual_loop(k, first, other);
        const auto cell_before = [](HalfFacetId a, HalfFacetId b) {
          return topology::cell_of<D>(a) < topology::cell_of<D>(b);
        };
        if (loop && *std::min_element(loop->begin(), loop->end(), cell_before) == first)
          loops.push_back(std::move(*loop));
      }
  return loops;
}

// theoremB_degree, theoremB_even: around a ridge inside the body an odd number of facets is chosen
// iff the rim passes an odd number of times through the fan that the dual point of one cell spans
// with the dual edges of the others.
template <int D>
void ridges_are_odd_where_the_rim_passes() {
  Rng rng = any_rng();
  const Body<D> body = bodies::any_small<D>(rng);
  const Sweep<D> sweep = bodies::any_sweep(body, rng);
  const FacetSet chosen = Selector<D>(body.k, body.points).select(sweep.simplices);
  const auto ends = rim(sweep);
  const std::vector<Point<D>> duals = bodies::duals(body);
  int odd = 0, even = 0;
  for (const std::vector<HalfFacetId>& loop : dual_loops(body.k)) {
    const auto dual = [&](std::size_t i) {
      return duals[topology::cell_of<D>(loop[i % loop.size()]).value];
    };
    std::size_t degree = 0;
    bool passes = false;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      degree += chosen.contains(std::min(loop[i], *body.k.mate(loop[i]))) ? 1u : 0u;
      if (rim_passes_through<D>(ends, {dual(0), dual(i), dual(i + 1)})) passes = !passes;
    }
    RC_ASSERT((degree % 2 == 1) == passes);
    if (degree > 0) ++(passes ? odd : even);
  }
  RC_CLASSIFY(odd > 0, "the rim passes around a ridge");
  RC_CLASSIFY(even > 0, "chosen facets around a ridge off the rim");
}

RC_GTEST_PROP(TheoremBProperty, RidgesAreOddWhereTheRimPassesInThePlane, ()) {
  ridges_are_odd_where_the_rim_passes<2>();
}
RC_GTEST_PROP(TheoremBProperty, RidgesAreOddWhereTheRimPassesInSpace, ()) {
  ridges_are_odd_where_the_rim_passes<3>();
}

// theoremB_no_rim: with the rim outside a convex body, the chosen facets are those between the
// cells that any one dual point sees through the sweep an odd number of times, and the others.
template <int D>
void full_crossings_choose_what_a_dual_point_sees() {
  Rng rng = any_rng();
  std::array<int, static_cast<std::size_t>(D)> nodes;
  for (int& n : nodes) n = rng.between(2, D == 2 ? 7 : 4);
  const Body<D> body =
      rng.chance(0.5) ? bodies::kuhn<D>(nodes, 0.1) : bodies::jittered<D>(nodes, 0.1, 0.2, rng);
  const Sweep<D> sweep = bodies::full_crossing(body, rng);
  const FacetSet chosen = Selector<D>(body.k, body.points).select(sweep.simplices);
  const std::vector<Point<D>> duals = bodies::duals(body);
  const Point<D>& eye = duals[rng.below(duals.size())];
  for (const HalfFacetId h : FacetSet::all(body.k).half_facets()) {
    const CellId one = topology::cell_of<D>(h), other = topology::cell_of<D>(*body.k.mate(h));
    const bool differ =
        crosses(sweep, eye, duals[one.value]) != crosses(sweep, eye, duals[other.value]);
    RC_ASSERT(chosen.contains(h) == differ);
  }
  RC_CLASSIFY(chosen.empty(), "all cells on one side");
}

RC_GTEST_PROP(TheoremBProperty, FullCrossingsChooseWhatADualPointSeesInThePlane, ()) {
  full_crossings_choose_what_a_dual_point_sees<2>();
}
RC_GTEST_PROP(TheoremBProperty, FullCrossingsChooseWhatADualPointSeesInSpace, ()) {
  full_crossings_choose_what_a_dual_point_sees<3>();
}

}  // namespace
}  // namespace cleave::cutting
