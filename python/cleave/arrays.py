"""Arrays as the library wants them, and facets by their vertices."""

from __future__ import annotations

from typing import Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core

Ids = NDArray[np.uint32]

_SPARSE = 16  # numbers of vertices for each corner of a cell: more are a mistake


def as_ids(numbers: ArrayLike, what: str, ndim: int = 2) -> Ids:
    """`numbers` as uint32 in C order. Without copying if they are 32-bit integers in C order
    already."""
    array = np.asarray(numbers)
    if array.size == 0 and array.ndim < ndim:
        array = array.reshape((0,) * ndim)
    if array.ndim != ndim:
        raise ValueError(f"{what}: an array of {ndim} dimensions is needed, not of {array.ndim}")
    if array.size == 0:
        return array.astype(np.uint32)
    if array.dtype.kind not in "iu":
        raise TypeError(f"{what}: integers are needed, not {array.dtype}")
    if array.min() < 0:
        raise ValueError(f"{what}: {array.min()} is negative")
    if array.max() >= 2**32 - 1:
        raise ValueError(f"{what}: {array.max()} is more than 32-bit numbers hold")
    if array.dtype == np.int32:
        array = np.ascontiguousarray(array).view(np.uint32)
    return np.ascontiguousarray(array, dtype=np.uint32)


def as_signs(signs: Optional[ArrayLike], cells: Ids) -> NDArray[np.int8]:
    """One sign per cell, or none at all: all cells as written."""
    if signs is None:
        return np.empty(0, np.int8)
    array = np.ascontiguousarray(signs, dtype=np.int8)
    if array.shape != (len(cells),):
        raise ValueError(f"one sign per cell is needed: {len(cells)}, there are {array.size}")
    return array


def vertex_count_of(cells: Ids, vertex_count: Optional[int]) -> int:
    """The number given, or one more than the largest vertex. Vertices that leave most numbers out
    (tags of a file, say) are refused: time and memory go with the largest number."""
    if vertex_count is None:
        count = int(cells.max()) + 1 if cells.size else 0
        if count > _SPARSE * cells.size + _SPARSE:
            raise ValueError(f"the largest vertex is {count - 1}, but the cells have only "
                             f"{cells.size} corners: number the vertices densely, `_, rows = "
                             "np.unique(cells, return_inverse=True)`, or give vertex_count")
        return count
    if vertex_count < 0:
        raise ValueError("vertex_count is negative")
    return int(vertex_count)


def locate(cells: ArrayLike, facets: ArrayLike) -> Ids:
    """The least half-facet with the vertices of each row of `facets`.

    cells: (n, D+1) vertices; facets: (m, D) vertices in any order. Returns (m,) half-facets. Raises
    ValueError that names the first row that is a facet of no cell. Time: linear.
    """
    cells = as_ids(cells, "cells")
    facets = as_ids(facets, "facets")
    if facets.size == 0:
        return np.empty(0, np.uint32)
    found = _core.locate(cells, facets)
    missing = np.flatnonzero(found < 0)
    if missing.size:
        row = int(missing[0])
        raise ValueError(f"row {row} of the facets, {facets[row].tolist()}, is a facet of no cell; "
                         f"{missing.size} of {len(facets)} are not")
    return found.astype(np.uint32)


def facets_of(cells: ArrayLike, half_facets: ArrayLike) -> Ids:
    """The (m, D) vertices of (m,) half-facets, in the order of their cells' rows."""
    cells = as_ids(cells, "cells")
    half_facets = as_ids(half_facets, "half-facets", ndim=1)
    columns = cells.shape[1]
    if half_facets.size and half_facets.max() >= cells.size:
        raise ValueError(f"there is no half-facet {half_facets.max()}")
    rows = cells[half_facets // columns]
    keep = np.arange(columns)[None, :] != (half_facets % columns)[:, None]
    return rows[keep].reshape(len(half_facets), columns - 1)


def half_facets_of(cells: Ids, facets: ArrayLike) -> Ids:
    """Half-facets as they are (one dimension), or located (rows of vertices)."""
    array = np.asarray(facets)
    if array.ndim == 1:
        return as_ids(array, "half-facets", ndim=1)
    return locate(cells, array)
