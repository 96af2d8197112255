// T1 to T6: what one cut does.
#include <algorithm>
#include <set>

#include "cleave/topology/assemble.hpp"
#include "property.hpp"

namespace cleave::topology {
namespace {

CLEAVE_PROPERTIES(T1);
CLEAVE_PROPERTIES(T2);
CLEAVE_PROPERTIES(T3);
CLEAVE_PROPERTIES(T4);
CLEAVE_PROPERTIES(T5);
CLEAVE_PROPERTIES(T6);

template <int D>
CornerId corner_in(const Complex<D>& k, CellId cell, VertexId vertex) {
  const Cell<D>& vertices = k.vertices(cell);
  const auto at = std::find(vertices.begin(), vertices.end(), vertex) - vertices.begin();
  return half_facet<D>(cell, static_cast<int>(at));
}

template <int D>
std::vector<std::int8_t> signs_of(const Complex<D>& k) {
  std::vector<std::int8_t> signs;
  for (Index c = 0; c < k.cell_count(); ++c) signs.push_back(static_cast<std::int8_t>(k.sign({c})));
  return signs;
}

TYPED_TEST(T1, CellsStayDistinctSimplicesAndParentsGiveThemBack) {
  constexpr int D = TypeParam::value;
  for_all<D>([](const Trial<D>& trial) {
    const Cut<D> cut(trial);
    RC_ASSERT(cut.after.cell_count() == cut.before.cell_count());
    std::set<std::set<VertexId>> cells;
    for (Index c = 0; c < cut.after.cell_count(); ++c) {
      const Cell<D>& cell = cut.after.vertices({c});
      const std::set<VertexId> vertices(cell.begin(), cell.end());
      RC_ASSERT(vertices.size() == static_cast<std::size_t>(D) + 1);
      RC_ASSERT(cells.insert(vertices).second);
      for (std::size_t i = 0; i < cell.size(); ++i)
        RC_ASSERT(cut.change.parent(cell[i]) == cut.before.vertices({c})[i]);
    }
  });
}

TYPED_TEST(T1, TheResultIsThatOfAlgorithm3) {
  constexpr int D = TypeParam::value;
  for_all<D>([](const Trial<D>& trial) {
    const Cut<D> cut(trial);
    RC_ASSERT(support::same_partition<D>(cut.before.cells(), trial.regularized));
    RC_ASSERT(support::same_partition<D>(cut.after.cells(), trial.expected));
  });
}

TYPED_TEST(T2, PseudoManifoldAndOrientationAreKept) {
  constexpr int D = TypeParam::value;
  for_all<D>([](const Trial<D>& trial) {
    const Cut<D> cut(trial);
    RC_ASSERT(support::is_pseudo_manifold<D>(cut.after.cells()));
    RC_ASSERT(signs_of(cut.after) == trial.signs);
    RC_ASSERT(support::is_coherent<D>(cut.after.cells(), trial.signs));
    RC_ASSERT(cut.after.half_facet_count() == cut.before.half_facet_count());
    const auto mates = support::mates_of<D>(cut.after.cells());
    for (Index h = 0; h < mates.size(); ++h) {
      RC_ASSERT(cut.after.mate({h}) == mates[h]);
      if (mates[h]) RC_ASSERT(cut.before.mate({h}) == mates[h]);
      Facet<D> facet = cut.after.facet({h});
      for (VertexId& v : facet) v = cut.change.parent(v);
      RC_ASSERT(facet == cut.before.facet({h}));
      RC_ASSERT(cut.after.facet_sign({h}) == cut.before.facet_sign({h}));
    }
  });
}

TYPED_TEST(T3, AFacetOpensIffOneOfItsVerticesSeparates) {
  constexpr int D = TypeParam::value;
  for_all<D>([](const Trial<D>& trial) {
    const Cut<D> cut(trial);
    std::vector<OpenedFacet> opened;
    std::vector<HalfFacetId> shut;
    for (Index h = 0; h < cut.before.half_facet_count(); ++h) {
      const auto mate = cut.before.mate({h});
      if (!mate) RC_ASSERT(!cut.after.mate({h}));  // old boundary stays
      if (!mate || *mate < HalfFacetId{h}) continue;
      Facet<D> facet = cut.before.facet({h});
      std::sort(facet.begin(), facet.end());
      const auto separates = [&](VertexId v) {
        return cut.after.vertex(corner_in(cut.before, cell_of<D>(HalfFacetId{h}), v)) !=
               cut.after.vertex(corner_in(cut.before, cell_of<D>(*mate), v));
      };
      const auto by = std::find_if(facet.begin(), facet.end(), separates);
      RC_ASSERT(cut.after.is_interior({h}) == (by == facet.end()));
      if (by != facet.end()) {
        RC_ASSERT(cut.facets.contains({h}));  // only facets of the cut
        opened.push_back({{h}, *mate, *by});
      } else if (cut.facets.contains({h})) {
        shut.push_back({h});
      }
    }
    RC_ASSERT(cut.change.opened == opened);
    RC_ASSERT(cut.change.shut == shut);
  });
}

TYPED_TEST(T4, TheResultIsCutRegularEvenWithRespectToTheCut) {
  constexpr int D = TypeParam::value;
  for_all<D>([](const Trial<D>& trial) {
    const Cut<D> cut(trial);
    for (const auto& [vertex, parts] :
         support::parts_of_stars<D>(cut.after.cells(), cut.facets.half_facets()))
      RC_ASSERT(parts == 1U);
  });
}

TYPED_TEST(T4, AnyInputIsMadeCutRegular) {
  constexpr int D = TypeParam::value;
  for_all<D>([](const Trial<D>& trial) {
    const auto made =
        assemble_regularized<D>({trial.mesh.cells, trial.mesh.vertex_count, trial.signs});
    const auto cells = made.complex.cells();
    for (const auto& [vertex, parts] : support::parts_of_stars<D>(cells)) RC_ASSERT(parts == 1U);
    RC_ASSERT(support::same_partition<D>(cells, trial.regularized));
    const auto original = support::parts_of_stars<D>(trial.mesh.cells);
    std::map<VertexId, std::size_t> copies;
    Index next = static_cast<Index>(trial.mesh.vertex_count);
    for (const Split& split : made.splits) {
      RC_ASSERT(split.vertex == VertexId{next++});
      ++copies[split.parent];
    }
    RC_ASSERT(made.complex.vertex_count() == next);
    for (const auto& [vertex, parts] : original) RC_ASSERT(copies[vertex] + 1 == parts);
  });
}

TYPED_TEST(T5, AnEmptyCutChangesNothing) {
  constexpr int D = TypeParam::value;
  for_all<D>([](const Trial<D>& trial) {
    Complex<D> k = trial.complex();
    const auto cells = std::vector<Cell<D>>(k.cells().begin(), k.cells().end());
    const Relabelling change = unglue(k, FacetSet(), Verify::all);
    RC_ASSERT((change.corners.empty() && change.splits.empty() && change.opened.empty()));
    RC_ASSERT(std::equal(cells.begin(), cells.end(), k.cells().begin(), k.cells().end()));
    const auto again = assemble_regularized<D>({cells, k.vertex_count(), trial.signs});
    RC_ASSERT(again.splits.empty());
  });
}

TYPED_TEST(T5, TheSameCutAgainChangesNothing) {
  constexpr int D = TypeParam::value;
  for_all<D>([](const Trial<D>& trial) {
    Cut<D> cut(trial);
    const Relabelling again =
        unglue(cut.after, FacetSet::of(cut.after, cut.change.shut), Verify::all);
    RC_ASSERT((again.corners.empty() && again.splits.empty() && again.opened.empty()));
    RC_ASSERT(again.shut == cut.change.shut);
  });
}

TYPED_TEST(T6, VerticesOffTheCutStayAndTheRestAreCountedByClasses) {
  constexpr int D = TypeParam::value;
  for_all<D>([](const Trial<D>& trial) {
    const Cut<D> cut(trial);
    std::set<VertexId> on_cut;
    for (const HalfFacetId h : cut.facets.half_facets())
      for (const VertexId v : cut.before.facet(h)) on_cut.insert(v);
    for (const Split& split : cut.change.splits) RC_ASSERT(on_cut.count(split.parent) == 1U);
    std::size_t more = 0;
    for (const auto& [vertex, classes] :
         support::parts_of_stars<D>(cut.before.cells(), cut.facets.half_facets()))
      more += classes - 1;
    RC_ASSERT(cut.change.splits.size() == more);
    RC_ASSERT(cut.after.vertex_count() == cut.before.vertex_count() + more);
    RC_ASSERT(support::used_vertices<D>(cut.after.cells()) ==
              support::used_vertices<D>(cut.before.cells()) + more);
  });
}

}  // namespace
}  // namespace cleave::topology
