"""The paper's Algorithm 3 by brute force on corners: shares no code with the library."""

import itertools

import numpy as np


def unglue(cells, cut):
    """Cells after the cut, canonically numbered, and the parents. cut: sorted vertex tuples."""
    n, columns = cells.shape
    vertex_count = int(cells.max()) + 1
    parent = list(range(n * columns))

    def find(i):
        while parent[i] != i:
            parent[i] = parent[parent[i]]
            i = parent[i]
        return i

    by_facet = {}
    for c, row in enumerate(cells.tolist()):
        for facet in itertools.combinations(sorted(row), columns - 1):
            by_facet.setdefault(facet, []).append(c)
    for facet, around in by_facet.items():
        if facet in cut or len(around) < 2:
            continue
        for v in facet:
            one, other = (columns * c + cells[c].tolist().index(v) for c in around)
            a, b = sorted((find(one), find(other)))
            parent[b] = a
    after = cells.astype(np.int64).copy()
    least = {}
    for corner in range(n * columns):
        least.setdefault(int(cells.flat[corner]), []).append(find(corner))
    number, parents = {}, list(range(vertex_count))
    for v in sorted(least):
        for i, root in enumerate(sorted(set(least[v]))):
            number[root] = v if i == 0 else len(parents)
            if i > 0:
                parents.append(v)
    for corner in range(n * columns):
        after.flat[corner] = number[find(corner)]
    return after, np.array(parents)


def grid(dimension, size):
    """The Kuhn triangulation of a cube of size^dimension: (cells, points)."""
    strides = [(size + 1) ** k for k in range(dimension)]
    cells = []
    for corner in itertools.product(range(size), repeat=dimension):
        start = sum(x * s for x, s in zip(corner, strides))
        for order in itertools.permutations(range(dimension)):
            row = [start]
            for axis in order:
                row.append(row[-1] + strides[axis])
            cells.append(row)
    points = [[(v // s) % (size + 1) for s in strides]
              for v in range((size + 1) ** dimension)]
    return np.array(cells, dtype=np.uint32), np.array(points, dtype=float)


def interior_facets(cells):
    """The sorted vertex tuples of all facets between two cells."""
    count = {}
    for row in cells.tolist():
        for facet in itertools.combinations(sorted(row), cells.shape[1] - 1):
            count[facet] = count.get(facet, 0) + 1
    return [facet for facet, n in sorted(count.items()) if n == 2]
