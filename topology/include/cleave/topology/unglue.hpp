#pragma once
#include "cleave/topology/complex.hpp"
#include "cleave/topology/facet_set.hpp"
#include "cleave/topology/relabelling.hpp"

namespace cleave::topology {

/// How much is verified after a change: nothing, the stars it touched, or the whole complex.
enum class Verify { none, touched, all };

/// Separates the cells of `k` along the facets in `cut`, copying vertices where needed. Cells and
/// half-facets keep their numbers. Of the corners at a vertex, the class with the least corner
/// keeps the vertex; the others get new ones, numbered from vertex_count() on in order of parent,
/// then of least corner. Guarantees (T1 to T4): oriented cut-regular pseudo-manifold again; only
/// facets of `cut` open; a facet of `cut` stays interior iff none of its vertices separates its two
/// cells. Throws: std::length_error if the new vertices do not fit the ids, std::bad_alloc,
/// NotInterior for a facet that is none of `k`'s interior facets, InvariantBroken if the
/// verification fails (a defect of ours); `k` is unchanged then. Time: linear in the stars of the
/// cut's vertices (and sorting them), independent of the size of `k`; with Verify::all linear in
/// `k`. Paper: Algorithm 3, section 4.
template <int D>
Relabelling unglue(Complex<D>& k, const FacetSet& cut, Verify verify = Verify::touched);

/// What Verify::touched does: throws InvariantBroken unless, around every corner that `change`
/// names and every facet of `cut`, mates match, have the same vertices and opposite orientations,
/// stars are one part, exactly the facets named as opened have lost their mates, those named as
/// closed have theirs again, and merged vertices have no corner left. `cut` is, for a cut, all
/// scored facets that were interior before; for a stitch the scored facets that closed.
template <int D>
void verify_touched(const Complex<D>& k, const FacetSet& cut, const Relabelling& change);

/// What Verify::all does besides: throws InvariantBroken unless `check` finds no violation up to
/// cut_regular in the whole complex and all mates match. Time: linear in `k`.
template <int D>
void verify_all(const Complex<D>& k);

}  // namespace cleave::topology
