// T9, T10, T13, and closure under subsets: what holds of the complex as a whole.
#include <algorithm>
#include <map>
#include <set>

#include "cleave/topology/boundary.hpp"
#include "cleave/topology/check.hpp"
#include "cleave/topology/pieces.hpp"
#include "cleave/topology/simplices.hpp"
#include "property.hpp"

namespace cleave::topology {
namespace {

CLEAVE_PROPERTIES(T9);
CLEAVE_PROPERTIES(T10);
CLEAVE_PROPERTIES(T13);
CLEAVE_PROPERTIES(Simplexes);

TYPED_TEST(T9, PiecesAreComponentsOfTheDualGraphWithoutTheCut) {
  constexpr int D = TypeParam::value;
  for_all<D>([](const Trial<D>& trial) {
    const Cut<D> cut(trial);
    const Pieces found = pieces(cut.after);
    const auto expected = support::components<D>(cut.before.cells(), cut.facets.half_facets());
    // Both number components by their least cell.
    RC_ASSERT(
        std::equal(expected.begin(), expected.end(), found.of_cell.begin(), found.of_cell.end()));
    RC_ASSERT(found.count == std::set<std::size_t>(expected.begin(), expected.end()).size());
  });
}

TYPED_TEST(T9, CellsThatShareAVertexAreInOnePiece) {
  constexpr int D = TypeParam::value;
  for_all<D>([](const Trial<D>& trial) {
    const Cut<D> cut(trial);
    const Pieces found = pieces(cut.after);
    for (const auto& [vertex, star] : support::stars_of<D>(cut.after.cells()))
      for (const std::size_t c : star) RC_ASSERT(found.of_cell[c] == found.of_cell[*star.begin()]);
  });
}

/// For each ridge of the boundary: how many boundary facets have it, and the sum of the signs that
/// they induce on it. The empty set counts as a ridge for D = 1.
template <int D>
std::map<std::vector<VertexId>, std::pair<int, int>> boundary_of_boundary(const Complex<D>& k) {
  std::map<std::vector<VertexId>, std::pair<int, int>> ridges;
  for (const HalfFacetId h : boundary(k)) {
    const Facet<D> facet = k.facet(h);
    for (std::size_t i = 0; i < facet.size(); ++i) {
      std::vector<VertexId> ridge(facet.begin(), facet.end());
      ridge.erase(ridge.begin() + static_cast<std::ptrdiff_t>(i));
      const int sign = k.facet_sign(h) * (i % 2 == 0 ? 1 : -1) * support::parity(ridge);
      std::sort(ridge.begin(), ridge.end());
      auto& [count, sum] = ridges[ridge];
      ++count;
      sum += sign;
    }
  }
  return ridges;
}

TYPED_TEST(T10, TheBoundaryIsClosedBeforeAndAfter) {
  constexpr int D = TypeParam::value;
  for_all<D>([](const Trial<D>& trial) {
    const Cut<D> cut(trial);
    for (const Complex<D>* k : {&cut.before, &cut.after})
      for (const auto& [ridge, counted] : boundary_of_boundary<D>(*k)) {
        RC_ASSERT(counted.first % 2 == 0);
        RC_ASSERT(counted.second == 0);
      }
    RC_ASSERT(boundary(cut.after).size() ==
              boundary(cut.before).size() + 2 * cut.change.opened.size());
  });
}

// What Algorithm 5 finds by looking up the mate of an oriented facet, found by comparing vertices.
TYPED_TEST(T13, TheNeighbourIsTheOtherCellOfTheFacet) {
  constexpr int D = TypeParam::value;
  for_all<D>([](const Trial<D>& trial) {
    const Cut<D> cut(trial);
    for (const Complex<D>* k : {&cut.before, &cut.after})
      for (const auto& [facet, sides] : support::facets_of<D>(k->cells())) {
        RC_ASSERT(sides.size() <= 2U);
        const bool interior = sides.size() == 2U;
        for (std::size_t i = 0; i < sides.size(); ++i) {
          const auto mate = k->mate(sides[i]);
          RC_ASSERT(mate.has_value() == interior);
          if (interior) RC_ASSERT(*mate == sides[1 - i]);
        }
      }
  });
}

TYPED_TEST(T13, TheFloodReachesTheWholeStarAfterEveryCut) {
  constexpr int D = TypeParam::value;
  for_all<D>([](const Trial<D>& trial) {
    const Cut<D> cut(trial);
    const auto stars = support::stars_of<D>(cut.after.cells());
    for (Index v = 0; v < cut.after.vertex_count(); ++v) {
      const auto expected = stars.find(VertexId{v});
      RC_ASSERT(cut.after.a_corner({v}).has_value() == (expected != stars.end()));
      if (expected == stars.end()) continue;
      const auto corners = star(cut.after, VertexId{v});
      std::set<std::size_t> cells;
      for (const CornerId corner : corners) {
        RC_ASSERT(cut.after.vertex(corner) == VertexId{v});
        cells.insert(cell_of<D>(corner).value);
      }
      RC_ASSERT(corners.size() == cells.size());
      RC_ASSERT(cells == expected->second);
    }
  });
}

// In both directions, on meshes that need not be cut-regular; the flood is the reference's
// Algorithm 5, which looks oriented facets up.
TYPED_TEST(T13, TheFloodReachesTheStarIffTheVertexIsCutRegular) {
  constexpr int D = TypeParam::value;
  for_all<D>([](const Trial<D>& trial) {
    std::map<VertexId, NotCutRegular> irregular;
    const CellSoup<D> soup{trial.mesh.cells, trial.mesh.vertex_count, trial.signs};
    for (const Violation& violation : check(soup, Level::cut_regular))
      if (const auto* found = std::get_if<NotCutRegular>(&violation))
        irregular.emplace(found->vertex, *found);
    const auto parts = support::parts_of_stars<D>(trial.mesh.cells);
    Rng rng = trial.rng();
    for (const auto& [vertex, star] : support::stars_of<D>(trial.mesh.cells)) {
      const auto found = irregular.find(vertex);
      RC_ASSERT((found == irregular.end()) == (parts.at(vertex) == 1));
      if (found == irregular.end() && rng.chance(0.9)) continue;  // the flood is slow
      const auto reached = support::flood<D>(trial.mesh.cells, trial.signs, vertex, *star.begin());
      RC_ASSERT((reached == star) == (found == irregular.end()));
      if (found == irregular.end()) continue;
      RC_ASSERT(found->second.parts == parts.at(vertex));
      const auto one =
          support::flood<D>(trial.mesh.cells, trial.signs, vertex, found->second.one_part.value);
      RC_ASSERT(star.count(found->second.one_part.value) == 1U);
      RC_ASSERT(star.count(found->second.other_part.value) == 1U);
      RC_ASSERT(one.count(found->second.other_part.value) == 0U);
    }
  });
}

TYPED_TEST(Simplexes, AreClosedUnderSubsets) {
  constexpr int D = TypeParam::value;
  for_all<D>([](const Trial<D>& trial) {
    const Cut<D> cut(trial);
    std::set<std::vector<VertexId>> expected;
    for (Cell<D> cell : cut.after.cells()) {
      std::sort(cell.begin(), cell.end());
      for (unsigned subset = 1; subset < 1U << cell.size(); ++subset) {
        std::vector<VertexId> face;
        for (std::size_t i = 0; i < cell.size(); ++i)
          if ((subset >> i & 1U) != 0) face.push_back(cell[i]);
        expected.insert(face);
      }
    }
    std::size_t count = 0;
    for (int k = 0; k <= D; ++k) {
      const Simplices<D> simplices(cut.after, k);
      count += simplices.count();
      for (std::size_t i = 0; i < simplices.count(); ++i) {
        const std::vector<VertexId> simplex(simplices[i].begin(), simplices[i].end());
        RC_ASSERT(expected.count(simplex) == 1U);
        RC_ASSERT((i == 0 ||
                   std::lexicographical_compare(simplices[i - 1].begin(), simplices[i - 1].end(),
                                                simplex.begin(), simplex.end())));
      }
    }
    RC_ASSERT(count == expected.size());  // each once, so every subset of a simplex is one
  });
}

}  // namespace
}  // namespace cleave::topology
