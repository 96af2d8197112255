#!/usr/bin/env python3
"""Draws the pictures of docs/semantics.md: meshes of data/ cut by Cleave, some also by gmsh.

    docs/pictures/semantics.py CLEAVE      writes the .svg files beside this script

Needs gmsh and nothing else. Every vertex that was copied is moved a little towards the cells of its
copy, so that what opened gapes; pieces in space are moved away from the middle. Cells have the
colour of their piece. A facet that opened is drawn dark, one that opened without having been asked
"""

import itertools
import os
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
DATA = os.path.join(HERE, "..", "..", "data")
COLOURS = ["#9ecae1", "#fdd0a2", "#c7e9c0", "#dadaeb", "#fbb4b9", "#d9d9d9", "#ffeda0", "#b2dfdb"]
DARK, WRONG, SHUT = "#08306b", "#d7191c", "#e6550d"
SIZE = 300  # of a panel, in pixels


def read_msh(path):
    """Points by number, simplices by dimension with their group, and groups by name: .msh 2.2."""
    with open(path, encoding="ascii") as file:
        lines = file.read().split("\n")
    section = lambda name: lines.index("$" + name) + 2
    count = lambda name: int(lines[section(name) - 1])
    names = {}
    if "$PhysicalNames" in lines:
        for line in lines[section("PhysicalNames"):][:count("PhysicalNames")]:
            dimension, tag, name = line.split()
            names[name.strip('"')] = (int(dimension), int(tag))
    points = {}
    for line in lines[section("Nodes"):][:count("Nodes")]:
        number, *xyz = line.split()
        points[int(number)] = tuple(float(x) for x in xyz)
    simplices = {1: [], 2: [], 3: []}
    for line in lines[section("Elements"):][:count("Elements")]:
        row = [int(x) for x in line.split()]
        dimension = {1: 1, 2: 2, 4: 3}.get(row[1])
        if dimension:
            simplices[dimension].append((row[3], tuple(row[3 + row[2]:])))
    return points, simplices, names


def group(mesh, name):
    _, simplices, names = mesh
    dimension, tag = names[name]
    return [tuple_ for at, tuple_ in simplices[dimension] if at == tag]


class Result:
    """Cells before and after a cut, corner by corner, and what became of their facets."""

    def __init__(self, before, after, asked, dimension):
        points, simplices, _ = before
        self.points = points
        self.before = [cell for _, cell in simplices[dimension]]
        key = lambda p: tuple(round(x, 9) for x in p)
        found = {frozenset(key(after[0][v]) for v in cell): {key(after[0][v]): v for v in cell}
                 for _, cell in after[1][dimension]}
        self.after = []
        for cell in self.before:
            at = found[frozenset(key(points[v]) for v in cell)]
            self.after.append(tuple(at[key(points[v])] for v in cell))
        self.asked = {tuple(sorted(facet)) for facet in asked}
        self.sides = {}
        for c, cell in enumerate(self.before):
            for facet in itertools.combinations(sorted(cell), dimension):
                self.sides.setdefault(facet, []).append(c)

    def image(self, c, v):
        return self.after[c][self.before[c].index(v)]

    def is_open(self, facet):
        sides = self.sides[facet]
        return len(sides) == 2 and any(self.image(sides[0], v) != self.image(sides[1], v)
                                       for v in facet)

    def pieces(self):
        """The piece of each cell: connected through facets that are not open."""
        piece = {}
        joined = {c: [] for c in range(len(self.before))}
        for facet, sides in self.sides.items():
            if len(sides) == 2 and not self.is_open(facet):
                joined[sides[0]].append(sides[1])
                joined[sides[1]].append(sides[0])
        for start in joined:
            if start in piece:
                continue
            todo = [start]
            number = len(set(piece.values()))
            piece[start] = number
            while todo:
                for other in joined[todo.pop()]:
                    if other not in piece:
                        piece[other] = number
                        todo.append(other)
        return piece

    def hinges(self):
        """The vertices of the result whose cells share no facet there: they tie parts together."""
        stars = {}
        for c, cell in enumerate(self.after):
            for w in cell:
                stars.setdefault(w, []).append(c)
        found = []
        for w, star in stars.items():
            joined = {c: {c} for c in star}
            for one, other in itertools.combinations(star, 2):
                common = set(self.after[one]) & set(self.after[other])
                if len(common) == len(self.after[one]) - 1 and w in common:
                    joined[one] |= joined[other]
                    for c in joined[one]:
                        joined[c] = joined[one]
            if len(joined[star[0]]) < len(star):
                found.append(w)
        return found

    def same_as(self, other):
        """Whether both results share corners in the same way."""
        to, back = {}, {}
        return all(to.setdefault(v, w) == w and back.setdefault(w, v) == v
                   for x, y in zip(self.after, other.after) for v, w in zip(x, y))

    def part(self, keep):
        """The same with the cells whose centre passes `keep` only."""
        chosen = [c for c, cell in enumerate(self.before) if keep(centre(self.points, cell))]
        some = object.__new__(Result)
        some.points, some.asked = self.points, self.asked
        some.before = [self.before[c] for c in chosen]
        some.after = [self.after[c] for c in chosen]
        some.sides = {}
        for c, cell in enumerate(some.before):
            for facet in itertools.combinations(sorted(cell), len(cell) - 1):
                some.sides.setdefault(facet, []).append(c)
        return some


def centre(points, cell):
    return tuple(sum(points[v][i] for v in cell) / len(cell) for i in range(3))


def run(command, folder):
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise SystemExit(f"{command}: exit {done.returncode}\n{done.stdout}{done.stderr}")


def by_cleave(cleave, mesh, arguments):
    with tempfile.TemporaryDirectory() as folder:
        run([cleave, "cut", mesh, "-o", "out.msh", "--quiet", *arguments], folder)
        return read_msh(os.path.join(folder, "out.msh"))


def by_gmsh(mesh, name, rim=""):
    names = read_msh(mesh)[2]
    dimension, tag = names[name]
    declared = f"Plugin(Crack).OpenBoundaryPhysicalGroup={names[rim][1]};\n" if rim else ""
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "crack.geo"), "w", encoding="ascii") as out:
            out.write(f'Merge "{mesh}";\nPlugin(Crack).Dimension={dimension};\n{declared}'
                      f'Plugin(Crack).PhysicalGroup={tag};\nPlugin(Crack).Run;\n'
                      'Mesh.MshFileVersion=2.2;\nMesh.SaveAll=1;\nSave "out.msh";\n')
        run(["gmsh", "crack.geo", "-parse_and_exit", "-v", "1"], folder)
        return read_msh(os.path.join(folder, "out.msh"))


def moved_apart(result, amount):
    """Where each vertex of the result is drawn: copies towards the middle of their cells."""
    cells, origin = {}, {}
    for c, (old, new) in enumerate(zip(result.before, result.after)):
        for v, w in zip(old, new):
            cells.setdefault(w, []).append(c)
            origin[w] = v
    copies = {}
    for v in origin.values():
        copies[v] = copies.get(v, 0) + 1
    places = {}
    for w, v in origin.items():
        here = result.points[v]
        if copies[v] == 1:
            places[w] = here
            continue
        star = [centre(result.points, result.before[c]) for c in cells[w]]
        middle = [sum(p[i] for p in star) / len(star) for i in range(3)]
        places[w] = tuple(x + amount * (m - x) for x, m in zip(here, middle))
    return places


class Svg:
    """Shapes in a panel each, side by side."""

    def __init__(self, panels):
        self.panels, self.rows = panels, []

    def polygon(self, points, fill, stroke="#ffffff", width=0.6):
        at = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
        self.rows.append(f'<polygon points="{at}" fill="{fill}" stroke="{stroke}" '
                         f'stroke-width="{width}" stroke-linejoin="round"/>')

    def line(self, p, q, colour, width, dash=""):
        dashes = f' stroke-dasharray="{dash}"' if dash else ""
        self.rows.append(f'<line x1="{p[0]:.1f}" y1="{p[1]:.1f}" x2="{q[0]:.1f}" y2="{q[1]:.1f}" '
                         f'stroke="{colour}" stroke-width="{width}" stroke-linecap="round"{dashes}/>')

    def dot(self, p):
        self.rows.append(f'<circle cx="{p[0]:.1f}" cy="{p[1]:.1f}" r="5" fill="none" '
                         f'stroke="{WRONG}" stroke-width="2"/>')

    def caption(self, panel, text):
        self.rows.append(f'<text x="{(panel + 0.5) * SIZE:.0f}" y="{SIZE + 14}" font-size="13" '
                         f'font-family="sans-serif" text-anchor="middle" fill="#222222">{text}</text>')

    def write(self, name):
        width, height = self.panels * SIZE, SIZE + 22
        with open(os.path.join(HERE, name + ".svg"), "w", encoding="utf-8") as out:
            out.write(f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
                      f'viewBox="0 0 {width} {height}">\n<rect width="{width}" height="{height}" '
                      'fill="#ffffff"/>\n' + "\n".join(self.rows) + "\n</svg>\n")


def draw_plane(svg, panel, result, caption):
    """Triangles of a result, scaled to the panel."""
    xs = [result.points[v][0] for cell in result.before for v in cell]
    ys = [result.points[v][1] for cell in result.before for v in cell]
    scale = 0.86 * SIZE / max(max(xs) - min(xs), max(ys) - min(ys))
    places = moved_apart(result, 0.45)

    def at(w):
        x, y, _ = places[w]
        return (panel * SIZE + SIZE / 2 + scale * (x - (min(xs) + max(xs)) / 2),
                SIZE / 2 - scale * (y - (min(ys) + max(ys)) / 2))

    piece = result.pieces()
    for c, cell in enumerate(result.after):
        svg.polygon([at(w) for w in cell], COLOURS[piece[c] % len(COLOURS)])
    for facet, sides in sorted(result.sides.items()):
        if result.is_open(facet):
            wrong = facet not in result.asked
            for c in sides:
                svg.line(*(at(result.image(c, v)) for v in facet), WRONG if wrong else DARK, 2.2)
        elif facet in result.asked:
            svg.line(*(at(result.image(sides[0], v)) for v in facet), SHUT, 2.6, "5 4")
    for w in result.hinges():
        svg.dot(at(w))
    svg.caption(panel, caption)


def draw_space(svg, result, caption):
    """The surfaces of the pieces, moved away from the middle, seen from above one corner."""
    piece = result.pieces()
    middles = {}
    for c, cell in enumerate(result.before):
        middles.setdefault(piece[c], []).append(centre(result.points, cell))
    shift = {p: [0.45 * sum(m[i] for m in all_) / len(all_) for i in range(3)]
             for p, all_ in middles.items()}
    axes = ((0.82, -0.57, 0.0), (-0.30, -0.43, 0.85), (0.48, 0.70, 0.53))  # right, up, to the eye
    dot = lambda a, b: sum(x * y for x, y in zip(a, b))
    faces = []
    for facet, sides in result.sides.items():
        if len(sides) == 2 and not result.is_open(facet):
            continue
        for c in sides:
            apex = next(v for v in result.before[c] if v not in facet)
            corners = [[x + s for x, s in zip(result.points[v], shift[piece[c]])] for v in facet]
            a, b, d = corners
            u, w = [y - x for x, y in zip(a, b)], [y - x for x, y in zip(a, d)]
            normal = [u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]]
            inward = [x + s - y for x, s, y in zip(result.points[apex], shift[piece[c]], a)]
            if dot(normal, inward) > 0:
                normal = [-x for x in normal]
            size = dot(normal, normal) ** 0.5
            facing = dot(normal, axes[2]) / size
            if facing <= 0:
                continue
            light = 0.62 + 0.38 * max(0.0, dot(normal, (0.1, 0.35, 0.93)) / size)
            faces.append((sum(dot(p, axes[2]) for p in corners), corners, piece[c], light))
    scale = 0.235 * SIZE
    for _, corners, p, light in sorted(faces, key=lambda face: face[0]):
        rgb = [int(int(COLOURS[p % 8][i:i + 2], 16) * light) for i in (1, 3, 5)]
        svg.polygon([(SIZE / 2 + scale * dot(q, axes[0]), SIZE / 2 - scale * dot(q, axes[1]))
                     for q in corners], "#%02x%02x%02x" % tuple(rgb), "#666666", 0.4)
    svg.caption(0, caption)


def main():
    cleave = os.path.abspath(sys.argv[1])
    junctions = os.path.abspath(os.path.join(DATA, "junctions.msh"))
    before = read_msh(junctions)
    squares = ["tee", "cross", "vee", "close", "ring", "edge", "inside", "mixed"]
    for i, name in enumerate(squares):
        inside = lambda p, i=i: 1.5 * i - 0.1 < p[0] < 1.5 * i + 1.1
        asked = group(before, name)
        ours = Result(before, by_cleave(cleave, junctions, ["--group", name]), asked, 2).part(inside)
        rim = "" if name == "edge" else "rim"
        theirs = Result(before, by_gmsh(junctions, name, rim), asked, 2).part(inside)
        equal = ours.same_as(theirs)
        svg = Svg(1 if equal else 2)
        draw_plane(svg, 0, ours, "Cleave and gmsh" if equal else "Cleave")
        if not equal:
            draw_plane(svg, 1, theirs, "gmsh 4.8, Plugin(Crack)")
        svg.write(name)

    bowtie = os.path.abspath(os.path.join(DATA, "bowtie.msh"))
    before = read_msh(bowtie)
    asked = group(before, "line")
    svg = Svg(2)
    draw_plane(svg, 0, Result(before, by_cleave(cleave, bowtie, ["--group", "line"]), asked, 2),
               "Cleave")
    draw_plane(svg, 1, Result(before, by_gmsh(bowtie, "line"), asked, 2), "gmsh 4.8, Plugin(Crack)")
    svg.write("bowtie")

    octants = os.path.abspath(os.path.join(DATA, "octants.msh"))
    before = read_msh(octants)
    asked = [t for name in "xyz" for t in group(before, name)]
    svg = Svg(1)
    draw_space(svg, Result(before, by_cleave(cleave, octants, ["--group", "x", "y", "z"]), asked, 3),
               "eight pieces")
    svg.write("octants")


if __name__ == "__main__":
    main()
