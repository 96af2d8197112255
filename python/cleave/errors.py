"""What cleave raises besides ValueError and TypeError."""

from __future__ import annotations

from typing import Any, List, NamedTuple


class Finding(NamedTuple):
    """A violation that `check` found, with its witness.

    rule: its name, as `cleave check` and docs/checks have it, e.g. "duplicate-cell"; and
    "vertex-out-of-range" for a number that is not below vertex_count, which no file can hold.
    level: the first level it keeps the mesh from; "none" for orphan vertices and orientation.
    message: one line of plain words.
    witness: numbers that let anyone re-check it: cells, vertices and half-facets, all from 0.
    """

    rule: str
    level: str
    message: str
    witness: dict


class InvalidComplex(ValueError):
    """The cells are no coherently oriented, cut-regular pseudo-manifold: see `findings`."""

    raw_findings: List[Any] = []

    @property
    def findings(self) -> List[Finding]:
        """All violations up to the level `cut-regular`."""
        return [Finding(*finding) for finding in self.raw_findings]


class NotInterior(ValueError):
    """A facet was asked for that is not between two cells: see `half_facet`."""

    half_facet: int = -1


class InvariantBroken(RuntimeError):
    """A verification failed: a defect of cleave, not of the input. Nothing was changed."""
