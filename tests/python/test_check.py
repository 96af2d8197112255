import numpy as np
import pytest
import reference

import cleave
from cleave.arrays import as_ids

TETRAHEDRON = [[0, 1, 2, 3]]


@pytest.mark.parametrize("cells,rule", [
    ([[0, 1, 1, 2]], "degenerate-cell"),
    ([[0, 1, 2, 3], [3, 2, 1, 0]], "duplicate-cell"),
    ([[0, 1, 2], [0, 1, 3], [0, 1, 4]], "facet-in-three-cells"),
    ([[0, 1, 2], [1, 2, 3]], "orientation-conflict"),
    ([[0, 1, 2], [1, 3, 2], [2, 3, 4], [3, 5, 4], [4, 5, 1], [5, 0, 1]], "non-orientable"),
    ([[0, 1, 2], [2, 3, 4]], "not-cut-regular"),
    ([[0, 1, 2], [3, 4, 5]], "orphan-vertex"),
])
def test_each_finding_has_its_rule(cells, rule):
    count = 7 if rule == "orphan-vertex" else None
    found = cleave.check(cells, count)
    assert rule in [finding.rule for finding in found.findings]
    assert all(finding.message and finding.witness for finding in found.findings)


def test_a_clean_mesh():
    cells, _ = reference.grid(3, 2)
    signs = cleave.orient(cells)
    found = cleave.check(cells, signs=signs)
    assert found.findings == [] and found.level == "manifold" and found.can_be_cut
    assert (found.pieces, found.boundary_components, found.euler_characteristic) == (1, 1, 1)


def test_an_empty_mesh_is_clean():
    found = cleave.check(np.empty((0, 4), np.uint32))
    assert found.findings == [] and found.pieces == 0


def test_a_moebius_band_has_a_loop_that_shows_it():
    cells = [[0, 1, 2], [1, 3, 2], [2, 3, 4], [3, 5, 4], [4, 5, 1], [5, 0, 1]]
    with pytest.raises(cleave.InvalidComplex) as refused:
        cleave.orient(cells)
    loop = refused.value.findings[0].witness["loop"]
    assert len({h // 3 for h in loop}) == len(loop) >= 3


def test_32_bit_integers_are_not_copied():
    for dtype in (np.uint32, np.int32):
        cells = np.array(TETRAHEDRON, dtype)
        assert np.shares_memory(as_ids(cells, "cells"), cells)
    assert not np.shares_memory(as_ids(np.array(TETRAHEDRON), "cells"), np.array(TETRAHEDRON))


def test_the_array_is_not_changed():
    cells, _ = reference.grid(2, 3)
    before = cells.copy()
    cells.flags.writeable = False
    cleave.check(cells)
    cleave.cut(cells, reference.interior_facets(cells))
    np.testing.assert_array_equal(cells, before)


@pytest.mark.parametrize("cells,error", [
    ([0, 1, 2], ValueError),
    ([[0, 1, 2, 3, 4, 5]], ValueError),
    ([[0]], ValueError),
    ([[0.0, 1.0]], TypeError),
    ([[0, -1]], ValueError),
    ([[0, 2**33]], ValueError),
    (None, (TypeError, ValueError)),
])
def test_what_is_no_mesh_is_refused(cells, error):
    with pytest.raises(error):
        cleave.check(cells)


def test_a_vertex_that_does_not_exist_is_a_finding():
    found = cleave.check(np.array([[0, 1, 7]], np.int32), 3)
    assert found.findings[0].rule == "vertex-out-of-range"


@pytest.mark.parametrize("dtype", [np.int32, np.int64])
def test_a_negative_number_is_named(dtype):
    with pytest.raises(ValueError, match="cells: -1 is negative"):
        cleave.check(np.array([[0, 1, -1]], dtype))


def test_numbers_with_large_gaps_are_refused_before_memory_is_taken():
    with pytest.raises(ValueError, match="number the vertices densely"):
        cleave.check([[0, 1, 4_000_000_000]])
    _, rows = np.unique([[7, 9, 4_000_000_000]], return_inverse=True)
    assert cleave.check(rows.reshape(1, 3)).can_be_cut


def test_an_unknown_level_is_refused():
    with pytest.raises(ValueError, match="edge-regular"):
        cleave.check(TETRAHEDRON, level="best")
