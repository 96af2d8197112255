// T7, T8, T11, C: unglue among all ways to split vertices, in stages, in any order, at one vertex.
#include <algorithm>
#include <map>

#include "cleave/topology/incision.hpp"
#include "property.hpp"

namespace cleave::topology {
namespace {

CLEAVE_PROPERTIES(T7);
CLEAVE_PROPERTIES(T8);
CLEAVE_PROPERTIES(T11);
CLEAVE_PROPERTIES(TheoremC);

template <int D>
using Cells = std::vector<Cell<D>>;

template <int D>
Cells<D> cells_of(const Complex<D>& k) {
  return {k.cells().begin(), k.cells().end()};
}

/// Whether a splitting of `before` opens facets of `cut` only.
template <int D>
bool is_admissible(const Cells<D>& before, const Cells<D>& splitting, const FacetSet& cut) {
  const auto opened = support::opened_facets<D>(before, splitting);
  return std::all_of(opened.begin(), opened.end(), [&](HalfFacetId h) { return cut.contains(h); });
}

/// The classes of corners, by vertex.
template <int D>
std::map<VertexId, std::vector<CornerId>> classes_of(const Cells<D>& cells) {
  std::map<VertexId, std::vector<CornerId>> classes;
  for (Index c = 0; c < cells.size(); ++c)
    for (int i = 0; i <= D; ++i)
      classes[cells[c][static_cast<std::size_t>(i)]].push_back(half_facet<D>({c}, i));
  return classes;
}

template <int D>
VertexId& vertex_at(Cells<D>& cells, CornerId corner) {
  return cells[cell_of<D>(corner).value][static_cast<std::size_t>(local_index<D>(corner))];
}

template <int D>
std::vector<HalfFacetId> some_of(const FacetSet& facets, double density, Rng& rng) {
  std::vector<HalfFacetId> result;
  for (const HalfFacetId h : facets.half_facets())
    if (rng.chance(density)) result.push_back(h);
  return result;
}

TYPED_TEST(T7, ACoarserSplittingIsAdmissibleAndOpensNoMore) {
  constexpr int D = TypeParam::value;
  for_all<D>([](const Trial<D>& trial) {
    const Cut<D> cut(trial);
    Rng rng = trial.rng();
    const Cells<D> before = cells_of(cut.before);
    Cells<D> coarser = cells_of(cut.after);
    for (const Split& split : cut.change.splits)
      if (rng.chance(0.5))
        for (Cell<D>& cell : coarser)
          std::replace(cell.begin(), cell.end(), split.vertex, split.parent);
    RC_ASSERT(is_admissible<D>(before, coarser, cut.facets));
    RC_ASSERT(support::refines<D>(cut.after.cells(), coarser));
    for (const HalfFacetId h : support::opened_facets<D>(before, coarser))
      RC_ASSERT(!cut.after.is_interior(h));
  });
}

TYPED_TEST(T7, NoClassCanBeSplitFurther) {
  constexpr int D = TypeParam::value;
  for_all<D>([](const Trial<D>& trial) {
    const Cut<D> cut(trial);
    Rng rng = trial.rng();
    const Cells<D> before = cells_of(cut.before);
    const Cells<D> after = cells_of(cut.after);
    const VertexId fresh{static_cast<Index>(cut.after.vertex_count())};
    std::vector<std::vector<CornerId>> divisible;
    for (const auto& [vertex, corners] : classes_of<D>(after))
      if (corners.size() >= 2) divisible.push_back(corners);
    for (int tries = 0; tries < 5 && !divisible.empty(); ++tries) {
      auto corners = rng.pick(divisible);
      rng.shuffle(corners);
      corners.resize(1 + rng.below(corners.size() - 1));
      Cells<D> finer = after;
      for (const CornerId corner : corners) vertex_at<D>(finer, corner) = fresh;
      RC_ASSERT(!is_admissible<D>(before, finer, cut.facets));
    }
  });
}

TYPED_TEST(T7, EveryAdmissibleSplittingIsCoarser) {
  constexpr int D = TypeParam::value;
  for_all<D>([](const Trial<D>& trial) {
    const Cut<D> cut(trial);
    Rng rng = trial.rng();
    const Cells<D> before = cells_of(cut.before);
    const auto classes = classes_of<D>(before);
    // Splittings made without unglue: corners of one vertex are told apart by a random colouring of
    // the pieces that a random part of the cut leaves, or by chance alone.
    for (int tries = 0; tries < 5; ++tries) {
      const double density = tries == 0 ? 1.0 : rng.unit();
      const auto piece = support::components<D>(before, some_of<D>(cut.facets, density, rng));
      const bool by_piece = tries < 4;
      Cells<D> splitting = before;
      Index fresh = static_cast<Index>(cut.before.vertex_count());
      for (const auto& [vertex, corners] : classes) {
        if (rng.chance(0.3)) continue;
        std::map<std::size_t, bool> moves;
        for (const CornerId corner : corners) {
          const std::size_t key = by_piece ? piece[cell_of<D>(corner).value] : corner.value;
          if (moves.try_emplace(key, rng.chance(0.5)).first->second)
            vertex_at<D>(splitting, corner) = {fresh};
        }
        ++fresh;
      }
      if (by_piece) RC_ASSERT(is_admissible<D>(before, splitting, cut.facets));
      if (is_admissible<D>(before, splitting, cut.facets)) {
        RC_ASSERT(support::refines<D>(cut.after.cells(), splitting));
        const auto opened = support::opened_facets<D>(before, splitting);
        for (const HalfFacetId h : opened) RC_ASSERT(!cut.after.is_interior(h));
      }
    }
  });
}

/// The corners that a facet's two cells have at `vertex` of `k`.
template <int D>
std::vector<CornerId> corners_at(const Complex<D>& k, const OpenedFacet& facet, VertexId vertex) {
  std::vector<CornerId> corners;
  for (const HalfFacetId side : {facet.half_facet, facet.former_mate})
    for (int i = 0; i <= D; ++i) {
      const CornerId corner = half_facet<D>(cell_of<D>(side), i);
      if (corner != side && k.vertex(corner) == vertex) corners.push_back(corner);
    }
  return corners;
}

TYPED_TEST(T8, ALargerCutSeparatesMore) {
  constexpr int D = TypeParam::value;
  for_all<D>([](const Trial<D>& trial) {
    const Cut<D> larger(trial);
    Rng rng = trial.rng();
    Complex<D> k = larger.before;
    unglue(k, FacetSet::of(k, some_of<D>(larger.facets, rng.unit(), rng)), Verify::all);
    RC_ASSERT(support::refines<D>(larger.after.cells(), k.cells()));
  });
}

TYPED_TEST(T8, StagesThatRememberShutFacetsEqualOneCut) {
  constexpr int D = TypeParam::value;
  for_all<D>([](const Trial<D>& trial) {
    const Cut<D> once(trial);
    Rng rng = trial.rng();
    Incision<D> staged(once.before);
    std::size_t opened = 0;
    for (int stage = 0; stage < 4; ++stage) {
      const auto part =
          stage == 3 ? std::vector<HalfFacetId>(trial.cut) : some_of<D>(once.facets, 0.4, rng);
      opened += staged.cut(staged.facets(part), Verify::all).opened.size();
    }
    RC_ASSERT(support::same_partition<D>(once.after.cells(), staged.complex().cells()));
    RC_ASSERT(staged.scored() == once.facets);
    RC_ASSERT(staged.shut() == FacetSet::of_lesser(once.change.shut));
    RC_ASSERT(opened == once.change.opened.size());
    const std::vector<OpenedFacet> all = staged.opened();
    RC_ASSERT(all.size() == opened);
    for (std::size_t i = 0; i < opened; ++i) {
      RC_ASSERT(all[i].half_facet == once.change.opened[i].half_facet);
      RC_ASSERT(all[i].former_mate == once.change.opened[i].former_mate);
      const auto corners = corners_at<D>(once.before, all[i], all[i].by);
      RC_ASSERT(corners.size() == 2U);  // `by` is a vertex of the original facet, and separates it
      RC_ASSERT(staged.complex().vertex(corners[0]) != staged.complex().vertex(corners[1]));
    }
  });
}

// The closed form of what forgetting costs: the later cut acts as if the shut facets had never been
// asked for (an example where that differs from one cut: examples_test.cpp).
TYPED_TEST(T8, ForgottenFacetsCountAsNeverAskedFor) {
  constexpr int D = TypeParam::value;
  for_all<D>([](const Trial<D>& trial) {
    const Cut<D> all(trial);
    Rng rng = trial.rng();
    const FacetSet first = FacetSet::of(all.before, some_of<D>(all.facets, 0.5, rng));
    const FacetSet second = all.facets - first;
    Incision<D> forgetful(all.before);
    const FacetSet opened = first - FacetSet::of_lesser(forgetful.cut(first).shut);
    forgetful.forget_shut(first);
    RC_ASSERT(forgetful.shut().empty());
    forgetful.cut(second, Verify::all);
    Complex<D> at_once = all.before;
    unglue(at_once, opened | second, Verify::all);
    RC_ASSERT(support::same_partition<D>(forgetful.complex().cells(), at_once.cells()));
  });
}

TYPED_TEST(T11, OrderAndRepetitionOfNodesDoNotMatter) {
  constexpr int D = TypeParam::value;
  for_all<D>([](const Trial<D>& trial) {
    const Cut<D> cut(trial);
    Rng rng = trial.rng();
    std::vector<VertexId> order;
    for (const auto& [vertex, star] : support::stars_of<D>(trial.mesh.cells)) {
      order.push_back(vertex);
      if (rng.chance(0.3)) order.push_back(vertex);
    }
    rng.shuffle(order);
    const auto looped = support::algorithm_3<D>(trial.mesh.cells, trial.cut, order);
    RC_ASSERT(support::same_partition<D>(looped, cut.after.cells()));
  });
}

TYPED_TEST(T11, InACutRegularMeshTheNodesOfTheCutSuffice) {
  constexpr int D = TypeParam::value;
  for_all<D>([](const Trial<D>& trial) {
    const Cut<D> cut(trial);
    Rng rng = trial.rng();
    std::set<VertexId> on_cut;
    for (const HalfFacetId h : cut.facets.half_facets())
      for (const VertexId v : cut.before.facet(h)) on_cut.insert(v);
    std::vector<VertexId> order(on_cut.begin(), on_cut.end());
    rng.shuffle(order);
    const auto looped = support::algorithm_3<D>(cut.before.cells(), trial.cut, order);
    RC_ASSERT(support::same_partition<D>(looped, cut.after.cells()));
  });
}

// At one vertex the cut has the facets between two random sets of cells, elsewhere what the trial
// has.
TYPED_TEST(TheoremC, ACutThatPartsTheStarOpens) {
  constexpr int D = TypeParam::value;
  for_all<D>([](const Trial<D>& trial) {
    const Complex<D> before = trial.complex();
    Rng rng = trial.rng();
    const VertexId vertex =
        before.vertex({static_cast<Index>(rng.below(before.half_facet_count()))});
    const auto is_at_vertex = [&](HalfFacetId h) {
      const Facet<D> facet = before.facet(h);
      return std::find(facet.begin(), facet.end(), vertex) != facet.end();
    };
    const double share = rng.unit();
    std::vector<bool> label(before.cell_count());
    for (std::size_t c = 0; c < label.size(); ++c) label[c] = rng.chance(share);

    std::vector<HalfFacetId> cut, at_vertex;
    for (const HalfFacetId h : trial.cut)
      if (!is_at_vertex(h)) cut.push_back(h);
    for (Index h = 0; h < before.half_facet_count(); ++h)
      if (const auto mate = before.mate({h}); mate && HalfFacetId{h} < *mate && is_at_vertex({h}))
        if (label[cell_of<D>({h}).value] != label[cell_of<D>(*mate).value])
          at_vertex.push_back({h});
    cut.insert(cut.end(), at_vertex.begin(), at_vertex.end());
    Complex<D> after = before;
    const Relabelling change = unglue(after, FacetSet::of(before, cut), Verify::all);

    std::size_t opened = 0;
    for (const OpenedFacet& facet : change.opened) {
      if (!is_at_vertex(facet.half_facet)) continue;
      ++opened;
      const auto corners = corners_at<D>(before, facet, vertex);
      RC_ASSERT(corners.size() == 2U);
      RC_ASSERT(after.vertex(corners[0]) != after.vertex(corners[1]));
    }
    RC_ASSERT(opened == at_vertex.size());
    for (const HalfFacetId h : at_vertex) RC_ASSERT(!after.is_interior(h));
  });
}

}  // namespace
}  // namespace cleave::topology
