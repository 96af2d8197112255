// certify accepts unglue's results and nothing else.
#include "cleave/topology/certify.hpp"

#include <algorithm>
#include <map>

#include "property.hpp"

namespace cleave::topology {
namespace {

CLEAVE_PROPERTIES(Certify);

template <int D>
using Cells = std::vector<Cell<D>>;

template <int D>
Cells<D> cells_of(const Complex<D>& k) {
  return {k.cells().begin(), k.cells().end()};
}

TYPED_TEST(Certify, AcceptsEveryResultUnderEveryNaming) {
  constexpr int D = TypeParam::value;
  for_all<D>([](const Trial<D>& trial) {
    const Cut<D> cut(trial);
    Rng rng = trial.rng();
    // Half-facets of the boundary may be named, and mean nothing.
    std::vector<HalfFacetId> asked = trial.cut;
    for (Index h = 0; h < cut.before.half_facet_count(); ++h)
      if (!cut.before.is_interior({h}) && rng.chance(0.1)) asked.push_back({h});
    Cells<D> after = cells_of(cut.after);
    RC_ASSERT(!certify<D>(cut.before.cells(), asked, after));
    std::vector<Index> names(cut.after.vertex_count());
    const std::uint32_t stride = rng.chance(0.5) ? 3 : 1000003;  // more than there are corners
    for (Index v = 0; v < names.size(); ++v) names[v] = stride * v + 1;
    rng.shuffle(names);
    for (Cell<D>& cell : after)
      for (VertexId& v : cell) v = {names[v.value]};
    RC_ASSERT(!certify<D>(cut.before.cells(), asked, after));
    RC_ASSERT(!certify<D>(cut.before.cells(), asked, trial.expected));
  });
}

enum class Mutation { wrong_vertex, lost_split, extra_split, swapped_cells, other_cut };

/// Does to `cells` what the name says, at random; without effect where there is nothing to do it
/// to.
template <int D>
void mutate(Cells<D>& cells, Mutation mutation, const Cut<D>& cut, Rng& rng) {
  const auto count = static_cast<Index>(cut.after.vertex_count());
  const std::size_t at = rng.below(cells.size());
  const std::size_t i = rng.below(static_cast<std::size_t>(D) + 1);
  switch (mutation) {
    case Mutation::wrong_vertex:
      cells[at][i] = {static_cast<Index>(rng.below(count))};
      break;
    case Mutation::lost_split:
      if (!cut.change.splits.empty()) {
        const Split& split = rng.pick(cut.change.splits);
        for (Cell<D>& cell : cells)
          std::replace(cell.begin(), cell.end(), split.vertex, split.parent);
      }
      break;
    case Mutation::extra_split: {
      const VertexId vertex = cells[at][i];
      for (Cell<D>& cell : cells)
        if (rng.chance(0.5)) std::replace(cell.begin(), cell.end(), vertex, VertexId{count});
      break;
    }
    case Mutation::swapped_cells:
      std::swap(cells[at], cells[rng.below(cells.size())]);
      break;
    case Mutation::other_cut: {
      Complex<D> k = cut.before;
      auto facets = std::vector<HalfFacetId>(cut.facets.half_facets().begin(),
                                             cut.facets.half_facets().end());
      if (!facets.empty())
        facets.erase(facets.begin() + static_cast<int>(rng.below(facets.size())));
      unglue(k, FacetSet::of_lesser(facets));
      cells = cells_of(k);
      break;
    }
  }
}

template <int D>
bool share_uncut_facet(const Cells<D>& cells, const FacetSet& cut, CellId one, CellId other) {
  const auto mates = support::mates_of<D>(cells);
  for (int i = 0; i <= D; ++i) {
    const HalfFacetId h = half_facet<D>(one, i);
    const auto mate = mates[h.value];
    if (mate && cell_of<D>(*mate) == other && !cut.contains(std::min(h, *mate))) return true;
  }
  return false;
}

/// Looks at the corners a rejection names and says whether they show what it claims.
template <int D>
bool shows(const Rejection& rejection, const Cells<D>& before, const FacetSet& cut,
           const Cells<D>& after) {
  const auto vertex = [](const Cells<D>& cells, CornerId corner) {
    return cells[cell_of<D>(corner).value][static_cast<std::size_t>(local_index<D>(corner))];
  };
  const CornerId one = rejection.one;
  const CornerId other = rejection.other;
  switch (rejection.clause) {
    case Rejection::Clause::cells:
      return before.size() != after.size();
    case Rejection::Clause::parent:
      return vertex(after, one) == vertex(after, other) &&
             vertex(before, one) != vertex(before, other);
    case Rejection::Clause::uncut:
      return vertex(before, one) == vertex(before, other) &&
             vertex(after, one) != vertex(after, other) &&
             share_uncut_facet<D>(before, cut, cell_of<D>(one), cell_of<D>(other));
    case Rejection::Clause::connected: {
      const auto apart = support::algorithm_3<D>(before, cut.half_facets());
      return vertex(after, one) == vertex(after, other) &&
             vertex(before, one) == vertex(before, other) &&
             vertex(apart, one) != vertex(apart, other);
    }
  }
  return false;
}

TYPED_TEST(Certify, RejectsExactlyTheMutationsThatAreNotIsomorphic) {
  constexpr int D = TypeParam::value;
  std::map<Mutation, std::size_t> rejected;
  std::size_t cases = 0;
  for_all<D>([&](const Trial<D>& trial) {
    const Cut<D> cut(trial);
    Rng rng = trial.rng();
    ++cases;
    for (const Mutation mutation :
         {Mutation::wrong_vertex, Mutation::lost_split, Mutation::extra_split,
          Mutation::swapped_cells, Mutation::other_cut}) {
      Cells<D> mutant = cells_of(cut.after);
      mutate<D>(mutant, mutation, cut, rng);
      const bool isomorphic = support::same_partition<D>(mutant, trial.expected);
      const auto rejection = certify<D>(cut.before.cells(), trial.cut, mutant);
      RC_ASSERT(isomorphic == !rejection);
      if (!rejection) continue;
      ++rejected[mutation];
      RC_ASSERT(shows<D>(*rejection, cells_of(cut.before), cut.facets, mutant));
      RC_ASSERT(!describe(*rejection).empty());
    }
    Cells<D> fewer = cells_of(cut.after);
    fewer.pop_back();
    const auto rejection = certify<D>(cut.before.cells(), trial.cut, fewer);
    RC_ASSERT((rejection && rejection->clause == Rejection::Clause::cells));
  });
  if (cases < 100) return;  // RC_PARAMS asked for fewer
  for (const Mutation mutation :
       {Mutation::wrong_vertex, Mutation::lost_split, Mutation::extra_split,
        Mutation::swapped_cells, Mutation::other_cut})
    EXPECT_GE(20 * rejected[mutation], cases) << "mutation " << static_cast<int>(mutation);
}

}  // namespace
}  // namespace cleave::topology
