#pragma once
#include <memory>
#include <span>

#include "cleave/cutting/sweep.hpp"
#include "cleave/topology/complex.hpp"
#include "cleave/topology/facet_set.hpp"

namespace cleave::cutting {

/// How facets are chosen (DESIGN: docs/selection.md has the evidence).
/// dual_edge: a facet is chosen when the segment between the dual points of its two cells crosses the
/// step an odd number of times (definition D1, theorem B: never an odd ridge away from the rim).
/// nearest_vertex: the paper's rule, section 3: union of the closest-vertex sets over the step; a
/// cell whose set has exactly three vertices (D = 3; two when D = 2) chooses the facet they span.
enum class Rule { dual_edge, nearest_vertex };

/// nearest_vertex only: whether an edge whose ends are equally close selects both (the paper's text)
/// or the one with the lesser id, so that no tie alone selects a whole cell (Lemma 1, mended).
enum class Ties { by_id, both };

struct SelectOptions {
  Rule rule = Rule::dual_edge;
  Ties ties = Ties::by_id;
};

/// Answers, for one complex in rest coordinates, which interior facets a step of a sweep chooses.
/// Holds references to `k` and `points`; follows cuts of `k` by reading it anew (points must have
/// one entry per vertex of `k`, copies at their parent's place). All signs are exact on the doubles
/// given; on an exact zero the sweep counts as translated by (e, e^2, e^3), e -> 0+.
template <int D>
  requires(D == 2 || D == 3)
class Selector {
 public:
  /// Time: linear in the cells (dual points, search index).
  Selector(const topology::Complex<D>& k, const std::vector<Point<D>>& points,
           SelectOptions options = {});
  ~Selector();
  Selector(Selector&&) noexcept;
  Selector& operator=(Selector&&) noexcept;

  /// The interior facets that step `step` of `sweep` chooses. Throws std::invalid_argument for a
  /// coordinate that is not finite.
  topology::FacetSet select_step(const Sweep<D>& sweep, std::size_t step) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace cleave::cutting
