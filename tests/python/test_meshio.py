import pathlib

import meshio
import numpy as np
import pytest
import reference

import cleave
import cleave.meshio

FAULT = pathlib.Path(__file__).parents[2] / "data" / "fault.msh"


@pytest.fixture(name="fault")
def read_fault():
    mesh = meshio.read(FAULT)
    mesh.point_data["height"] = mesh.points[:, 2].copy()
    return mesh


def test_the_fault_and_its_branch_open(fault):
    opened, cut = cleave.meshio.cut(fault, group=["fault", "branch"])
    before, after = cleave.meshio.cells_of(fault), cleave.meshio.cells_of(opened)
    wanted = np.concatenate([cleave.meshio.group_of(fault, name) for name in ("fault", "branch")])
    assert len(cut.opened) == len(wanted) and len(cut.shut) == 0
    assert cleave.certify(before, wanted, after)
    np.testing.assert_array_equal(opened.points[after], fault.points[before])
    np.testing.assert_array_equal(opened.point_data["height"], opened.points[:, 2])
    sides = np.concatenate(opened.cell_data["side"])
    assert (sides == 1).sum() == (sides == -1).sum() == len(wanted)


def test_every_facet_element_is_a_facet_of_its_cells_after(fault):
    opened, _ = cleave.meshio.cut(fault, group="fault")
    after = cleave.meshio.cells_of(opened)
    for block in opened.cells:
        if block.type == "triangle":
            cleave.locate(after, block.data)  # raises for one that is not


def test_sets_follow(fault):
    fault.cell_sets["both"] = [
        np.arange(len(block.data)) if block.type == "triangle" else np.array([], int)
        for block in fault.cells]
    opened, _ = cleave.meshio.cut(fault, group="both")
    count = sum(len(block.data) for block in opened.cells if block.type == "triangle")
    assert sum(len(chosen) for chosen in opened.cell_sets["both"]) == count


def test_sets_of_points_hold_the_copies_too():
    points = np.array([[0, 0], [1, 0], [0, 1], [1, 1.0]])
    mesh = meshio.Mesh(points, [("triangle", np.array([[0, 1, 2], [1, 3, 2]]))],
                       point_sets={"left": np.array([0, 2])})
    opened, cut = cleave.meshio.cut(mesh, facets=[[1, 2]])
    assert cut.parents.tolist() == [0, 1, 2, 3, 1, 2]
    assert opened.point_sets["left"].tolist() == [0, 2, 5]


def test_the_result_can_be_written_and_read(fault, tmp_path):
    opened, _ = cleave.meshio.cut(fault, group="fault")
    meshio.write(tmp_path / "open.vtu", opened)
    again = meshio.read(tmp_path / "open.vtu")
    np.testing.assert_array_equal(cleave.meshio.cells_of(again), cleave.meshio.cells_of(opened))
    np.testing.assert_array_equal(again.point_data["parent"], opened.point_data["parent"])


def test_a_triangle_mesh_with_edges():
    cells, points = reference.grid(2, 3)
    seam = [f for f in reference.interior_facets(cells) if (points[list(f), 0] == 1).all()]
    mesh = meshio.Mesh(np.c_[points, np.zeros(len(points))],
                       [("triangle", cells), ("line", np.array(seam))])
    opened, cut = cleave.meshio.cut(mesh, facets=seam)
    assert len(cut.opened) == len(seam) == 3
    assert len(opened.cells[1].data) == 6
    assert opened.cell_data["side"][1].tolist() == [-1, 1] * 3


def test_check_on_a_mesh(fault):
    assert cleave.meshio.check(fault).level == "manifold"


@pytest.mark.parametrize("make,message", [
    (lambda mesh: cleave.meshio.cut(mesh, group="falt"), "'falt'.*fault"),
    (lambda mesh: cleave.meshio.cut(mesh), "either"),
    (lambda mesh: cleave.meshio.check(meshio.Mesh(mesh.points, [("quad", [[0, 1, 2, 3]])])), "quad"),
    (lambda mesh: cleave.meshio.check(meshio.Mesh(mesh.points, [])), "no lines"),
])
def test_errors_say_what_to_do(fault, make, message):
    with pytest.raises(ValueError, match=message):
        make(fault)
