#pragma once
#include <vector>

#include "cleave/topology/cell_soup.hpp"
#include "cleave/topology/complex.hpp"
#include "cleave/topology/relabelling.hpp"
#include "cleave/topology/run_options.hpp"
#include "cleave/topology/violation.hpp"

namespace cleave::topology {

/// The complex of these cells with these signs. Throws InvalidComplex with the violations up to
/// cut_regular unless `soup` is a coherently oriented, cut-regular pseudo-manifold of distinct
/// cells (orphan vertices are kept and no violation here); std::length_error if ids do not suffice;
/// std::invalid_argument for signs that are not one per cell, each +1 or -1; std::system_error if a
/// thread cannot be started. Time: linear. Peak memory beyond the result, D = 3: 8 bytes per cell,
/// and 4 per vertex for each thread but the first.
template <int D>
Complex<D> assemble(CellSoup<D> soup, const RunOptions& options = {});

/// A complex and what was done to the vertices to make it cut-regular.
template <int D>
struct Regularized {
  Complex<D> complex;
  std::vector<Split> splits;  // new vertices, ascending; empty: the input was cut-regular
};

/// As `assemble`, but first applies unglue(empty set): a vertex whose star falls into several parts
/// gets a copy for each part but the one with its least corner. Copies are numbered from
/// soup.vertex_count on. (Figure 8; T4 and T5 say that nothing else changes.)
template <int D>
Regularized<D> assemble_regularized(CellSoup<D> soup, const RunOptions& options = {});

}  // namespace cleave::topology
