import random

import numpy as np
import pytest
import reference

import cleave


def random_facets(cells, seed, share):
    generator = random.Random(seed)
    return [f for f in reference.interior_facets(cells) if generator.random() < share]


@pytest.mark.parametrize("dimension,size", [(1, 8), (2, 4), (3, 2), (4, 1)])
@pytest.mark.parametrize("share", [0.0, 0.1, 0.5, 1.0])
def test_a_cut_is_the_paper_s_algorithm_3(dimension, size, share):
    cells, _ = reference.grid(dimension, size)
    facets = random_facets(cells, 1, share)
    result = cleave.cut(cells, np.array(facets).reshape(-1, dimension))
    after, parents = reference.unglue(cells, set(facets))
    np.testing.assert_array_equal(result.cells, after)
    np.testing.assert_array_equal(result.parents, parents)
    assert len(result.opened) + len(result.shut) == len(facets)
    assert cleave.certify(cells, np.array(facets).reshape(-1, dimension), result.cells)


def test_points_follow_their_parents():
    cells, points = reference.grid(2, 4)
    middle = points[:, 0] == 2
    facets = [f for f in reference.interior_facets(cells) if middle[list(f)].all()]
    result = cleave.cut(cells, facets)
    np.testing.assert_array_equal(points[result.parents][result.cells], points[cells])
    assert len(result.opened) == 4 and len(result.shut) == 0
    sides = points[cells].mean(axis=1)[result.opened // 3, 0]
    assert ((sides < 2).sum(axis=1) == 1).all()


def test_order_repetition_and_orientation_of_the_request_change_nothing():
    cells, _ = reference.grid(3, 2)
    facets = random_facets(cells, 2, 0.3)
    one = cleave.cut(cells, facets)
    shuffled = [tuple(reversed(f)) for f in facets] * 2
    random.Random(3).shuffle(shuffled)
    other = cleave.cut(cells, shuffled)
    np.testing.assert_array_equal(one.cells, other.cells)
    np.testing.assert_array_equal(one.cells, cleave.cut(cells, cleave.locate(cells, facets)).cells)


@pytest.mark.parametrize("dimension,size", [(1, 6), (2, 3), (3, 2), (4, 1)])
def test_steps_agree_with_a_cut_from_the_start(dimension, size):
    """T8 and T12: the state depends on the scored set alone."""
    cells, _ = reference.grid(dimension, size)
    facets = reference.interior_facets(cells)
    generator = random.Random(4)
    incision = cleave.Incision(cells)
    scored, past, future = set(), [], []
    kinds = {"merged": 0, "split": 0, "undo": 0, "redo": 0}
    for _ in range(60):
        step = generator.choice(["cut", "cut", "stitch", "undo", "redo"])
        before = incision.vertex_count
        if step in ("cut", "stitch"):
            some = {f for f in facets if generator.random() < 0.3}
            some = some if step == "cut" else some & scored
            half_facets = cleave.locate(cells, np.array(sorted(some)).reshape(-1, dimension))
            change = incision.cut(half_facets) if step == "cut" else incision.stitch(half_facets)
            after = scored | some if step == "cut" else scored - some
            if after != scored:  # a step only if it changes what is scored
                past, future, scored = [*past, scored], [], after
        elif step == "undo" and past:
            change = incision.undo()
            future, scored = [scored, *future], past.pop()
            kinds["undo"] += 1
        elif step == "redo" and future:
            change = incision.redo()
            past, scored = [*past, scored], future.pop(0)
            kinds["redo"] += 1
        else:
            continue
        assert incision.can_undo == bool(past) and incision.can_redo == bool(future)
        kinds["merged"] += len(change.merges) > 0
        kinds["split"] += len(change.splits) > 0
        assert change.vertices_before == before
        after, _ = reference.unglue(cells, scored)
        np.testing.assert_array_equal(incision.canonical[incision.cells], after)
        np.testing.assert_array_equal(incision.parents[incision.cells], cells)
        lesser = cleave.locate(cells, np.array(sorted(scored)).reshape(-1, dimension))
        np.testing.assert_array_equal(incision.scored, np.sort(lesser))
        assert cleave.certify(cells, lesser, incision.cells)
    assert min(kinds.values()) > 0, kinds


def test_the_view_shows_later_changes_and_cannot_be_written():
    cells, _ = reference.grid(2, 2)
    incision = cleave.Incision(cells)
    view = incision.cells
    assert np.shares_memory(view, incision.cells)
    incision.cut(reference.interior_facets(cells))
    assert view.max() == incision.vertex_count - 1
    with pytest.raises(ValueError):
        view[0, 0] = 7
    del incision
    assert view.shape == cells.shape  # the view keeps what it shows alive


def test_a_relabelling_carries_data_over():
    cells, points = reference.grid(3, 2)
    incision = cleave.Incision(cells)
    change = incision.cut(random_facets(cells, 5, 0.5))
    carried = change.carry_over(points)
    np.testing.assert_array_equal(carried[incision.cells], points[cells])
    undone = incision.undo().carry_over(carried)
    np.testing.assert_array_equal(undone, points)
    with pytest.raises(ValueError, match="values are given"):
        change.carry_over(points[1:])


def test_a_shut_facet_is_explained():
    cells = np.array([[0, 1, 2, 4], [0, 1, 3, 4], [0, 2, 3, 4], [1, 2, 3, 4]])
    incision = cleave.Incision(cells)
    change = incision.cut([[0, 1, 4]])
    assert len(change.opened) == 0
    shut = int(incision.shut[0])
    chains = incision.explain(shut)
    assert sorted(chain.vertex for chain in chains) == [0, 1, 4]
    for chain in chains:
        assert all(chain.vertex in cells[cell] for cell in chain.through)
        assert chain.through[0] == 0 and chain.through[-1] == 1


@pytest.mark.parametrize("half_facet", [-1, 2**40])
def test_a_half_facet_that_is_none_has_no_explanation(half_facet):
    with pytest.raises(ValueError, match="there is no half-facet"):
        cleave.Incision([[0, 1, 2]]).explain(half_facet)


def test_a_pinched_mesh_is_refused_or_regularized():
    cells = [[0, 1, 2], [2, 3, 4]]
    with pytest.raises(cleave.InvalidComplex) as refused:
        cleave.Incision(cells)
    assert [f.rule for f in refused.value.findings] == ["not-cut-regular"]
    assert refused.value.findings[0].witness["vertex"] == 2
    incision = cleave.Incision(cells, regularize=True)
    assert incision.regularized.tolist() == [[5, 2]]
    assert incision.parents.tolist() == [0, 1, 2, 3, 4, 2]


@pytest.mark.parametrize("facets,error,message", [
    ([[0, 1]], cleave.NotInterior, ""),          # on the boundary
    ([[0, 99]], ValueError, "facet of no cell"),
    ([[0, 1, 2]], ValueError, "has 2 vertices"),
    ([10**6], ValueError, ""),                   # no such half-facet
    ([[0.5, 1.0]], TypeError, "integers"),
    ([[-1, 2]], ValueError, ""),
])
def test_wrong_facets_are_refused_and_change_nothing(facets, error, message):
    cells, _ = reference.grid(2, 2)
    incision = cleave.Incision(cells)
    with pytest.raises(error, match=message):
        incision.cut(facets)
    np.testing.assert_array_equal(incision.cells, cells)
    with pytest.raises(IndexError):
        incision.undo()


@pytest.mark.parametrize("mutate", [
    lambda after, c: after.__setitem__((0, 0), after.max() + 1),       # a vertex too many
    lambda after, c: np.copyto(after, c),                              # a split lost
    lambda after, c: after.__setitem__(slice(0, 2), after[1::-1].copy()),  # two cells swapped
])
def test_certify_rejects_what_is_not_the_cut(mutate):
    cells, points = reference.grid(3, 2)
    middle = points[:, 0] == 1
    facets = [f for f in reference.interior_facets(cells) if middle[list(f)].all()]
    after = cleave.cut(cells, facets).cells
    assert cleave.certify(cells, facets, after)
    renamed = np.random.default_rng(6).permutation(int(after.max()) + 1)[after]
    assert cleave.certify(cells, facets, renamed)  # names do not matter
    mutate(after, cells)
    verdict = cleave.certify(cells, facets, after)
    assert not verdict
    assert verdict.clause and verdict.message
