// T12 with T8: after any sequence of cuts, stitches, undone and redone steps, saving and loading,
// an incision is what its original and its scored set make it. The model keeps scored sets and
// recomputes everything else from scratch.
#include <algorithm>
#include <iostream>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "cleave/topology/assemble.hpp"
#include "cleave/topology/carry_over.hpp"
#include "cleave/topology/certify.hpp"
#include "cleave/topology/incision.hpp"
#include "property.hpp"

namespace cleave::topology {
namespace {

CLEAVE_PROPERTIES(T12);

using Scored = std::set<HalfFacetId>;

FacetSet facet_set(const Scored& scored) {
  return FacetSet::of_lesser({scored.begin(), scored.end()});
}

template <int D>
std::vector<Cell<D>> cells_of(const Complex<D>& k) {
  return {k.cells().begin(), k.cells().end()};
}

/// The cells as a writer sees them.
template <int D>
std::vector<Cell<D>> written(const Incision<D>& incision) {
  const auto number = canonical(incision);
  auto cells = cells_of(incision.complex());
  for (Cell<D>& cell : cells)
    for (VertexId& v : cell) v = number[v.value];
  return cells;
}

/// The least vertex of facet `h` of `joined` at which its sides have different vertices in `apart`,
/// which has the same cells.
template <int D>
VertexId separator(const std::vector<Cell<D>>& joined, const std::vector<Cell<D>>& apart,
                   HalfFacetId h, HalfFacetId mate) {
  std::optional<VertexId> least;
  const Index one = cell_of<D>(h).value, other = cell_of<D>(mate).value;
  for (std::size_t i = 0; i <= D; ++i)
    for (std::size_t j = 0; j <= D; ++j)
      if (joined[one][i] == joined[other][j] && apart[one][i] != apart[other][j])
        least = std::min(least.value_or(joined[one][i]), joined[one][i]);
  RC_ASSERT(least.has_value());
  return *least;
}

/// What a step of the incision must have told, from the cells before and after it.
template <int D>
void check_change(const std::vector<Cell<D>>& before, const std::vector<Cell<D>>& after,
                  std::span<const Cell<D>> original, const Relabelling& change) {
  std::vector<RenamedCorner> renamed;
  std::set<VertexId> used_before, used_after;
  for (std::size_t c = 0; c < before.size(); ++c)
    for (std::size_t i = 0; i <= D; ++i) {
      const CornerId corner = half_facet<D>({static_cast<Index>(c)}, static_cast<int>(i));
      if (before[c][i] != after[c][i]) renamed.push_back({corner, before[c][i], after[c][i]});
      used_before.insert(before[c][i]);
      used_after.insert(after[c][i]);
    }
  RC_ASSERT(change.corners == renamed);
  std::vector<VertexId> made, gone;
  for (const Split& split : change.splits) made.push_back(split.vertex);
  for (const Merge& merge : change.merges) gone.push_back(merge.vertex);
  std::vector<VertexId> expected_made, expected_gone;
  std::set_difference(used_after.begin(), used_after.end(), used_before.begin(), used_before.end(),
                      std::back_inserter(expected_made));
  std::set_difference(used_before.begin(), used_before.end(), used_after.begin(), used_after.end(),
                      std::back_inserter(expected_gone));
  RC_ASSERT(made == expected_made);
  RC_ASSERT(gone == expected_gone);
  for (const RenamedCorner& corner : renamed)
    RC_ASSERT((change.parent(corner.to) == corner.from || change.merged(corner.from) == corner.to));

  const auto was_open = support::opened_facets<D>(original, before);
  const auto is_open = support::opened_facets<D>(original, after);
  const auto mates = support::mates_of<D>(original);
  std::vector<OpenedFacet> opened, closed;
  for (const HalfFacetId h : is_open)
    if (!std::binary_search(was_open.begin(), was_open.end(), h))
      opened.push_back({h, *mates[h.value], separator<D>(before, after, h, *mates[h.value])});
  for (const HalfFacetId h : was_open)
    if (!std::binary_search(is_open.begin(), is_open.end(), h))
      closed.push_back({h, *mates[h.value], separator<D>(after, before, h, *mates[h.value])});
  RC_ASSERT(change.opened == opened);
  RC_ASSERT(change.closed == closed);

  const Relabelling back = inverse(change), again = inverse(back);
  RC_ASSERT((back.splits.size() == change.merges.size() && back.opened == change.closed &&
             back.vertices_before == change.vertices_after));
  RC_ASSERT((again.corners == change.corners && again.splits == change.splits &&
             again.merges == change.merges && again.opened == change.opened &&
             again.closed == change.closed && again.vertices_before == change.vertices_before &&
             again.vertices_after == change.vertices_after));
}

/// An incision under test beside its model.
template <int D>
class Sequence {
 public:
  explicit Sequence(const Trial<D>& trial)
      : signs_(trial.signs),
        original_(cells_of(trial.complex())),
        interior_(support::interior_facets<D>(original_)),
        mates_(support::mates_of<D>(original_)),
        rng_(trial.rng()),
        incision_(trial.complex()) {
    for (const HalfFacetId h : trial.cut) favourites_.push_back(std::min(h, *mates_[h.value]));
    cut(favourites_);
  }

  /// What this sequence is an instance of.
  const std::set<std::string>& met() const { return met_; }

  void step() {
    switch (rng_.below(7)) {
      case 0:
        return cut(some(interior_, 0.1));
      case 1:
        return cut(some(favourites_, 0.5));
      case 2:
        return stitch(some(interior_, 0.5));
      case 3:
        return stitch(some({scored_.begin(), scored_.end()}, 0.2));
      case 4:
        for (std::size_t steps = 1 + rng_.below(4); steps > 0 && incision_.can_undo(); --steps)
          undo();
        return;
      case 5:
        return incision_.can_redo() ? redo() : stitch(favourites_);
      default:
        return rng_.chance(0.4) ? save_and_load() : forget_shut();
    }
  }

 private:
  struct Step {
    Scored facets;
    bool added;
  };

  std::vector<HalfFacetId> some(const std::vector<HalfFacetId>& facets, double chance) {
    std::vector<HalfFacetId> drawn;
    for (const HalfFacetId h : facets)
      if (rng_.chance(chance)) drawn.push_back(h);
    if (drawn.empty() && !facets.empty()) drawn.push_back(rng_.pick(facets));
    return drawn;
  }

  void cut(std::vector<HalfFacetId> facets) {
    for (HalfFacetId& h : facets)
      if (rng_.chance(0.5)) h = *mates_[h.value];
    const FacetSet asked = incision_.facets(facets);
    Step step{{}, true};
    for (const HalfFacetId h : asked.half_facets())
      if (!scored_.contains(h)) step.facets.insert(h);
    observe([&] { return incision_.cut(asked, Verify::all); }, &step);
    met_.insert("cut");
  }

  void stitch(const std::vector<HalfFacetId>& facets) {
    const FacetSet asked = incision_.facets(facets);
    Step step{{}, false};
    for (const HalfFacetId h : asked.half_facets())
      if (scored_.contains(h)) step.facets.insert(h);
    const FacetSet shut = incision_.shut();
    const auto planned = incision_.planned_merges(asked);
    const auto change = observe([&] { return incision_.stitch(asked, Verify::all); }, &step);
    RC_ASSERT(change.merges == planned);
    RC_ASSERT(FacetSet::of_lesser(change.shut) == (incision_.shut() - shut));
    if (step.facets.empty()) met_.insert("stitch of nothing");
    if (!(shut & facet_set(step.facets)).empty()) met_.insert("stitch of shut facets");
    if (!change.closed.empty()) met_.insert("stitch of opened facets");
    if (!change.shut.empty()) met_.insert("stitch that shuts others");
    for (std::size_t n = 1; n < change.merges.size(); ++n)
      if (change.merges[n].into == change.merges[n - 1].into)
        met_.insert("three vertices merged into one");
  }

  void forget_shut() {
    Step step{{}, false};
    for (const HalfFacetId h : interior_)
      if (incision_.shut().contains(h) && rng_.chance(0.5)) step.facets.insert(h);
    const auto before = cells_of(incision_.complex());
    incision_.forget_shut(facet_set(step.facets));
    RC_ASSERT(cells_of(incision_.complex()) == before);
    follow(&step);
    check_state();
  }

  void undo() {
    RC_ASSERT(!done_.empty());
    const Step step = done_.back();
    done_.pop_back();
    undone_.push_back(step);
    for (const HalfFacetId h : step.facets)
      step.added ? void(scored_.erase(h)) : void(scored_.insert(h));
    observe([&] { return incision_.undo(Verify::all); }, nullptr);
    met_.insert(undone_.size() > 2 ? "undo, third or later" : "undo");
  }

  void redo() {
    RC_ASSERT(!undone_.empty());
    const Step step = undone_.back();
    undone_.pop_back();
    done_.push_back(step);
    for (const HalfFacetId h : step.facets)
      step.added ? void(scored_.insert(h)) : void(scored_.erase(h));
    observe([&] { return incision_.redo(Verify::all); }, nullptr);
    met_.insert("redo");
  }

  /// What a file keeps: the cells as written, the original of each vertex, the scored facets. The
  /// original complex is made of these again, and cut.
  void save_and_load() {
    const auto cells = written(incision_);
    const auto number = canonical(incision_);
    std::map<VertexId, VertexId> original;
    for (Index v = 0; v < number.size(); ++v) original[number[v]] = incision_.original({v});
    const FacetSet scored = incision_.scored();
    CellSoup<D> soup{cells, incision_.original_vertex_count(), signs_};
    for (Cell<D>& cell : soup.cells)
      for (VertexId& v : cell) v = original.at(v);
    RC_ASSERT(soup.cells == original_);
    incision_ = Incision<D>(assemble(std::move(soup)));
    incision_.cut(scored, Verify::all);
    incision_.forget_steps();
    done_.clear();
    undone_.clear();
    RC_ASSERT(written(incision_) == cells);
    most_copies_ = 0;
    check_state();
    met_.insert("save and load");
  }

  void follow(const Step* step) {
    if (step == nullptr || step->facets.empty()) return;
    for (const HalfFacetId h : step->facets)
      step->added ? void(scored_.insert(h)) : void(scored_.erase(h));
    done_.push_back(*step);
    undone_.clear();
  }

  template <class Action>
  Relabelling observe(Action action, const Step* step) {
    const auto before = cells_of(incision_.complex());
    const std::size_t vertices_before = incision_.complex().vertex_count();
    // Data that is copied and must be equal where it is merged: the original of each vertex.
    std::vector<VertexId> followed(vertices_before);
    for (Index v = 0; v < vertices_before; ++v) followed[v] = incision_.original({v});
    Relabelling change = action();
    follow(step);
    RC_ASSERT(change.vertices_before == vertices_before);
    RC_ASSERT(change.vertices_after == incision_.complex().vertex_count());
    check_change<D>(before, cells_of(incision_.complex()), original_, change);
    carry_over(followed, change);
    for (Index c = 0; c < incision_.complex().half_facet_count(); ++c) {
      const VertexId v = incision_.complex().vertex({c});
      RC_ASSERT(followed[v.value] == incision_.original(v));
    }
    check_state();
    return change;
  }

  void check_state() {
    const Complex<D>& k = incision_.complex();
    const std::vector<HalfFacetId> scored(scored_.begin(), scored_.end());
    const auto cells = cells_of(k);
    RC_ASSERT(incision_.scored() == facet_set(scored_));
    RC_ASSERT((incision_.can_undo() == !done_.empty() && incision_.can_redo() == !undone_.empty()));

    // Algorithm 3 from the start, word for word; and the certificate.
    RC_ASSERT(support::same_partition<D>(cells, support::algorithm_3<D>(original_, scored)));
    RC_ASSERT(!certify<D>(original_, scored, cells));
    const auto mates = support::mates_of<D>(cells);
    for (Index h = 0; h < k.half_facet_count(); ++h) {
      RC_ASSERT(k.mate({h}) == mates[h]);
      RC_ASSERT(incision_.original(k.vertex({h})) ==
                original_[cell_of<D>(HalfFacetId{h}).value]
                         [static_cast<std::size_t>(local_index<D>(HalfFacetId{h}))]);
    }
    std::vector<OpenedFacet> opened;
    for (const HalfFacetId h : support::opened_facets<D>(original_, cells))
      opened.push_back({h, *mates_[h.value], separator<D>(original_, cells, h, *mates_[h.value])});
    RC_ASSERT(incision_.opened() == opened);
    RC_ASSERT(incision_.shut().size() + opened.size() == scored.size());

    Incision<D> fresh(assemble<D>({original_, incision_.original_vertex_count(), signs_}));
    fresh.cut(facet_set(scored_));
    RC_ASSERT(written(incision_) == written(fresh));
    RC_ASSERT(incision_.shut() == fresh.shut());

    // Ids: no more than there were copies at one time.
    const std::size_t originals = incision_.original_vertex_count();
    std::set<VertexId> copies;
    for (const Cell<D>& cell : cells)
      for (const VertexId v : cell)
        if (v.value >= originals) copies.insert(v);
    most_copies_ = std::max(most_copies_, copies.size());
    RC_ASSERT(k.vertex_count() <= originals + most_copies_);
    for (Index v = static_cast<Index>(originals); v < k.vertex_count(); ++v)
      RC_ASSERT(k.a_corner({v}).has_value() == copies.contains({v}));
  }

  std::vector<std::int8_t> signs_;
  std::vector<Cell<D>> original_;
  std::vector<HalfFacetId> interior_, favourites_;
  std::vector<std::optional<HalfFacetId>> mates_;
  Rng rng_;
  Incision<D> incision_;
  Scored scored_;
  std::vector<Step> done_, undone_;
  std::size_t most_copies_ = 0;
  std::set<std::string> met_;
};

TYPED_TEST(T12, TheStateDependsOnTheScoredSetAlone) {
  constexpr int D = TypeParam::value;
  std::size_t sequences = 0;
  std::map<std::string, std::size_t> met;
  for_all<D>([&](const Trial<D>& trial) {
    Sequence<D> sequence(trial);
    for (int steps = 0; steps < 10; ++steps) sequence.step();
    ++sequences;
    for (const std::string& what : sequence.met()) ++met[what];
  });
  std::vector<std::string> wanted{
      "stitch of nothing", "stitch of opened facets", "undo", "undo, third or later", "redo",
      "save and load"};
  // For D = 1 nothing is shut, and a vertex is split into two at most.
  if (D > 1)
    wanted.insert(wanted.end(), {"stitch of shut facets", "stitch that shuts others",
                                 "three vertices merged into one"});
  for (const std::string& what : wanted) {
    std::cout << what << ": " << met[what] << " of " << sequences << " sequences\n";
    if (sequences >= 100) {
      EXPECT_GE(50 * met[what], sequences) << what << " is met too seldom";
    }
  }
}

// The ids, too, when steps are taken back in turn.
TYPED_TEST(T12, TakingTheLatestStepBackGivesTheVeryCells) {
  constexpr int D = TypeParam::value;
  for_all<D>([](const Trial<D>& trial) {
    Incision<D> incision(trial.complex());
    Rng rng = trial.rng();
    std::vector<std::vector<Cell<D>>> states;
    std::vector<std::size_t> bounds;
    const auto interior = support::interior_facets<D>(cells_of(incision.complex()));
    for (int steps = 0; steps < 4; ++steps) {
      states.push_back(cells_of(incision.complex()));
      bounds.push_back(incision.complex().vertex_count());
      Scored facets;
      for (const HalfFacetId h : interior)
        if (rng.chance(0.1)) facets.insert(h);
      facets.insert(rng.pick(interior));
      const std::size_t scored = incision.scored().size();
      incision.cut(facet_set(facets) - incision.scored());
      if (incision.scored().size() == scored) {  // no step
        states.pop_back();
        bounds.pop_back();
      }
    }
    while (incision.can_undo()) {
      incision.undo();
      RC_ASSERT(cells_of(incision.complex()) == states.back());
      RC_ASSERT(incision.complex().vertex_count() == bounds.back());
      states.pop_back();
      bounds.pop_back();
    }
    RC_ASSERT(states.empty());
    while (incision.can_redo()) incision.redo();
    RC_ASSERT_THROWS_AS(incision.redo(), std::logic_error);
  });
}

}  // namespace
}  // namespace cleave::topology
