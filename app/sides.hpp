#pragma once
#include <span>
#include <vector>

#include "cleave/topology/complex.hpp"

namespace cleave::app {

/// Which side of each opened facet is its minus side.
struct Sides {
  std::vector<topology::HalfFacetId> minus;  // per facet: one of its two half-facets
  std::vector<std::vector<topology::HalfFacetId>>
      one_sided;  // per one-sided sheet: a loop of facets
};

/// Chooses sides for interior facets of `k`, the complex before the cut; `facets` are their lesser
/// half-facets, ascending. Facets that meet in a ridge of exactly two of them form a sheet, along
/// which minus lies on one side. The least facet of the sheet decides: its minus is the half-facet
/// in `preferred` (parallel to `facets`). A sheet with only one side is reported by the loop that
/// shows it, and stays broken at the ridge where the loop closes. Time: n log n in the facets.
template <int D>
Sides choose_sides(const topology::Complex<D>& k, std::span<const topology::HalfFacetId> facets,
                   std::span<const topology::HalfFacetId> preferred);

}  // namespace cleave::app
