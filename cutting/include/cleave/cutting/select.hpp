#pragma once
#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

#include "cleave/cutting/sweep.hpp"
#include "cleave/topology/complex.hpp"
#include "cleave/topology/facet_set.hpp"
#include "cleave/topology/incision.hpp"

namespace cleave::cutting {

/// How facets are chosen. docs/selection.md compares the rules.
/// dual_edge: a facet is chosen when the segment between the dual points of its two cells crosses
/// the step an odd number of times. Then an interior ridge has an even number of chosen facets if
/// the rim of the step passes through no triangle of a point of the ridge and the dual points of
/// two neighbouring cells around it. If so it is at all interior ridges, and no hole goes through
/// the body, the step chooses exactly the facets between two sets of cells; a ring that is crossed
/// once opens and stays in one piece.
/// nearest_vertex: Nienhuys & van der Stappen 2000, section 3: where an edge of a cell crosses the
/// sweep, the end closest to the crossing is put into the cell's set, which grows from step to
/// step; a cell whose set has exactly D vertices chooses the facet they span.
enum class Rule { dual_edge, nearest_vertex };

/// nearest_vertex only: which end of an edge is put into the set when both are equally close: the
/// one with the lesser id, so that one plane puts at most D vertices of a cell into its set (Lemma
/// 1, mended), or both, which is the paper's text.
enum class Ties { by_id, both };

struct SelectOptions {
  Rule rule = Rule::dual_edge;
  Ties ties = Ties::by_id;
};

/// The dual point of a cell: the centroid of its vertices in doubles. All facets of the cell share
/// it to the last bit, which is what the dual-edge rule relies on.
template <int D>
Point<D> dual_point(const topology::Complex<D>& k, const std::vector<Point<D>>& points,
                    topology::CellId cell);

/// Which of a cell's vertices are in its set (nearest_vertex) after `simplices`: `places` has their
/// points, in the order of `cell`. Finite points; flat simplices put in nothing.
template <int D>
std::array<bool, static_cast<std::size_t>(D) + 1> nearest_vertices(
    const topology::Cell<D>& cell,
    const std::array<Point<D>, static_cast<std::size_t>(D) + 1>& places,
    std::span<const std::array<Point<D>, static_cast<std::size_t>(D)>> simplices, Ties ties);

/// The sets of a stroke so far (nearest_vertex): for each cell whose set is not empty, which of its
/// local vertices are in it, as bits.
using ClosestSets = std::unordered_map<topology::CellId, unsigned>;

/// Answers, for one complex in rest coordinates, which interior facets a step of a sweep chooses.
/// Holds references to `k` and `points` and reads them anew each time, so it follows cuts of `k`
/// (`points` must be extended by one entry per copy, at its parent's place); it must be made anew
/// after anything that gives facets back their mates. All signs are exact on the doubles given. On
/// an exact zero the sweep counts as translated by (e, e^2, e^3), e -> 0+; simplices that are flat
/// choose nothing. Const members may be called from several threads at once.
template <int D>
class Selector {
  static_assert(D == 2 || D == 3);

 public:
  using Simplex = std::array<Point<D>, static_cast<std::size_t>(D)>;

  /// Throws std::invalid_argument if `points` has not one entry per vertex of `k`, or a vertex of a
  /// cell has a coordinate that is not finite.
  /// Time: O(n log n) in the cells. Memory: 20 to 40 bytes per cell, and 70 more while it is built.
  Selector(const topology::Complex<D>& k, const std::vector<Point<D>>& points,
           SelectOptions options = {});

  /// The same for an incision's complex; Ties::by_id goes by the ids of the original vertices, so
  /// that the choice does not depend on how copies happen to be numbered.
  Selector(const topology::Incision<D>& incision, const std::vector<Point<D>>& points,
           SelectOptions options = {});

  /// Views of temporaries.
  Selector(topology::Complex<D>&&, const std::vector<Point<D>>&, SelectOptions = {}) = delete;
  Selector(const topology::Complex<D>&, std::vector<Point<D>>&&, SelectOptions = {}) = delete;
  Selector(topology::Incision<D>&&, const std::vector<Point<D>>&, SelectOptions = {}) = delete;
  Selector(const topology::Incision<D>&, std::vector<Point<D>>&&, SelectOptions = {}) = delete;

  ~Selector();
  Selector(Selector&&) noexcept;
  Selector& operator=(Selector&&) noexcept;

  /// The interior facets that `simplices`, taken as one step, choose. Throws std::invalid_argument
  /// for a coordinate that is not finite.
  /// Time: per simplex logarithmic in the cells, plus some signs for each cell whose surroundings
  /// (of a few cells) the simplex, widened to its bounding box within its own plane, passes
  /// through.
  topology::FacetSet select(std::span<const Simplex> simplices) const;

  /// As `select`, of one step of a stroke after others: the facets whose choice it changes.
  /// dual_edge: those that the step alone chooses. nearest_vertex: `sets`, empty before the first
  /// step, grow by what the step puts into them, and the result are the facets that now are chosen
  /// and were not, or were and are no longer.
  topology::FacetSet toggle(std::span<const Simplex> simplices, ClosestSets& sets) const;

  /// What step `step` of `sweep` alone chooses; steps from step_count() on are empty. Throws
  /// std::invalid_argument for a sweep that require_valid refuses, which is checked in linear time:
  /// who walks through many steps calls require_valid once, and `select`.
  topology::FacetSet select_step(const Sweep<D>& sweep, std::size_t step) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace cleave::cutting
