"""Splits simplicial meshes along their own facets, and stitches them back.

Cells are rows of D+1 vertices in a NumPy array: edges (2 columns), triangles (3), tetrahedra (4) or
4-simplices (5). Facets are rows of D vertices, or half-facets: half-facet (D+1)*c + i is the facet
of cell c opposite its i-th vertex, so `half_facets // (D+1)` are cells.

    cut = cleave.cut(cells, facets)     # cut.cells, cut.parents: copies follow their parents
    points = points[cut.parents]

`Incision` is the same step by step, with `stitch`, `undo` and `redo`. `check` says what is wrong
with a mesh, `certify` whether a result is right. `cleave.meshio` does it all on meshio's meshes.
"""

from .arrays import facets_of, locate
from .checking import Check, check, orient
from .cutting import Certificate, Cut, certify, cut
from .errors import Finding, InvalidComplex, InvariantBroken, NotInterior
from .incision import Because, Incision, Relabelling

__all__ = [
    "Because", "Certificate", "Check", "Cut", "Finding", "Incision", "InvalidComplex",
    "InvariantBroken", "NotInterior", "Relabelling", "certify", "check", "cut", "facets_of",
    "locate", "orient",
]
__version__ = "0.2.0"
