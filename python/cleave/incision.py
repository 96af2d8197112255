"""A mesh that is cut and stitched step by step."""

from __future__ import annotations

from dataclasses import dataclass
from typing import List, NamedTuple, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from .arrays import Ids, as_ids, as_signs, half_facets_of, vertex_count_of
from .checking import orient


@dataclass(frozen=True)
class Relabelling:
    """What a change did: a value, as large as the change.

    vertices_before, vertices_after: bounds on vertex ids. corners: (n, 3) corner, vertex before,
    vertex after. splits: (n, 2) new vertex, the vertex it copies. merges: (n, 2) vertex that ceased
    to exist, the vertex its corners have now. opened: (n, 3) two half-facets that are boundary now,
    and a vertex that separates them. closed: (n, 3) two half-facets that are mates again,
    and a vertex that would separate them. shut:
    half-facets of facets asked for that stay interior.
    """

    vertices_before: int
    vertices_after: int
    corners: Ids
    splits: Ids
    merges: Ids
    opened: Ids
    closed: Ids
    shut: Ids

    def carry_over(self, per_vertex: NDArray) -> NDArray:
        """Data per vertex after the change: (vertices_before, ..) in, (vertices_after, ..) out, a
        new array. Copies get the value of the vertex they copy. A merged vertex keeps the value of
        the one it is merged into: whoever changed values on copies decides what they become."""
        values = np.asarray(per_vertex)
        if len(values) != self.vertices_before:
            raise ValueError(f"{len(values)} values are given for {self.vertices_before} vertices")
        after = np.zeros((self.vertices_after, *values.shape[1:]), values.dtype)
        kept = min(self.vertices_before, self.vertices_after)
        after[:kept] = values[:kept]
        after[self.splits[:, 0]] = values[self.splits[:, 1]]
        return after


class Because(NamedTuple):
    """Why `vertex` does not separate the cells of a shut facet: a shortest chain of cells around
    it, each joined to the next by a facet at `vertex` that is not scored."""

    vertex: int
    through: List[int]


class Incision:
    """A mesh with its scored facets: all facets asked for and not taken back.

    Those that opened are boundary now; those that are shut open later, when their rim is released.
    The state depends on the mesh and the scored set alone, not on the order of steps (theorems T8
    and T12 of proofs/CLAIMS.md).

    cells: (n, D+1) vertices from 0; they are copied once. vertex_count: see `check`. signs: +1 or -1
    per cell; default: computed (see `orient`). regularize: whether a vertex around which the cells
    fall into several parts is given a copy for each of them; if not, InvalidComplex is raised.
    Raises InvalidComplex, with findings, for what is no orientable pseudo-manifold.
    """

    def __init__(self, cells: ArrayLike, vertex_count: Optional[int] = None, *,
                 signs: Optional[ArrayLike] = None, regularize: bool = False) -> None:
        cells = as_ids(cells, "cells")
        count = vertex_count_of(cells, vertex_count)
        if signs is None:
            signs = orient(cells, count)
        self._core, self._regularized = _core.make_incision(
            cells, count, as_signs(signs, cells), regularize)

    @property
    def cells(self) -> Ids:
        """(n, D+1) vertices as they are now: a read-only view, which shows later changes too.

        Ids of copies are handles in order of opening; `canonical` has numbers that depend on the
        scored set alone."""
        return self._core.cells

    @property
    def vertex_count(self) -> int:
        """Vertex ids are below this number; after a stitch some may be used by no cell."""
        return self._core.vertex_count

    @property
    def regularized(self) -> Ids:
        """(m, 2) copies made at the start, and the vertices they copy."""
        return self._regularized

    @property
    def opened(self) -> Ids:
        """(m, 3) the two half-facets of each opened facet, and a vertex that separates them."""
        return self._core.opened

    @property
    def shut(self) -> Ids:
        """(m,) the lesser half-facets of scored facets that are interior."""
        return self._core.shut

    @property
    def scored(self) -> Ids:
        """(m,) the lesser half-facets of all scored facets."""
        return self._core.scored

    @property
    def parents(self) -> Ids:
        """(vertex_count,) the vertex of the mesh given that each vertex is, or is a copy of."""
        parents = self._core.originals()
        made = np.arange(self._core.original_vertex_count, dtype=np.uint32)
        if len(self._regularized):
            made[self._regularized[:, 0]] = self._regularized[:, 1]
        return made[parents]

    @property
    def canonical(self) -> Ids:
        """(vertex_count,) the canonical number of each vertex: first the vertices at the start, then
        the copies in use by (vertex copied, least corner). 2**32 - 1 for a vertex not in use."""
        return self._core.canonical()

    @property
    def pieces(self) -> Ids:
        """(n,) the piece of each cell, numbered from 0 by least cell."""
        return self._core.pieces()

    @property
    def can_undo(self) -> bool:
        """Whether there is a step to undo."""
        return self._core.can_undo

    @property
    def can_redo(self) -> bool:
        """Whether there is a step to redo."""
        return self._core.can_redo

    def cut(self, facets: ArrayLike, *, verify: str = "touched") -> Relabelling:
        """Scores `facets` and opens what can be opened.

        facets: (m,) half-facets, or (m, D) vertices as in `cells` now. verify: "touched" looks at
        what was changed, "all" at the whole mesh, "none" at nothing. Raises NotInterior for a facet
        that is neither interior nor opened by this incision; nothing is changed then.
        """
        return Relabelling(**self._core.cut(half_facets_of(self.cells, facets), verify))

    def stitch(self, facets: ArrayLike, *, verify: str = "touched") -> Relabelling:
        """Takes `facets` back: they are scored no longer. What opened is interior again; facets
        that were never cut are left alone. facets, verify, errors: see `cut`."""
        return Relabelling(**self._core.stitch(half_facets_of(self.cells, facets), verify))

    def undo(self) -> Relabelling:
        """Takes the last step back. Raises IndexError if there is none."""
        if not self.can_undo:
            raise IndexError("there is no step to undo")
        return Relabelling(**self._core.undo())

    def redo(self) -> Relabelling:
        """Does the last undone step again. Raises IndexError if there is none."""
        if not self.can_redo:
            raise IndexError("there is no step to redo")
        return Relabelling(**self._core.redo())

    def explain(self, half_facet: int) -> List[Because]:
        """Why an interior facet is shut: for each of its vertices a chain of cells around it. An
        empty chain: the vertex would separate the cells, if the facet were scored."""
        if not 0 <= int(half_facet) < self.cells.size:
            raise ValueError(f"there is no half-facet {half_facet}")
        return [Because(*because) for because in self._core.explain(int(half_facet))]
