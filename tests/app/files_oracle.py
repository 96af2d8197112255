"""What meshio makes of mesh files, in a form that files_oracle_test.cpp compares.

    files_oracle.py dump FILE     prints the mesh that meshio reads
    files_oracle.py make FOLDER   writes one mesh in every format, and FOLDER/expected
    files_oracle.py gmsh FILE     prints the periodic nodes and the fields that gmsh reads
    files_oracle.py box FOLDER    has gmsh write a periodic box of second order in every form

A mesh is printed as one line per point (the bits of its coordinates) and one per element, by
dimension, then in file order: dimension, vertices from 0 on, group. Cohesive elements count as
dimension 4. Nodes of second order are in meshio's order, which is VTK's.
"""

import contextlib
import io
import struct
import sys

import meshio
import numpy

DIMENSION = {"vertex": 0, "line": 1, "triangle": 2, "tetra": 3}
DIMENSION |= {"line3": 1, "triangle6": 2, "tetra10": 3, "wedge": 4, "quad": 4}
GROUP_NAMES = ("medit:ref", "gmsh:physical", "group", "tetgen:ref")


def dump(mesh, out):
    for point in mesh.points:
        bits = [struct.pack(">d", float(x)).hex() for x in [*point, 0.0][:3]]
        print("point", *bits, file=out)
    rows = [[] for _ in range(5)]
    arrays = [mesh.cell_data[name] for name in GROUP_NAMES if name in mesh.cell_data]
    for i, block in enumerate(mesh.cells):
        groups = arrays[0][i] if arrays else [0] * len(block.data)
        for vertices, group in zip(block.data, groups):
            rows[DIMENSION[block.type]].append((*vertices, group))
    for name in ("medit:ref", "tetgen:ref"):
        for vertex, group in enumerate(mesh.point_data.get(name, [])):
            if group != 0:
                rows[0].append((vertex, group))
    for dimension in range(5):
        for row in rows[dimension]:
            print(dimension, *(int(x) for x in row), file=out)
    if arrays:
        return
    for name, vertices in sorted(mesh.point_sets.items()):
        print("nodes", name, *sorted(int(v) for v in vertices), file=out)
    for name, blocks in sorted(mesh.cell_sets.items()):
        for block, places in zip(mesh.cells, blocks):
            if len(places) > 0:
                dimension = DIMENSION[block.type]
                print("elements", name, dimension, *(int(e) for e in places), file=out)


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
    meshio.write(f"{folder}/22b.msh", mesh(*gmsh_names), file_format="gmsh22", binary=True)
    entities = mesh(*gmsh_names)
    entities.point_data["gmsh:dim_tags"] = numpy.array([[3, 1]] * len(points))
    meshio.write(f"{folder}/41.msh", entities, file_format="gmsh", binary=False)
    meshio.write(f"{folder}/41b.msh", entities, file_format="gmsh", binary=True)
    meshio.write(f"{folder}/zlib.vtu", mesh("group"), file_format="vtu", compression="zlib")
    meshio.write(f"{folder}/raw.vtu", mesh("group"), file_format="vtu", compression=None)
    meshio.write(f"{folder}/42.vtk", mesh("group"), file_format="vtk42")
    meshio.write(f"{folder}/text.vtk", mesh("group"), file_format="vtk42", binary=False)
    meshio.write(f"{folder}/51.vtk", mesh("group"), file_format="vtk51")
    tetra = meshio.Mesh(points, cells[2:], cell_data={"tetgen:ref": groups[2:]})
    meshio.write(f"{folder}/a.node", tetra, file_format="tetgen")
    sets = {"odd": [numpy.array([], int), numpy.array([1, 3]), numpy.array([0, 8])]}
    abaqus = meshio.Mesh(points, cells, cell_sets=sets, point_sets={"ends": numpy.array([0, 11])})
    meshio.write(f"{folder}/a.inp", abaqus, file_format="abaqus")
    with open(f"{folder}/expected", "w") as expected:
        dump(mesh("group"), expected)


def gmsh_dump(path):
    import gmsh

    gmsh.initialize()
    gmsh.option.setNumber("General.Verbosity", 1)
    gmsh.open(path)
    lines = []
    for dimension, tag in gmsh.model.getEntities():
        master, nodes, masters, affine = gmsh.model.mesh.getPeriodicNodes(dimension, tag)
        if len(nodes) > 0:
            lines.append(f"periodic {dimension} {tag} {master} {len(affine)}")
            lines += [f"{a} {b}" for a, b in sorted(zip(nodes, masters))]
    for view in gmsh.view.getTags():
        name = gmsh.option.getString(f"View[{gmsh.view.getIndex(view)}].Name")
        kind, tags, data, _, components = gmsh.view.getModelData(view, 0)
        lines.append(f"{kind} {name} {components}")
        lines += [f"{tag} " + " ".join(f"{x:.17g}" for x in row)
                  for tag, row in zip(tags, data) if not numpy.isnan(row).all()]
    gmsh.finalize()
    return lines


def gmsh_box(folder):
    import gmsh

    gmsh.initialize()
    gmsh.option.setNumber("General.Verbosity", 1)
    geometry = gmsh.model.geo
    corners = [geometry.addPoint(x, y, 0, 0.9) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
    sides = [geometry.addLine(corners[i], corners[(i + 1) % 4]) for i in range(4)]
    floor = geometry.addPlaneSurface([geometry.addCurveLoop(sides)])
    roof = geometry.extrude([(2, floor)], 0, 0, 1)[0][1]
    geometry.synchronize()
    up = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 1]
    gmsh.model.mesh.setPeriodic(2, [roof], [floor], up)
    gmsh.model.addPhysicalGroup(3, [1], 1)
    gmsh.model.addPhysicalGroup(2, [floor], 2)
    gmsh.model.addPhysicalGroup(2, [roof], 3)
    gmsh.option.setNumber("Mesh.ElementOrder", 2)
    gmsh.model.mesh.generate(3)
    for version in (2.2, 4.1):
        for binary in (0, 1):
            gmsh.option.setNumber("Mesh.MshFileVersion", version)
            gmsh.option.setNumber("Mesh.Binary", binary)
            gmsh.write(f"{folder}/{version}-{binary}.msh")
    gmsh.write(f"{folder}/box.mesh")
    gmsh.finalize()


def main():
    command, path = sys.argv[1:]
    chatter = io.StringIO()  # meshio prints advice
    with contextlib.redirect_stdout(chatter):
        if command == "make":
            make(path)
        elif command == "box":
            gmsh_box(path)
        elif command == "gmsh":
            lines = gmsh_dump(path)
        else:
            mesh = meshio.read(path)
    if command == "dump":
        dump(mesh, sys.stdout)
    if command == "gmsh":
        print("\n".join(lines))


main()
