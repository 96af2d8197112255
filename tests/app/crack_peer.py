#!/usr/bin/env python3
"""Cuts the same meshes with Cleave and with gmsh's Plugin(Crack) and judges both.

    crack_peer.py CLEAVE [TABLE]      writes the table of junctions to TABLE, or prints it

The judge is Algorithm 3 of Nienhuys & van der Stappen 2000, word for word, on sets of vertices; it
shares no code with either tool. Cells are recognised by the coordinates of their corners, so that
neither tool's numbering matters. Counted are facets, once each:

    wrong    opened without having been asked for
    missed   opened by Algorithm 3 and not by the tool
    pinched  further vertices that Algorithm 3 with an empty cut would make of the tool's result
    equal    the result shares corners exactly as that of Algorithm 3

Exit status 0: Cleave equals Algorithm 3 in every case, so does gmsh where it has nothing wrong,
missed or pinched, and it does so wherever the cut is an oriented manifold with its rim declared;
1: not so; 77: there is no gmsh here.
"""

import itertools
import math
import os
import random
import shutil
import subprocess
import sys
import tempfile

CELLS = 6  # cubes along an axis; the points of the grid are 0 .. CELLS


def kuhn_grid():
    """Points and tetrahedra of the Kuhn subdivision of a cube."""
    side = range(CELLS + 1)
    points = list(itertools.product(side, side, side))
    number = {p: i for i, p in enumerate(points)}
    cells = []
    for least in itertools.product(range(CELLS), repeat=3):
        for order in itertools.permutations(range(3)):
            at, cell = list(least), [number[least]]
            for axis in order:
                at[axis] += 1
                cell.append(number[tuple(at)])
            if order in ((0, 2, 1), (1, 0, 2), (2, 1, 0)):
                cell[2], cell[3] = cell[3], cell[2]
            cells.append(tuple(cell))
    return points, cells


def facets_of(cells):
    """Facet (sorted vertices) -> its cells."""
    facets = {}
    for c, cell in enumerate(cells):
        for facet in itertools.combinations(sorted(cell), 3):
            facets.setdefault(facet, []).append(c)
    return facets


def algorithm_3(cells, cut):
    """The cells after every star was divided along `cut`, a set of pairs of cells."""
    cells = [list(cell) for cell in cells]
    stars = {}
    for c, cell in enumerate(cells):
        for v in cell:
            stars.setdefault(v, []).append(c)
    fresh = max(stars) + 1
    for v, star in sorted(stars.items()):
        at = {}
        for c in star:
            for facet in itertools.combinations(sorted(cells[c]), 3):
                if v in facet:
                    at.setdefault(facet, []).append(c)
        joined = {c: [] for c in star}
        for sides in at.values():
            if len(sides) == 2 and tuple(sides) not in cut:
                joined[sides[0]].append(sides[1])
                joined[sides[1]].append(sides[0])
        seen = set()
        for c in star:
            if c in seen:
                continue
            component, todo = [], [c]
            seen.add(c)
            while todo:
                here = todo.pop()
                component.append(here)
                for other in joined[here]:
                    if other not in seen:
                        seen.add(other)
                        todo.append(other)
            for here in component:
                cells[here][cells[here].index(v)] = fresh
            fresh += 1
    return [tuple(cell) for cell in cells]


def vertices(cells):
    return len({v for cell in cells for v in cell})


def same_partition(a, b):
    to, back = {}, {}
    return all(to.setdefault(v, w) == w and back.setdefault(w, v) == v
               for x, y in zip(a, b) for v, w in zip(x, y))


class Case:
    """A mesh, the facets to cut in one or several groups, and the rim to declare to gmsh."""

    def __init__(self, name, groups, rim=None, drop=(), plain=False):
        self.points, cells = kuhn_grid()
        self.name, self.rim, self.plain = name, rim or (lambda p, q: False), plain
        self.cells = [cell for cell in cells if not any(d(cell, self.points) for d in drop)]
        self.facets = facets_of(self.cells)
        interior = sorted(f for f, sides in self.facets.items() if len(sides) == 2)
        self.groups = [group(self, interior) for group in groups]
        asked = {tuple(sorted(t)) for group in self.groups for t in group}
        self.asked = {f for f in asked if len(self.facets[f]) == 2}
        self.expected = algorithm_3(self.cells, {tuple(self.facets[f]) for f in self.asked})

    def rim_edges(self):
        edges = {}
        for group in self.groups:
            for t in group:
                for edge in itertools.combinations(sorted(t), 2):
                    edges[edge] = True
        return [e for e in edges if self.rim(*(self.points[v] for v in e))]

    def judge(self, after):
        """(new vertices, wrong, missed, pinched, equal) of a tool's cells."""
        opened = lambda cells: {f for f, sides in self.facets.items() if len(sides) == 2 and
                                len(set(self.image(f, sides[0], cells)) &
                                    set(self.image(f, sides[1], cells))) < 3}
        by_tool, by_reference = opened(after), opened(self.expected)
        return (vertices(after) - vertices(self.cells), len(by_tool - self.asked),
                len(by_reference - by_tool), vertices(algorithm_3(after, set())) - vertices(after),
                same_partition(after, self.expected))

    def image(self, facet, c, cells):
        return [w for v, w in zip(self.cells[c], cells[c]) if v in facet]


def write_msh(path, case):
    rows = []
    for line in case.rim_edges():
        rows.append((1, 100, 100, line))
    for i, group in enumerate(case.groups):
        rows += [(2, 1 + i, 1 + i, t) for t in group]
    rows += [(4, 200, 200, cell) for cell in case.cells]
    used = sorted({v for cell in case.cells for v in cell})
    with open(path, "w", encoding="ascii") as out:
        print("$MeshFormat\n2.2 0 8\n$EndMeshFormat", file=out)
        print(f"$PhysicalNames\n{len(case.groups)}", file=out)
        for i in range(len(case.groups)):
            print(f'2 {1 + i} "cut{1 + i}"', file=out)
        print(f"$EndPhysicalNames\n$Nodes\n{len(used)}", file=out)
        for v in used:
            print(v + 1, *case.points[v], file=out)
        print(f"$EndNodes\n$Elements\n{len(rows)}", file=out)
        for n, (kind, group, entity, tuple_) in enumerate(rows):
            print(n + 1, kind, 2, group, entity, *(v + 1 for v in tuple_), file=out)
        print("$EndElements", file=out)


def read_cells(path, case):
    """The tetrahedra of a .msh 2.2 in the case's order, found by the coordinates of corners."""
    with open(path, encoding="ascii") as file:
        lines = file.read().split("\n")
    start = lines.index("$Nodes")
    points = {}
    for line in lines[start + 2:start + 2 + int(lines[start + 1])]:
        tag, *xyz = line.split()
        points[int(tag)] = tuple(round(float(x)) for x in xyz)
    start = lines.index("$Elements")
    found = {}
    for line in lines[start + 2:start + 2 + int(lines[start + 1])]:
        row = [int(x) for x in line.split()]
        if row[1] == 4:
            tuple_ = row[3 + row[2]:]
            found[frozenset(points[v] for v in tuple_)] = {points[v]: v for v in tuple_}
    if len(found) != len(case.cells):
        raise SystemExit(f"{case.name}: {len(found)} cells in {path}, not {len(case.cells)}")
    result = []
    for cell in case.cells:
        corners = [case.points[v] for v in cell]
        at = found[frozenset(corners)]
        result.append(tuple(at[p] for p in corners))
    return result


def run(command, folder):
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise SystemExit(f"{command}: exit {done.returncode}\n{done.stdout}{done.stderr}")


def by_cleave(cleave, case, folder):
    names = [f"cut{1 + i}" for i in range(len(case.groups))]
    run([cleave, "cut", "in.msh", "-o", "cleave.msh", "--quiet", "--verify", "all", "--group",
         *names], folder)
    return read_cells(os.path.join(folder, "cleave.msh"), case)


def by_gmsh(case, folder):
    declared = "Plugin(Crack).OpenBoundaryPhysicalGroup=100;\n" if case.rim_edges() else ""
    calls = "".join(f"Plugin(Crack).PhysicalGroup={1 + i};\nPlugin(Crack).Run;\n"
                    for i in range(len(case.groups)))
    with open(os.path.join(folder, "crack.geo"), "w", encoding="ascii") as out:
        out.write('Merge "in.msh";\nPlugin(Crack).Dimension=2;\n' + declared + calls +
                  'Mesh.MshFileVersion=2.2;\nMesh.SaveAll=1;\nSave "gmsh.msh";\n')
    run(["gmsh", "crack.geo", "-parse_and_exit", "-v", "1"], folder)
    return read_cells(os.path.join(folder, "gmsh.msh"), case)


# Groups: functions of a case and its interior facets that return triples of vertices.

def on(*tests):
    """Facets all of whose points pass one of the tests, each a plane or a part of one. The normals
    of each test's facets agree."""
    def group(case, interior):
        found = []
        for facet in interior:
            points = [case.points[v] for v in facet]
            if any(all(test(*p) for p in points) for test in tests):
                found.append(upright(facet, case.points))
        return found
    return group


def upright(facet, points):
    """The triple whose normal has its first component that is not zero positive."""
    a, b, c = (points[v] for v in facet)
    u, w = [b[i] - a[i] for i in range(3)], [c[i] - a[i] for i in range(3)]
    normal = (u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0])
    first = next(x for x in normal if x != 0)
    return facet if first > 0 else (facet[0], facet[2], facet[1])


def between(label):
    """Facets between cells of different labels; normals point to the greater label."""
    def group(case, interior):
        labels = [label(c, [sum(case.points[v][i] for v in cell) / 4 for i in range(3)])
                  for c, cell in enumerate(case.cells)]
        found = []
        for facet in interior:
            one, other = case.facets[facet]
            if labels[one] == labels[other]:
                continue
            inner = one if labels[one] < labels[other] else other
            apex = next(v for v in case.cells[inner] if v not in facet)
            a, b, c = (case.points[v] for v in facet)
            d = case.points[apex]
            rows = [[p[i] - a[i] for i in range(3)] for p in (b, c, d)]
            volume = (rows[0][0] * (rows[1][1] * rows[2][2] - rows[1][2] * rows[2][1]) -
                      rows[0][1] * (rows[1][0] * rows[2][2] - rows[1][2] * rows[2][0]) +
                      rows[0][2] * (rows[1][0] * rows[2][1] - rows[1][1] * rows[2][0]))
            found.append(facet if volume < 0 else (facet[0], facet[2], facet[1]))
        return found
    return group


def flipped(group, which):
    """The same facets, those that `which` names by their place turned over."""
    def other(case, interior):
        return [(a, c, b) if which(i) else (a, b, c)
                for i, (a, b, c) in enumerate(group(case, interior))]
    return other


def both(*groups):
    return lambda case, interior: [t for group in groups for t in group(case, interior)]


def some(group, indices):
    return lambda case, interior: [group(case, interior)[i] for i in indices]


def outside(p, q):
    """An edge on the surface of the cube."""
    return any(p[i] == q[i] and p[i] in (0, CELLS) for i in range(3))


def rough(seed):
    numbers = random.Random(seed)
    values = [numbers.random() for _ in range(6 * CELLS ** 3)]
    return between(lambda c, p: p[0] + 2 * values[c] > 4)


def inside(low, high):
    return between(lambda _, p: not all(low < x < high for x in p))


def touches_middle(facet, case):
    return any(case.points[v] == (3, 3, 3) for v in facet)


def one_at_pinch(case, interior):
    return [next(f for f in interior if touches_middle(f, case))]


# Of the eight cubes around the middle only two opposite ones stay, which touch there in a point.
def pinch(cell, points):
    centre = [sum(points[v][i] for v in cell) / 4 for i in range(3)]
    near = all(2 < x < 4 for x in centre)
    return near and len({x < 3 for x in centre}) == 2


def cases():
    plane = lambda x, y, z: x == 3
    across = lambda x, y, z: y == 3
    level = lambda x, y, z: z == 3
    patch = lambda x, y, z: x == 3 and 2 <= y <= 5 and 2 <= z <= 5
    crack = lambda x, y, z: x == 3 and y <= 3
    branch = lambda x, y, z: y == 3 and x >= 3
    middle = lambda x, y, z: 1 <= min(x, y, z) and max(x, y, z) <= 5
    inner = lambda x, y, z: x == 3 and middle(x, y, z)
    inner_branch = lambda x, y, z: y == 3 and x >= 3 and middle(x, y, z)
    fold = lambda x, y, z: x == 3 and y >= 3
    back = lambda x, y, z: x == y and y >= 3
    wave = between(lambda _, p: p[0] > 3 + 1.2 * math.sin(p[1]) * math.cos(p[2]))
    ball = between(lambda _, p: sum((x - 3) ** 2 for x in p) > 4.5)

    yield Case("plane, rim not declared", [on(plane)])
    yield Case("plane, rim declared", [on(plane)], outside, plain=True)
    yield Case("patch inside", [on(patch)], plain=True)
    yield Case("patch inside, mixed orientation", [flipped(on(patch), lambda i: i % 2)])
    yield Case("crack to the boundary, not declared", [on(crack)])
    yield Case("crack to the boundary, declared", [on(crack)], outside, plain=True)
    yield Case("one facet", [some(on(patch), [5])])
    yield Case("two facets (the paper's Figure 7)", [some(on(patch), [4, 5])])
    yield Case("T", [on(plane, branch)], outside)
    yield Case("T, gmsh called twice", [on(plane), on(branch)], outside)
    yield Case("T inside", [on(inner, inner_branch)])
    yield Case("T inside, gmsh called twice", [on(inner), on(inner_branch)])
    yield Case("X", [on(plane, across)], outside)
    yield Case("X, gmsh called twice", [on(plane), on(across)], outside)
    yield Case("three planes", [on(plane, across, level)], outside)
    yield Case("three planes, gmsh called three times", [on(plane), on(across), on(level)], outside)
    yield Case("V fold", [both(on(fold), flipped(on(back), lambda i: True))], outside)
    yield Case("V fold, normals opposed", [on(fold, back)], outside)
    yield Case("two sheets, one cell apart", [on(plane, lambda x, y, z: x == 4)], outside)
    yield Case("two sheets, one cell apart, gmsh called twice",
               [on(plane), on(lambda x, y, z: x == 4)], outside)
    yield Case("two patches, one cell apart",
               [on(patch, lambda x, y, z: x == 4 and patch(3, y, z))])
    yield Case("closed box", [inside(2, 4)], plain=True)
    yield Case("closed box in a closed box", [both(inside(2, 4), inside(1, 5))])
    yield Case("closed ball, jagged", [ball])
    yield Case("wavy interface", [wave], outside)
    for seed in (1, 2, 3):
        yield Case(f"rough interface {seed}", [rough(seed)], outside)
    yield Case("pinched input, cut elsewhere",
               [on(lambda x, y, z: x == 1 and 1 <= y <= 5 and 1 <= z <= 5)], drop=[pinch])
    yield Case("pinched input, one facet at the pinch", [one_at_pinch], drop=[pinch])


def main():
    if shutil.which("gmsh") is None:
        print("no gmsh here: nothing to compare with")
        return 77
    cleave = os.path.abspath(sys.argv[1])
    wrong = []
    table = ["| cut | facets | new vertices | Cleave: wrong / missed / pinched "
             "| gmsh: new vertices | wrong / missed / pinched |", "|---|---|---|---|---|---|"]
    for case in cases():
        with tempfile.TemporaryDirectory() as folder:
            write_msh(os.path.join(folder, "in.msh"), case)
            ours = case.judge(by_cleave(cleave, case, folder))
            theirs = case.judge(by_gmsh(case, folder))
        counts = lambda result: " / ".join(str(x) for x in result[1:4])
        table.append(f"| {case.name} | {len(case.asked)} | {ours[0]} | {counts(ours)} "
                     f"| {theirs[0]} | {counts(theirs)} |")
        if ours[1:] != (0, 0, 0, True):
            wrong.append(f"{case.name}: Cleave differs from Algorithm 3: {ours}")
        if theirs[1:4] == (0, 0, 0) and not theirs[4]:
            wrong.append(f"{case.name}: nothing is wrong with gmsh's result, yet it differs")
        if case.plain and not theirs[4]:
            wrong.append(f"{case.name}: gmsh differs on a plain cut: {theirs}")
    text = "\n".join(table) + "\n"
    if len(sys.argv) > 2:
        with open(sys.argv[2], "w", encoding="utf-8") as out:
            out.write(text)
    else:
        print(text, end="")
    for line in wrong:
        print(line)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
