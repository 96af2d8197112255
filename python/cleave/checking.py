"""What is wrong with a mesh."""

from __future__ import annotations

from typing import List, NamedTuple, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from .arrays import as_ids, as_signs, vertex_count_of
from .errors import Finding


class Check(NamedTuple):
    """What `check` found.

    findings: all violations, those of cells first; level: the highest level the mesh reaches:
    "none", "pseudo-manifold", "cut-regular", "edge-regular" or "manifold"; pieces,
    boundary_components, euler_characteristic: of the mesh as it is, valid or not.
    """

    findings: List[Finding]
    level: str
    pieces: int
    boundary_components: int
    euler_characteristic: int

    @property
    def can_be_cut(self) -> bool:
        """Whether `Incision` takes these cells as they are."""
        return all(finding.rule == "orphan-vertex" or finding.level in ("edge-regular", "manifold")
                   for finding in self.findings)


def check(cells: ArrayLike, vertex_count: Optional[int] = None, *,
          signs: Optional[ArrayLike] = None, level: str = "manifold") -> Check:
    """All violations of a mesh, each with a witness.

    cells: (n, D+1) vertices from 0, D = 1 .. 4. 32-bit integers in C order are not copied.
    vertex_count: the number of vertices, if some may be used by no cell. signs: +1 or -1 per cell,
    the orientation relative to its row; default all +1. level: how far to look. Time: linear up to
    "cut-regular". Says nothing about coordinates: `cleave check` does.
    """
    cells = as_ids(cells, "cells")
    count = vertex_count_of(cells, vertex_count)
    found, reached = _core.check(cells, count, as_signs(signs, cells), level)
    return Check([Finding(*finding) for finding in found], reached, *_core.summarize(cells, count))


def orient(cells: ArrayLike, vertex_count: Optional[int] = None) -> NDArray[np.int8]:
    """Signs, +1 or -1 per cell, that make the orientations of neighbours agree; the first cell of
    each piece gets +1. Raises InvalidComplex with a loop of cells if there are none."""
    cells = as_ids(cells, "cells")
    return _core.orient(cells, vertex_count_of(cells, vertex_count))
