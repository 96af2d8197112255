"""What meshio makes of mesh files, in a form that files_oracle_test.cpp compares.

    files_oracle.py dump FILE     prints the mesh that meshio reads
    files_oracle.py make FOLDER   writes one mesh in every format, and FOLDER/expected

A mesh is printed as one line per point (the bits of its coordinates) and one per element, by
dimension, then in file order: dimension, vertices from 0 on, group.
"""

import contextlib
import io
import struct
import sys

import meshio
import numpy

DIMENSION = {"vertex": 0, "line": 1, "triangle": 2, "tetra": 3}
GROUP_NAMES = ("medit:ref", "gmsh:physical", "group")


def dump(mesh, out):
    for point in mesh.points:
        bits = [struct.pack(">d", float(x)).hex() for x in [*point, 0.0][:3]]
        print("point", *bits, file=out)
    rows = [[] for _ in range(4)]
    arrays = [mesh.cell_data[name] for name in GROUP_NAMES if name in mesh.cell_data]
    for i, block in enumerate(mesh.cells):
        groups = arrays[0][i] if arrays else [0] * len(block.data)
        for vertices, group in zip(block.data, groups):
            rows[DIMENSION[block.type]].append((*vertices, group))
    for vertex, group in enumerate(mesh.point_data.get("medit:ref", [])):
        if group != 0:
            rows[0].append((vertex, group))
    for dimension in range(4):
        for row in rows[dimension]:
            print(dimension, *(int(x) for x in row), file=out)


def sample():
    """A strip of tetrahedra with irregular points, two groups of cells, and facets and edges."""
    random = numpy.random.default_rng(7)
    points = random.normal(size=(12, 3)) * 10.0 ** random.integers(-9, 9, size=(12, 1))
    tetra = numpy.array([[i, i + 1, i + 2, i + 3] for i in range(9)])
    triangle = numpy.array([[i, i + 2, i + 1] for i in range(5)])
    line = numpy.array([[0, 1], [3, 2]])
    groups = [numpy.array([11, 12]), numpy.array([4, 4, 5, 4, 5]), 1 + numpy.arange(9) % 2]
    return points, [("line", line), ("triangle", triangle), ("tetra", tetra)], groups


def make(folder):
    points, cells, groups = sample()

    def mesh(*names):
        return meshio.Mesh(points, cells, cell_data={name: groups for name in names})

    gmsh_names = ("gmsh:physical", "gmsh:geometrical")
    meshio.write(f"{folder}/a.mesh", mesh("medit:ref"), file_format="medit")
    meshio.write(f"{folder}/22.msh", mesh(*gmsh_names), file_format="gmsh22", binary=False)
    entities = mesh(*gmsh_names)
    entities.point_data["gmsh:dim_tags"] = numpy.array([[3, 1]] * len(points))
    meshio.write(f"{folder}/41.msh", entities, file_format="gmsh", binary=False)
    meshio.write(f"{folder}/zlib.vtu", mesh("group"), file_format="vtu", compression="zlib")
    meshio.write(f"{folder}/raw.vtu", mesh("group"), file_format="vtu", compression=None)
    meshio.write(f"{folder}/42.vtk", mesh("group"), file_format="vtk42")
    meshio.write(f"{folder}/text.vtk", mesh("group"), file_format="vtk42", binary=False)
    meshio.write(f"{folder}/51.vtk", mesh("group"), file_format="vtk51")
    with open(f"{folder}/expected", "w") as expected:
        dump(mesh("group"), expected)


def main():
    command, path = sys.argv[1:]
    chatter = io.StringIO()  # meshio prints advice
    with contextlib.redirect_stdout(chatter):
        if command == "make":
            make(path)
        else:
            mesh = meshio.read(path)
    if command == "dump":
        dump(mesh, sys.stdout)


main()
