"""A cut in one go, and the check of its result."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple, Optional

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from .arrays import Ids, as_ids, half_facets_of
from .incision import Incision


@dataclass(frozen=True)
class Cut:
    """The result of `cut`.

    cells: (n, D+1) vertices; rows and columns as before, only vertices differ. parents: for each
    vertex now the vertex it is or copies, so that `points[parents]` are the points now. opened:
    (m, 2) the two half-facets of each facet that opened. by: (m,) a vertex that separates them.
    shut: (k,) half-facets of facets asked for that stay interior.
    """

    cells: Ids
    parents: Ids
    opened: Ids
    by: Ids
    shut: Ids


def cut(cells: ArrayLike, facets: ArrayLike, vertex_count: Optional[int] = None, *,
        signs: Optional[ArrayLike] = None, regularize: bool = False) -> Cut:
    """Separates the cells along `facets` by copying vertices; nothing else opens.

    cells: (n, D+1) vertices; they are not changed. facets: (m, D) vertices, or (m,) half-facets, in
    any order. Vertices keep their numbers; copies come after them, numbered by (parent, least
    corner). regularize, signs, errors: see `Incision`. Time: linear in the mesh; a series of cuts is
    cheaper with one `Incision`.
    """
    incision = Incision(cells, vertex_count, signs=signs, regularize=regularize)
    incision.cut(half_facets_of(as_ids(cells, "cells"), facets))
    number = incision.canonical
    used = number != np.uint32(0xFFFFFFFF)
    parents = np.empty(int(np.count_nonzero(used)), np.uint32)
    parents[number[used]] = incision.parents[used]
    opened = incision.opened
    return Cut(number[incision.cells], parents, opened[:, :2].copy(), opened[:, 2].copy(),
               incision.shut)


class Certificate(NamedTuple):
    """The verdict of `certify`: true in an `if` exactly when accepted.

    clause: "" if accepted, else what fails: "not-comparable", "no-parent", "uncut-mates-apart" or
    "class-not-connected"; one, other: corners that show it; message: in plain words.
    """

    accepted: bool
    clause: str = ""
    one: int = 0
    other: int = 0
    message: str = "accepted"

    def __bool__(self) -> bool:
        return self.accepted


_CLAUSES = ("not-comparable", "no-parent", "uncut-mates-apart", "class-not-connected")


def certify(before: ArrayLike, facets: ArrayLike, after: ArrayLike) -> Certificate:
    """Whether `after` is `before`, cut along `facets`, up to the names of vertices.

    before, after: (n, D+1) vertices; facets: (m,) half-facets or (m, D) vertices of `before`. Shares
    no code with `cut`. Time: n log n. 32-bit integers in C order are not copied.
    """
    before = as_ids(before, "cells before")
    after = as_ids(after, "cells after")
    rejection = _core.certify(before, half_facets_of(before, facets), after)
    if rejection is None:
        return Certificate(True)
    clause, one, other, message = rejection
    return Certificate(False, _CLAUSES[clause], one, other, message)
