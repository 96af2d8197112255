#include "cleave/cutting/select.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "box_tree.hpp"
#include "cleave/cutting/predicates.hpp"
#include "finite.hpp"

namespace cleave::cutting {

using topology::CellId;
using topology::Complex;
using topology::FacetSet;
using topology::HalfFacetId;

template <int D>
Point<D> dual_point(const Complex<D>& k, const std::vector<Point<D>>& points, CellId cell) {
  // Quarters cannot overflow, and are exact above the denormals.
  Point<D> sum{};
  for (const topology::VertexId v : k.vertices(cell))
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += 0.25 * points[v.value][i];
  for (double& x : sum) x /= 0.25 * (D + 1);
  return sum;
}

namespace {

/// The half-facets of `cell` that name an interior facet: those less than their mate.
template <int D, class Visit>
void for_lesser_half_facets(const Complex<D>& k, CellId cell, Visit visit) {
  for (int i = 0; i <= D; ++i) {
    const HalfFacetId h = topology::half_facet<D>(cell, i);
    const std::optional<HalfFacetId> mate = k.mate(h);
    if (mate && h < *mate) visit(h, *mate);
  }
}

template <int D>
Box<D> box_of_vertices(const Complex<D>& k, const std::vector<Point<D>>& points, CellId cell) {
  const topology::Cell<D>& vertices = k.vertices(cell);
  Box<D> box{points[vertices[0].value], points[vertices[0].value]};
  for (const topology::VertexId v : vertices)
    detail::include(box, {points[v.value], points[v.value]});
  return box;
}

/// Around the dual edges that `cell` names; the dual point alone if there is none.
template <int D>
Box<D> box_of_dual_edges(const Complex<D>& k, const std::vector<Point<D>>& points, CellId cell) {
  const Point<D> own = dual_point(k, points, cell);
  Box<D> box{own, own};
  for_lesser_half_facets(k, cell, [&](HalfFacetId, HalfFacetId mate) {
    const Point<D> other = dual_point(k, points, topology::cell_of<D>(mate));
    detail::include(box, {other, other});
  });
  return box;
}

/// The elements that occur an odd number of times. Sorts.
std::vector<HalfFacetId> odd_ones(std::vector<HalfFacetId> all) {
  std::sort(all.begin(), all.end());
  std::vector<HalfFacetId> odd;
  for (std::size_t i = 0; i < all.size();) {
    const std::size_t first = i;
    while (i < all.size() && all[i] == all[first]) ++i;
    if ((i - first) % 2 == 1) odd.push_back(all[first]);
  }
  return odd;
}

/// The vertices that the edges across `simplex` put into the set, as bits. The signs and the order
/// by closeness and id belong to one plane, so with Ties::by_id at most D vertices are in: the one
/// that is last in this order is closer than none.
template <int D>
unsigned add_nearest(const SweptSimplex<D>& simplex, const topology::Cell<D>& cell,
                     const std::array<Point<D>, D + 1>& places, Ties ties) {
  std::array<int, D + 1> side;
  for (std::size_t i = 0; i < side.size(); ++i) side[i] = simplex.side(places[i]);
  unsigned nearest = 0;
  for (std::size_t i = 0; i < side.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (side[i] == side[j] || !simplex.crossed_between_sides(places[i], places[j])) continue;
      int order = simplex.compare_heights(places[i], places[j]);
      if (order == 0 && ties == Ties::by_id) order = cell[i] < cell[j] ? -1 : 1;
      if (order <= 0) nearest |= 1u << i;
      if (order >= 0) nearest |= 1u << j;
    }
  return nearest;
}

unsigned set_of(const ClosestSets& sets, CellId cell) {
  const auto found = sets.find(cell);
  return found == sets.end() ? 0 : found->second;
}

template <int D>
void require_points(const Complex<D>& k, const std::vector<Point<D>>& points) {
  if (points.size() != k.vertex_count())
    throw std::invalid_argument("selection: " + std::to_string(points.size()) + " points for " +
                                std::to_string(k.vertex_count()) + " vertices");
  for (const topology::Cell<D>& cell : k.cells())
    for (const topology::VertexId v : cell)
      if (!detail::is_finite<D>(points[v.value]))
        throw std::invalid_argument("selection: vertex " + std::to_string(v.value) +
                                    " has a coordinate that is not finite");
}

}  // namespace

template <int D>
std::array<bool, static_cast<std::size_t>(D) + 1> nearest_vertices(
    const topology::Cell<D>& cell,
    const std::array<Point<D>, static_cast<std::size_t>(D) + 1>& places,
    std::span<const std::array<Point<D>, static_cast<std::size_t>(D)>> simplices, Ties ties) {
  unsigned nearest = 0;
  for (const auto& corners : simplices)
    if (const SweptSimplex<D> simplex(corners); !simplex.is_flat())
      nearest |= add_nearest(simplex, cell, places, ties);
  std::array<bool, D + 1> result;
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = ((nearest >> i) & 1u) != 0;
  return result;
}

template <int D>
struct Selector<D>::Impl {
  const Complex<D>* k;
  const topology::Incision<D>* incision;  // or none
  const std::vector<Point<D>>* points;
  SelectOptions options;
  detail::BoxTree<D> tree;

  Impl(const Complex<D>& complex, const topology::Incision<D>* owner,
       const std::vector<Point<D>>& places, SelectOptions chosen)
      : k(&complex), incision(owner), points(&places), options(chosen) {
    require_points(complex, places);
    std::vector<Box<D>> boxes(complex.cell_count());
    for (topology::Index c = 0; c < boxes.size(); ++c)
      boxes[c] = options.rule == Rule::dual_edge ? box_of_dual_edges(complex, places, CellId{c})
                                                 : box_of_vertices(complex, places, CellId{c});
    tree = detail::BoxTree<D>(boxes);
  }

  /// Appends the facets whose dual edge crosses `simplex`.
  void cross_dual_edges(const SweptSimplex<D>& simplex, std::vector<HalfFacetId>& crossed) const {
    tree.visit_near(simplex, [&](topology::Index cell) {
      const Point<D> own = dual_point(*k, *points, CellId{cell});
      std::optional<int> own_side;  // found once it is asked for
      for_lesser_half_facets(*k, CellId{cell}, [&](HalfFacetId h, HalfFacetId mate) {
        const Point<D> other = dual_point(*k, *points, topology::cell_of<D>(mate));
        Box<D> box{own, own};
        detail::include(box, {other, other});
        if (!simplex.may_meet(box)) return;
        if (!own_side) own_side = simplex.side(own);
        if (*own_side != simplex.side(other) && simplex.crossed_between_sides(own, other))
          crossed.push_back(h);
      });
    });
  }

  topology::Cell<D> original_vertices(CellId cell) const {
    topology::Cell<D> vertices = k->vertices(cell);
    if (incision != nullptr)
      for (topology::VertexId& v : vertices) v = incision->original(v);
    return vertices;
  }

  unsigned nearest(const SweptSimplex<D>& simplex, CellId cell) const {
    if (!simplex.may_meet(box_of_vertices(*k, *points, cell))) return 0;
    std::array<Point<D>, D + 1> places;
    for (std::size_t i = 0; i < places.size(); ++i)
      places[i] = (*points)[k->vertices(cell)[i].value];
    return add_nearest(simplex, original_vertices(cell), places, options.ties);
  }

  FacetSet by_dual_edge(std::span<const SweptSimplex<D>> step) const {
    std::vector<HalfFacetId> crossed;
    for (const SweptSimplex<D>& simplex : step) cross_dual_edges(simplex, crossed);
    return FacetSet::of_lesser(odd_ones(std::move(crossed)));
  }

  /// The cells that `step` puts vertices into the sets of, and those sets then.
  std::vector<std::pair<CellId, unsigned>> grown_sets(std::span<const SweptSimplex<D>> step,
                                                      const ClosestSets& sets) const {
    ClosestSets grown;
    for (const SweptSimplex<D>& simplex : step)
      tree.visit_near(simplex, [&](topology::Index cell) {
        if (const unsigned put_in = nearest(simplex, CellId{cell})) grown[CellId{cell}] |= put_in;
      });
    std::vector<std::pair<CellId, unsigned>> result;
    for (const auto& [cell, put_in] : grown)
      if (const unsigned before = set_of(sets, cell); (before | put_in) != before)
        result.emplace_back(cell, before | put_in);
    return result;
  }

  /// Appends the interior facet that `set` chooses in `cell`, if it chooses one.
  void add_choice(CellId cell, unsigned set, std::vector<HalfFacetId>& facets) const {
    if (std::popcount(set) != D) return;
    const HalfFacetId h = topology::half_facet<D>(cell, std::countr_one(set));
    if (const std::optional<HalfFacetId> mate = k->mate(h)) facets.push_back(std::min(h, *mate));
  }

  /// Whether one of its two cells chooses the interior facet `h`.
  bool is_chosen(HalfFacetId h, const ClosestSets& sets) const {
    const auto chooses = [&](HalfFacetId side) {
      constexpr unsigned kAll = (1u << (D + 1)) - 1;
      return set_of(sets, topology::cell_of<D>(side)) ==
             (kAll & ~(1u << topology::local_index<D>(side)));
    };
    return chooses(h) || chooses(*k->mate(h));
  }

  FacetSet by_nearest_vertex(std::span<const SweptSimplex<D>> step, ClosestSets& sets) const {
    const std::vector<std::pair<CellId, unsigned>> grown = grown_sets(step, sets);
    std::vector<HalfFacetId> affected;
    for (const auto& [cell, set] : grown) {
      add_choice(cell, set_of(sets, cell), affected);
      add_choice(cell, set, affected);
    }
    std::sort(affected.begin(), affected.end());
    affected.erase(std::unique(affected.begin(), affected.end()), affected.end());
    std::vector<bool> was_chosen;
    for (const HalfFacetId h : affected) was_chosen.push_back(is_chosen(h, sets));
    for (const auto& [cell, set] : grown) sets[cell] = set;
    std::vector<HalfFacetId> toggled;
    for (std::size_t i = 0; i < affected.size(); ++i)
      if (is_chosen(affected[i], sets) != was_chosen[i]) toggled.push_back(affected[i]);
    return FacetSet::of_lesser(std::move(toggled));
  }

  FacetSet toggle(std::span<const Simplex> simplices, ClosestSets& sets) const {
    std::vector<SweptSimplex<D>> step;
    for (const Simplex& corners : simplices)
      if (const SweptSimplex<D> simplex(corners); !simplex.is_flat()) step.push_back(simplex);
    return options.rule == Rule::dual_edge ? by_dual_edge(step) : by_nearest_vertex(step, sets);
  }
};

template <int D>
Selector<D>::Selector(const Complex<D>& k, const std::vector<Point<D>>& points,
                      SelectOptions options)
    : impl_(std::make_unique<Impl>(k, nullptr, points, options)) {}

template <int D>
Selector<D>::Selector(const topology::Incision<D>& incision, const std::vector<Point<D>>& points,
                      SelectOptions options)
    : impl_(std::make_unique<Impl>(incision.complex(), &incision, points, options)) {}

template <int D>
Selector<D>::~Selector() = default;

template <int D>
Selector<D>::Selector(Selector&&) noexcept = default;

template <int D>
Selector<D>& Selector<D>::operator=(Selector&&) noexcept = default;

template <int D>
FacetSet Selector<D>::select(std::span<const Simplex> simplices) const {
  ClosestSets sets;
  return toggle(simplices, sets);
}

template <int D>
FacetSet Selector<D>::toggle(std::span<const Simplex> simplices, ClosestSets& sets) const {
  detail::require_finite<D>(simplices);
  return impl_->toggle(simplices, sets);
}

template <int D>
FacetSet Selector<D>::select_step(const Sweep<D>& sweep, std::size_t step) const {
  require_valid(sweep);
  const auto [first, last] = sweep.step(step);
  return select(std::span(sweep.simplices).subspan(first, last - first));
}

template Point<2> dual_point(const Complex<2>&, const std::vector<Point<2>>&, CellId);
template Point<3> dual_point(const Complex<3>&, const std::vector<Point<3>>&, CellId);
template std::array<bool, 3> nearest_vertices<2>(const topology::Cell<2>&,
                                                 const std::array<Point<2>, 3>&,
                                                 std::span<const std::array<Point<2>, 2>>, Ties);
template std::array<bool, 4> nearest_vertices<3>(const topology::Cell<3>&,
                                                 const std::array<Point<3>, 4>&,
                                                 std::span<const std::array<Point<3>, 3>>, Ties);
template class Selector<2>;
template class Selector<3>;

}  // namespace cleave::cutting
