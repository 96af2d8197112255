// Facet sets, relabellings and incisions: what callers rely on, in every dimension.
#include "cleave/topology/incision.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "cleave/topology/carry_over.hpp"
#include "property.hpp"

namespace cleave::topology {
namespace {

CLEAVE_PROPERTIES(FacetSets);
CLEAVE_PROPERTIES(Relabellings);
CLEAVE_PROPERTIES(Incisions);

using Ids = std::set<HalfFacetId>;

Ids ids(const FacetSet& facets) {
  return {facets.half_facets().begin(), facets.half_facets().end()};
}

TYPED_TEST(FacetSets, AreSetsOfLesserHalfFacets) {
  constexpr int D = TypeParam::value;
  for_all<D>([](const Trial<D>& trial) {
    const Complex<D> k = trial.complex();
    Rng rng = trial.rng();
    const FacetSet all = FacetSet::all(k);
    const auto interior = support::interior_facets<D>(k.cells());
    RC_ASSERT(std::equal(interior.begin(), interior.end(), all.half_facets().begin(),
                         all.half_facets().end()));
    Ids expected;
    const auto mates = support::mates_of<D>(k.cells());
    for (const HalfFacetId h : trial.cut) expected.insert(std::min(h, *mates[h.value]));
    const FacetSet a = FacetSet::of(k, trial.cut);
    RC_ASSERT(ids(a) == expected);
    RC_ASSERT((a.size() == expected.size() && a.empty() == expected.empty()));
    RC_ASSERT(std::is_sorted(a.half_facets().begin(), a.half_facets().end()));
    std::vector<HalfFacetId> drawn;
    for (const HalfFacetId h : interior)
      if (rng.chance(0.4)) drawn.push_back(rng.chance(0.5) ? h : *mates[h.value]);
    const FacetSet b = FacetSet::of(k, drawn);
    for (const HalfFacetId h : interior) {
      const bool in_a = a.contains(h);
      const bool in_b = b.contains(h);
      RC_ASSERT(in_a == (expected.count(h) == 1));
      RC_ASSERT((a | b).contains(h) == (in_a || in_b));
      RC_ASSERT((a & b).contains(h) == (in_a && in_b));
      RC_ASSERT((a - b).contains(h) == (in_a && !in_b));
      RC_ASSERT((a ^ b).contains(h) == (in_a != in_b));
      RC_ASSERT(!a.contains(*mates[h.value]));
    }
    RC_ASSERT(((a - b) | (b - a)) == (a ^ b));
    RC_ASSERT((all - (all - a)) == a);
  });
}

TYPED_TEST(Relabellings, SayWhatChangedAndNothingElse) {
  constexpr int D = TypeParam::value;
  for_all<D>([](const Trial<D>& trial) {
    const Cut<D> cut(trial);
    RC_ASSERT(cut.change.vertices_before == cut.before.vertex_count());
    RC_ASSERT(cut.change.vertices_after == cut.after.vertex_count());
    RC_ASSERT(cut.change.merges.empty());
    std::vector<RenamedCorner> renamed;
    std::map<VertexId, CornerId> least;  // of each class after the cut
    for (Index c = 0; c < cut.after.half_facet_count(); ++c) {
      const VertexId from = cut.before.vertex({c});
      const VertexId to = cut.after.vertex({c});
      if (from != to) renamed.push_back({{c}, from, to});
      least.try_emplace(to, CornerId{c});
    }
    RC_ASSERT(cut.change.corners == renamed);
    // The class with the least corner keeps the vertex; new ones by parent, then least corner.
    std::vector<std::tuple<VertexId, CornerId>> order;
    VertexId next{static_cast<Index>(cut.before.vertex_count())};
    for (const Split& split : cut.change.splits) {
      RC_ASSERT(split.vertex == next);
      ++next.value;
      order.emplace_back(split.parent, least.at(split.vertex));
      RC_ASSERT(least.at(split.parent) < least.at(split.vertex));
    }
    RC_ASSERT(next.value == cut.after.vertex_count());
    RC_ASSERT(std::is_sorted(order.begin(), order.end()));
    // Opened and shut divide the cut.
    std::vector<HalfFacetId> opened;
    for (const OpenedFacet& facet : cut.change.opened) opened.push_back(facet.half_facet);
    RC_ASSERT((FacetSet::of_lesser(opened) | FacetSet::of_lesser(cut.change.shut)) == cut.facets);
    RC_ASSERT(opened.size() + cut.change.shut.size() == cut.facets.size());
  });
}

TYPED_TEST(Relabellings, VertexDataFollowsTheParents) {
  constexpr int D = TypeParam::value;
  for_all<D>([](const Trial<D>& trial) {
    const Cut<D> cut(trial);
    Rng rng = trial.rng();
    std::vector<std::uint64_t> value(cut.before.vertex_count());
    std::vector<VertexId> chosen;
    for (Index v = 0; v < value.size(); ++v) {
      value[v] = rng.next();
      if (rng.chance(0.4)) chosen.push_back({v});
    }
    const auto old_value = value;
    const std::set<VertexId> old_chosen(chosen.begin(), chosen.end());
    carry_over(value, cut.change);
    carry_over_set(chosen, cut.change);
    RC_ASSERT(value.size() == cut.after.vertex_count());
    RC_ASSERT(std::is_sorted(chosen.begin(), chosen.end()));
    for (Index c = 0; c < cut.after.half_facet_count(); ++c) {
      const VertexId to = cut.after.vertex({c});
      const VertexId from = cut.before.vertex({c});
      RC_ASSERT(value[to.value] == old_value[from.value]);
      RC_ASSERT(std::binary_search(chosen.begin(), chosen.end(), to) ==
                (old_chosen.count(from) == 1));
    }
  });
}

/// The cells as a writer sees them.
template <int D>
std::vector<Cell<D>> canonical_cells(const Incision<D>& incision) {
  const auto number = canonical(incision);
  std::vector<Cell<D>> cells(incision.complex().cells().begin(), incision.complex().cells().end());
  for (Cell<D>& cell : cells)
    for (VertexId& v : cell) v = number[v.value];
  return cells;
}

TYPED_TEST(Incisions, CanonicalNumbersDependOnTheScoredSetAlone) {
  constexpr int D = TypeParam::value;
  for_all<D>([](const Trial<D>& trial) {
    const Complex<D> k = trial.complex();
    Rng rng = trial.rng();
    Incision<D> at_once(k);
    at_once.cut(at_once.facets(trial.cut));
    Incision<D> staged(k);
    std::vector<HalfFacetId> left = trial.cut;
    rng.shuffle(left);
    while (!left.empty()) {
      const std::size_t size = 1 + rng.below(left.size());
      std::vector<HalfFacetId> part(left.end() - static_cast<std::ptrdiff_t>(size), left.end());
      left.resize(left.size() - size);
      staged.cut(staged.facets(part));
    }
    const auto cells = canonical_cells(at_once);
    RC_ASSERT(canonical_cells(staged) == cells);
    RC_ASSERT(staged.scored() == at_once.scored());
    // Original vertices keep their numbers; copies follow without gaps, by original vertex.
    const auto number = canonical(at_once);
    std::map<VertexId, VertexId> original_of;  // by canonical number
    for (Index v = 0; v < number.size(); ++v) {
      if (v < k.vertex_count()) RC_ASSERT(number[v] == VertexId{v});
      if (v >= k.vertex_count()) original_of[number[v]] = at_once.original({v});
    }
    VertexId next{static_cast<Index>(k.vertex_count())};
    VertexId last{0};
    for (const auto& [vertex, original] : original_of) {
      RC_ASSERT(vertex == next);
      ++next.value;
      RC_ASSERT(!(original < last));
      last = original;
    }
    for (Index c = 0; c < k.half_facet_count(); ++c)
      RC_ASSERT(at_once.original(at_once.complex().vertex({c})) == k.vertex({c}));
  });
}

TYPED_TEST(Incisions, AFacetThatIsNotInteriorIsRefusedAndNothingChanges) {
  constexpr int D = TypeParam::value;
  for_all<D>([](const Trial<D>& trial) {
    const Cut<D> cut(trial);
    Rng rng = trial.rng();
    std::vector<HalfFacetId> boundary;
    for (Index h = 0; h < cut.after.half_facet_count(); ++h)
      if (!cut.after.is_interior({h})) boundary.push_back({h});
    if (boundary.empty()) return;
    const HalfFacetId wrong = rng.pick(boundary);
    std::vector<HalfFacetId> asked = cut.change.shut;
    asked.push_back(wrong);
    const auto refused = [&](const auto& action) {
      try {
        action();
      } catch (const NotInterior& error) {
        return error.half_facet == wrong;
      }
      return false;
    };
    RC_ASSERT(refused([&] { FacetSet::of(cut.after, asked); }));
    // A set made for another complex, or before an earlier cut.
    Complex<D> k = cut.after;
    const std::vector<Cell<D>> cells(k.cells().begin(), k.cells().end());
    RC_ASSERT(refused([&] { unglue(k, FacetSet::of_lesser(asked)); }));
    RC_ASSERT(std::equal(cells.begin(), cells.end(), k.cells().begin(), k.cells().end()));
    RC_ASSERT(k.vertex_count() == cut.after.vertex_count());
    for (Index h = 0; h < k.half_facet_count(); ++h) RC_ASSERT(k.mate({h}) == cut.after.mate({h}));
    const HalfFacetId beyond{static_cast<Index>(k.half_facet_count())};
    RC_ASSERT_THROWS_AS(unglue(k, FacetSet::of_lesser({beyond})), NotInterior);
    for (const HalfFacetId shut : cut.change.shut)  // not named by its lesser half-facet
      RC_ASSERT_THROWS_AS(unglue(k, FacetSet::of_lesser({*k.mate(shut)})), NotInterior);
    Incision<D> incision(cut.after);
    RC_ASSERT(refused([&] { incision.cut(FacetSet::of_lesser(asked)); }));
    RC_ASSERT(incision.scored().empty());
    RC_ASSERT(incision.complex().vertex_count() == cut.after.vertex_count());
  });
}

}  // namespace
}  // namespace cleave::topology
