"""Check, cut and stitch meshio's meshes. Needs meshio."""

from __future__ import annotations

from itertools import combinations
from typing import Dict, List, NamedTuple, Optional, Sequence, Tuple

import meshio
import numpy as np
from numpy.typing import ArrayLike, NDArray

from .arrays import Ids, as_ids, half_facets_of, locate
from .checking import Check
from .checking import check as check_cells
from .cutting import Cut
from .cutting import cut as cut_cells

_DIMENSION = {"vertex": 0, "line": 1, "triangle": 2, "tetra": 3}


class CutMesh(NamedTuple):
    """The mesh after a cut, and the cut of its cells (in their order in the file)."""

    mesh: meshio.Mesh
    cut: Cut


def cells_of(mesh: meshio.Mesh) -> Ids:
    """The (n, D+1) cells: the elements of the highest dimension, block after block. Raises
    ValueError for a mesh that has elements other than vertices, lines, triangles, tetrahedra."""
    dimension = _dimension_of(mesh)
    return as_ids(np.concatenate([block.data for block in mesh.cells
                                  if _DIMENSION[block.type] == dimension]), "cells")


def group_of(mesh: meshio.Mesh, name: str) -> NDArray:
    """The (m, D) vertices of the facet group `name`: a cell set, or a physical group of gmsh."""
    dimension = _dimension_of(mesh)
    blocks = [i for i, block in enumerate(mesh.cells) if _DIMENSION[block.type] == dimension - 1]
    rows = [mesh.cells[i].data[chosen] for i in blocks for chosen in _members(mesh, i, name)]
    if not rows:
        known = sorted({*mesh.cell_sets, *mesh.field_data})
        raise ValueError(f"the mesh has no facets in a group {name!r}; its groups are {known}")
    return np.concatenate(rows)


def check(mesh: meshio.Mesh, level: str = "manifold") -> Check:
    """What is wrong with the cells of `mesh`; see cleave.check."""
    return check_cells(cells_of(mesh), len(mesh.points), level=level)


def cut(mesh: meshio.Mesh, *, group: Optional[Sequence[str]] = None,
        facets: Optional[ArrayLike] = None, regularize: bool = True) -> CutMesh:
    """Separates the cells of `mesh` along facets; `mesh` is not changed.

    group: names of facet groups; facets: (m, D) vertices, or half-facets; one of them. Facets on the
    boundary are left alone. Points and point data follow the vertices they copy, sets of points
    hold the copies too, and there is new point data "parent". Elements of
    lower dimension are there once for each copy, with their cell data and sets; new cell data
    "side" of facets is -1 and +1 on the two sides of an opened facet (by the order of cells; the
    command `cleave cut` chooses them along whole sheets), 0 elsewhere. regularize, errors: see
    cleave.Incision.
    """
    if (group is None) == (facets is None):
        raise ValueError("give either group or facets")
    before = cells_of(mesh)
    if group is not None:
        names = [group] if isinstance(group, str) else list(group)
        wanted = locate(before, np.concatenate([group_of(mesh, name) for name in names]))
    else:
        wanted = half_facets_of(before, facets)
    interior = wanted[_is_interior(before, wanted)]
    result = cut_cells(before, interior, len(mesh.points), regularize=regularize)
    return CutMesh(_rebuild(mesh, before, result), result)


def _dimension_of(mesh: meshio.Mesh) -> int:
    for block in mesh.cells:
        if block.type not in _DIMENSION:
            raise ValueError(f"the mesh has {block.type} elements; cleave works on vertices, lines, "
                             "triangles and tetrahedra of first order")
    dimension = max((_DIMENSION[b.type] for b in mesh.cells if len(b.data)), default=0)
    if dimension == 0:
        raise ValueError("the mesh has no lines, triangles or tetrahedra")
    return dimension


def _members(mesh: meshio.Mesh, block: int, name: str) -> List[NDArray]:
    if name in mesh.cell_sets:
        chosen = mesh.cell_sets[name][block]
        return [] if chosen is None or len(chosen) == 0 else [np.asarray(chosen, dtype=np.int64)]
    if name in mesh.field_data and "gmsh:physical" in mesh.cell_data:
        tag, dimension = (int(number) for number in mesh.field_data[name][:2])
        if _DIMENSION[mesh.cells[block].type] == dimension:
            chosen = np.flatnonzero(mesh.cell_data["gmsh:physical"][block] == tag)
            return [chosen] if len(chosen) else []
    return []


def _is_interior(cells: Ids, half_facets: Ids) -> NDArray[np.bool_]:
    """Whether each facet is between two cells."""
    columns = cells.shape[1]
    counts: Dict[Tuple[int, ...], int] = {}
    asked = [tuple(sorted(np.delete(cells[h // columns], h % columns).tolist()))
             for h in half_facets.tolist()]
    wanted = set(asked)
    near = np.isin(cells, np.unique(np.array(asked, dtype=np.int64))).sum(axis=1) >= columns - 1
    for row in cells[near].tolist():
        for facet in combinations(sorted(row), columns - 1):
            if facet in wanted:
                counts[facet] = counts.get(facet, 0) + 1
    return np.array([counts[facet] > 1 for facet in asked], dtype=bool)


class _Images(NamedTuple):
    """What became of the elements of a block: rows, the element each comes from, and its side."""

    rows: NDArray
    element: NDArray
    side: NDArray


def _rebuild(mesh: meshio.Mesh, before: Ids, result: Cut) -> meshio.Mesh:
    dimension = before.shape[1] - 1
    split = np.zeros(len(mesh.points), bool)
    split[result.parents[len(mesh.points):]] = True
    opened = set(np.ravel(result.opened).tolist())
    cells, images, first = [], [], 0
    for block in mesh.cells:
        if _DIMENSION[block.type] == dimension:
            rows = result.cells[first:first + len(block.data)].astype(np.int64)
            first += len(rows)
            images.append(_Images(rows, np.arange(len(rows)), np.zeros(len(rows), np.int8)))
        else:
            images.append(_images(np.asarray(block.data, dtype=np.int64), before, result.cells,
                                  split, opened))
        cells.append((block.type, images[-1].rows))
    point_data = {name: np.asarray(values)[result.parents]
                  for name, values in mesh.point_data.items()}
    point_data["parent"] = result.parents.astype(np.int64)
    cell_data = {name: [np.asarray(values[i])[image.element] for i, image in enumerate(images)]
                 for name, values in mesh.cell_data.items()}
    cell_data["side"] = [image.side for image in images]
    sets = {name: [None if chosen is None else
                   np.flatnonzero(np.isin(images[i].element, np.asarray(chosen, dtype=np.int64)))
                   for i, chosen in enumerate(blocks)]
            for name, blocks in mesh.cell_sets.items()}
    point_sets = {name: np.flatnonzero(np.isin(result.parents, np.asarray(chosen, dtype=np.int64)))
                  for name, chosen in mesh.point_sets.items()}
    return meshio.Mesh(np.asarray(mesh.points)[result.parents], cells, point_data=point_data,
                       cell_data=cell_data, field_data=mesh.field_data, point_sets=point_sets,
                       cell_sets=sets)


def _images(elements: NDArray, before: Ids, after: Ids, split: NDArray, opened: set) -> _Images:
    """Each element once for each distinct tuple that the cells around it make of it now."""
    columns = before.shape[1]
    corners = elements.shape[1]
    touched = split[elements].any(axis=1)
    wanted = {tuple(sorted(row)): [] for row in elements[touched].tolist()}
    for c in np.flatnonzero(split[before].any(axis=1)).tolist() if wanted else []:
        row, now = before[c].tolist(), after[c].tolist()
        for places in combinations(range(columns), corners):
            known = wanted.get(tuple(sorted(row[i] for i in places)))
            if known is None:
                continue
            renamed = {row[i]: now[i] for i in places}
            opposite = set(range(columns)) - set(places)
            half_facet = columns * c + opposite.pop() if len(opposite) == 1 else -1
            if all(renamed != other for other, _ in known):
                known.append((renamed, half_facet))
    rows: List[List[int]] = []
    element: List[int] = []
    side: List[int] = []
    for e, vertices in enumerate(elements.tolist()):
        found = wanted[tuple(sorted(vertices))] if touched[e] else []
        for n, (renamed, half_facet) in enumerate(found):
            rows.append([renamed[v] for v in vertices])
            element.append(e)
            side.append((-1 if n == 0 else 1) if half_facet in opened else 0)
        if not found:  # no cell around it changed, or there is none
            rows.append(vertices)
            element.append(e)
            side.append(0)
    return _Images(np.array(rows, dtype=np.int64).reshape(-1, corners),
                   np.array(element, dtype=np.int64), np.array(side, dtype=np.int8))
