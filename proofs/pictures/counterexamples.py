#!/usr/bin/env python3
"""Draws the counterexamples of proofs/CLAIMS.md, and checks on the way that they are some.

    proofs/pictures/counterexamples.py [FOLDER]     writes the .svg files, into this folder if none is named

Needs Python and nothing else. Nothing that a picture says is drawn by hand: what opens, which vertex
is copied, which end of an edge is closest, which force a rotation gives is computed of the same small
data that the theorems are about, in whole numbers and fractions, and an assertion fails if it is not
so. Vertices have upright numbers. What was asked for and stays shut is dashed and orange, what opened
dark, what is wrong red.
"""

import math
import os
import sys
from fractions import Fraction
from itertools import combinations

CELL, OTHER, EDGE = "#9ecae1", "#fdd0a2", "#ffffff"
DARK, SHUT, WRONG, INK, QUIET, GREEN = "#08306b", "#e6550d", "#d7191c", "#1d2b3d", "#7b8794", "#238b45"


# ---- what is computed ------------------------------------------------------------------------------

def facets(cell):
    return [frozenset(cell) - {v} for v in cell]


def sides(cells):
    """The cells of each facet."""
    found = {}
    for c, cell in enumerate(cells):
        for facet in facets(cell):
            found.setdefault(facet, []).append(c)
    return found


def classes(cells, cut):
    """unglue: the least corner (v, cell) of the class of each corner, glued across uncut facets."""
    least = {(v, c): (v, c) for c, cell in enumerate(cells) for v in cell}
    changed = True
    while changed:
        changed = False
        for facet, at in sides(cells).items():
            if len(at) != 2 or facet in cut:
                continue
            for v in facet:
                one, other = (v, at[0]), (v, at[1])
                low = min(least[one], least[other])
                changed = changed or least[one] != least[other]
                least[one] = least[other] = low
    return least


def opened(cells, cut):
    least = classes(cells, cut)
    return {facet for facet, at in sides(cells).items()
            if len(at) == 2 and any(least[v, at[0]] != least[v, at[1]] for v in facet)}


def copies(cells, cut, vertex):
    least = classes(cells, cut)
    return len({name for (v, _), name in least.items() if v == vertex})


def chain(cells, cut, vertex, facet):
    """A shortest chain of cells around `vertex` from one side of `facet` to the other, uncut."""
    start, goal = sides(cells)[facet]
    paths = [[start]]
    for path in paths:
        if path[-1] == goal:
            return path
        for other, at in sides(cells).items():
            if vertex in other and other not in cut and path[-1] in at and len(at) == 2:
                step = at[0] + at[1] - path[-1]
                if step not in path:
                    paths.append(path + [step])
    return []


def closest(heights):
    """The paper's set of a cell whose vertices have these heights over a plane; ties give both ends."""
    chosen = set()
    for i, j in combinations(range(len(heights)), 2):
        if heights[i] * heights[j] <= 0:
            if abs(heights[i]) <= abs(heights[j]):
                chosen.add(i)
            if abs(heights[j]) <= abs(heights[i]):
                chosen.add(j)
    return chosen


def product(a, b):
    return [[sum(x * y for x, y in zip(row, column)) for column in zip(*b)] for row in a]


def transpose(a):
    return [list(column) for column in zip(*a)]


def inverse(a):
    """Of a 3 by 3 matrix, by cofactors."""
    at = lambda i, j: a[i % 3][j % 3]
    cofactor = [[at(i + 1, j + 1) * at(i + 2, j + 2) - at(i + 1, j + 2) * at(i + 2, j + 1)
                 for j in range(3)] for i in range(3)]
    det = sum(x * y for x, y in zip(a[0], cofactor[0]))
    return [[Fraction(cofactor[j][i], 1) / det for j in range(3)] for i in range(3)], Fraction(det)


def cell_forces(points, displacements, lame, mended):
    """Equation (1) of the paper, as printed or mended: the forces on the four vertices."""
    lambda_, mu = lame
    edges = lambda rows: transpose([[x - y for x, y in zip(row, rows[0])] for row in rows[1:]])
    x_inverse, det = inverse(edges(points))
    e = product(edges(displacements), x_inverse)
    if mended:
        e = [[(e[i][j] + e[j][i]) / 2 for j in range(3)] for i in range(3)]
    trace = sum(e[i][i] for i in range(3))
    stress = [[2 * mu * e[i][j] + (lambda_ * trace if i == j else 0) for j in range(3)] for i in range(3)]
    x_t = transpose(x_inverse)
    force = product(stress, x_t) if mended else product(x_t, stress)
    columns = [[abs(det) / 6 * x for x in column] for column in transpose(force)]
    return [[-sum(column[i] for column in columns) for i in range(3)]] + columns


# ---- how it is drawn -------------------------------------------------------------------------------

class Drawing:
    """Shapes; y grows downwards. Shown at three quarters of this size, for cells of a table."""

    def __init__(self, width, height):
        self.width, self.height, self.rows = width, height, []

    def polygon(self, points, fill, stroke=EDGE, width=1.2, opacity=1.0):
        at = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
        see = f' fill-opacity="{opacity}"' if opacity < 1 else ""
        self.rows.append(f'<polygon points="{at}" fill="{fill}"{see} stroke="{stroke}" '
                         f'stroke-width="{width}" stroke-linejoin="round"/>')

    def line(self, points, colour, width=1.5, dash=""):
        at = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
        dashes = f' stroke-dasharray="{dash}"' if dash else ""
        self.rows.append(f'<polyline points="{at}" fill="none" stroke="{colour}" stroke-width="{width}" '
                         f'stroke-linecap="round" stroke-linejoin="round"{dashes}/>')

    def arrow(self, p, q, colour, width=2.0, head=7.0):
        dx, dy = q[0] - p[0], q[1] - p[1]
        size = math.hypot(dx, dy)
        dx, dy = dx / size, dy / size
        base = (q[0] - head * dx, q[1] - head * dy)
        self.line([p, base], colour, width)
        self.polygon([q, (base[0] - 0.5 * head * dy, base[1] + 0.5 * head * dx),
                      (base[0] + 0.5 * head * dy, base[1] - 0.5 * head * dx)], colour, colour, 0.5)

    def dot(self, p, colour=INK, radius=3.0):
        self.rows.append(f'<circle cx="{p[0]:.1f}" cy="{p[1]:.1f}" r="{radius}" fill="{colour}"/>')

    def ring(self, p, colour=WRONG, radius=7.0):
        self.rows.append(f'<circle cx="{p[0]:.1f}" cy="{p[1]:.1f}" r="{radius}" fill="none" '
                         f'stroke="{colour}" stroke-width="2"/>')

    def text(self, p, words, colour=INK, size=15, weight="", anchor="middle", slanted=False):
        bold = f' font-weight="{weight}"' if weight else ""
        style = ' font-style="italic"' if slanted else ""
        self.rows.append(f'<text x="{p[0]:.1f}" y="{p[1]:.1f}" text-anchor="{anchor}" font-size="{size}"'
                         f'{bold}{style} fill="{colour}">{words}</text>')

    def write(self, folder, name, title):
        with open(os.path.join(folder, name + ".svg"), "w", encoding="utf-8") as out:
            out.write(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {self.width} {self.height}" '
                      f'width="{self.width * 3 // 4}" height="{self.height * 3 // 4}" role="img" '
                      f'font-family="sans-serif">\n<title>{title}</title>\n'
                      f'<rect width="{self.width}" height="{self.height}" fill="#ffffff"/>\n'
                      + "\n".join(self.rows) + "\n</svg>\n")


def middle(points):
    points = list(points)
    return tuple(sum(p[i] for p in points) / len(points) for i in range(len(points[0])))


def towards(p, q, share):
    return tuple(a + share * (b - a) for a, b in zip(p, q))


def outside(p, centre, distance):
    """Beside p, away from the centre: where its number goes."""
    dx, dy = p[0] - centre[0], p[1] - centre[1]
    size = math.hypot(dx, dy) or 1.0
    return (p[0] + distance * dx / size, p[1] + distance * dy / size + 5)


def draw_cut(drawing, cells, places, cut, gape=0.16, fill=CELL):
    """Triangles after unglue(cells, cut): copies move towards their cells, so that what opened gapes."""
    least = classes(cells, cut)
    at = {}
    for name in set(least.values()):
        v = name[0]
        own = [c for (w, c), other in least.items() if other == name and w == v]
        home = middle(middle(places[w] for w in cells[c]) for c in own)
        at[name] = towards(places[v], home, gape) if copies(cells, cut, v) > 1 else places[v]
    corner = lambda v, c: at[least[v, c]]
    for c, cell in enumerate(cells):
        drawing.polygon([corner(v, c) for v in cell], fill)
    is_open = opened(cells, cut)
    for facet, own in sorted(sides(cells).items(), key=lambda item: sorted(item[0])):
        ends = sorted(facet)
        if facet in is_open:
            for c in own:
                drawing.line([corner(v, c) for v in ends], DARK, 3)
        elif facet in cut:
            drawing.line([corner(v, own[0]) for v in ends], SHUT, 3.4, "7 5")
    return at


# ---- the pictures ----------------------------------------------------------------------------------

def figure_7():
    """Six triangles; the edge between the two inner vertices alone stays shut."""
    cells = [(0, 1, 2), (0, 2, 4), (0, 4, 3), (0, 3, 1), (1, 3, 5), (1, 5, 2)]
    cut = {frozenset((0, 1))}
    assert not opened(cells, cut)
    places = {0: (186, 150), 1: (294, 150), 2: (240, 28), 3: (240, 272), 4: (34, 150), 5: (446, 150)}
    drawing = Drawing(480, 300)
    draw_cut(drawing, cells, places, cut)
    for vertex, colour in ((0, GREEN), (1, GREEN)):
        around = chain(cells, cut, vertex, frozenset((0, 1)))
        assert len(around) == 4
        path = [middle(places[v] for v in cells[c]) for c in around]
        for p, q in zip(path, path[1:]):
            drawing.arrow(p, q, colour, 1.8, 6)
        drawing.dot(path[0], colour, 3.5)
    for v, p in places.items():
        drawing.dot(p)
        beside = {0: (p[0] - 13, p[1] - 7), 1: (p[0] + 13, p[1] - 7)}.get(v) or outside(p, (240, 150), 16)
        drawing.text(beside, v, size=16)
    return drawing


def split_tetrahedron():
    """A tetrahedron split into four at an inner vertex; one inner facet alone stays shut."""
    cells = [(0, 1, 2, 4), (0, 1, 3, 4), (0, 2, 3, 4), (1, 2, 3, 4)]
    inner = [facet for facet, at in sides(cells).items() if len(at) == 2]
    assert len(inner) == 6 and all(not opened(cells, {facet}) for facet in inner)
    cut = {frozenset((0, 1, 4))}
    assert all(len(chain(cells, cut, v, frozenset((0, 1, 4)))) == 3 for v in (0, 1, 4))
    places = {0: (78, 232), 1: (402, 246), 2: (290, 150), 3: (232, 30), 4: (246, 172)}
    drawing = Drawing(480, 300)
    drawing.polygon([places[v] for v in (0, 1, 3)], CELL, "none", 0, 0.45)
    for a, b in combinations(range(5), 2):
        inner_edge = 4 in (a, b)
        hidden = 2 in (a, b) or inner_edge
        drawing.line([places[a], places[b]], QUIET if inner_edge else INK, 1.2 if hidden else 1.8,
                     "4 4" if hidden and not inner_edge else "")
    drawing.polygon([places[v] for v in (0, 1, 4)], SHUT, SHUT, 2.4, 0.45)
    for v, p in places.items():
        drawing.dot(p)
        shift = {0: (-14, 12), 1: (14, 12), 2: (14, -6), 3: (0, -10), 4: (-4, -11)}[v]
        drawing.text((p[0] + shift[0], p[1] + shift[1]), v, size=16)
    return drawing


def glue():
    """Figure 6: the corners at a vertex, those that are glued, and a copy for each class."""
    cells = [(0, i, i % 6 + 1) for i in range(1, 7)]
    cut = {frozenset((0, 1)), frozenset((0, 3))}
    least = classes(cells, cut)
    at_0 = [least[0, c] for c in range(6)]
    assert copies(cells, cut, 0) == 2 and opened(cells, cut) == cut
    colours = {at_0[0]: WRONG, at_0[2]: GREEN}
    drawing = Drawing(620, 330)
    for panel, words in ((0, "six corners at 0, two classes"), (1, "a copy of 0 for each class")):
        x, y = 155 + 310 * panel, 150
        places = {0: (x, y)}
        for i in range(6):
            angle = math.radians(60 * i + 30)
            places[i + 1] = (x + 122 * math.cos(angle), y - 122 * math.sin(angle))
        if panel == 1:
            at = draw_cut(drawing, cells, places, cut, 0.16)
            for name, p in sorted(at.items()):
                drawing.dot(p, colours.get(name, INK), 6 if name in colours else 3)
                if name[0] == 0:
                    drawing.text((p[0], p[1] + (25 if p[1] > y else -13)), 0 if name == min(colours) else 7,
                                 size=16)
                elif copies(cells, cut, name[0]) == 1:
                    drawing.text(outside(p, (x, y), 15), name[0], size=16)
        else:
            for cell in cells:
                drawing.polygon([places[v] for v in cell], CELL, EDGE, 2)
            for facet in sorted(cut, key=sorted):
                drawing.line([places[v] for v in sorted(facet)], SHUT, 3.4, "7 5")
            spot = [towards(places[0], middle(places[v] for v in cell), 0.48) for cell in cells]
            for facet, own in sorted(sides(cells).items(), key=lambda item: sorted(item[0])):
                if len(own) == 2 and 0 in facet and facet not in cut:
                    drawing.line([spot[c] for c in own], colours[at_0[own[0]]], 2.4)
            for c in range(6):
                drawing.dot(spot[c], colours[at_0[c]], 6)
                place = towards(places[0], middle(places[v] for v in cells[c]), 1.12)
                drawing.text((place[0], place[1] + 5), c, QUIET, 14, slanted=True)
            drawing.dot(places[0], INK, 4)
            for v in range(1, 7):
                drawing.text(outside(places[v], (x, y), 15), v, size=16)
        drawing.text((x, 318), words, QUIET)
    return drawing


def figure_8():
    """Two triangles that share a vertex and no facet, before and after the empty cut."""
    cells = [(0, 1, 2), (0, 3, 4)]
    assert copies(cells, set(), 0) == 2
    drawing = Drawing(480, 250)
    for panel, apart in ((0, 0), (1, 11)):
        x = 120 + 240 * panel
        left, right = (x - apart, 110), (x + apart, 110)
        ends = {1: (x - 88, 40), 2: (x - 88, 180), 3: (x + 88, 180), 4: (x + 88, 40)}
        drawing.polygon([left, ends[1], ends[2]], CELL, INK, 1.2)
        drawing.polygon([right, ends[3], ends[4]], OTHER if panel else CELL, INK, 1.2)
        for v, p in ends.items():
            drawing.dot(p)
            drawing.text((p[0] + (-14 if v < 3 else 14), p[1] + 5), v, size=16)
        for p in {left, right}:
            drawing.dot(p, WRONG if panel == 0 else INK, 4)
        if panel == 0:
            drawing.text((x, 96), 0, WRONG, 16, "bold")
        else:
            drawing.text((left[0], 96), 0, size=16)
            drawing.text((right[0], 96), 5, size=16)
    drawing.text((120, 230), "before", QUIET)
    drawing.text((360, 230), "after the empty cut", QUIET)
    return drawing


def strip():
    """Eight triangles: two cuts that open nothing one after the other, and both edges at once."""
    cells = [(0, 1, 3), (1, 2, 3), (0, 1, 4), (1, 2, 4), (0, 3, 5), (0, 4, 5), (2, 3, 6), (2, 4, 6)]
    one, other = frozenset((0, 1)), frozenset((1, 2))
    assert not opened(cells, {one}) and not opened(cells, {other})
    assert opened(cells, {one, other}) == {one, other} and copies(cells, {one, other}, 1) == 2
    drawing = Drawing(780, 290)
    for panel, cut, words in ((0, {one}, "0-1 alone: shut"), (1, {other}, "then 1-2 alone: shut"),
                              (2, {one, other}, "0-1 and 1-2 together: open")):
        x = 130 + 260 * panel
        places = {0: (x - 62, 130), 1: (x, 130), 2: (x + 62, 130), 3: (x, 30), 4: (x, 230),
                  5: (x - 108, 130), 6: (x + 108, 130)}
        at = draw_cut(drawing, cells, places, cut, 0.22)
        for name, p in sorted(at.items()):
            drawing.dot(p)
            v = name[0]
            shift = {0: (2, -9), 2: (-2, -9), 3: (0, -9), 4: (0, 20), 5: (-10, 5), 6: (10, 5)}
            dx, dy = shift.get(v, (9, -6))
            if v == 1 and panel == 2:
                dx, dy = (0, -9) if p[1] < 130 else (0, 20)
            label = 7 if v == 1 and panel == 2 and p[1] > 130 else v
            drawing.text((p[0] + dx, p[1] + dy), label, size=14)
        drawing.text((x, 278), words, QUIET)
    return drawing


def lemma_1():
    """Heights of four vertices over a plane at which the closest-vertex set has all four."""
    half = Fraction(1, 2)
    drawing = Drawing(640, 300)
    for panel, heights in ((0, (Fraction(1), half, Fraction(-1), -half)),
                           (1, (Fraction(1), Fraction(-1), -half, -half))):
        chosen = closest(heights)
        assert len(chosen) == 4 and len({abs(h) for h in heights}) > 1
        left = 320 * panel
        y = lambda h: 140 - 100 * float(h)
        xs = (80, 150, 220, 280) if panel == 0 else (165, 70, 170, 260)
        places = [(left + x, y(h)) for x, h in zip(xs, heights)]
        if panel == 0:
            places = [(left + 90, y(1)), (left + 235, y(half)), (left + 245, y(-1)), (left + 75, y(-half))]
        drawing.polygon([(left + 24, 150), (left + 284, 150), (left + 300, 130), (left + 40, 130)],
                        "#dddddd", "#bbbbbb", 1, 0.7)
        for i, j in combinations(range(4), 2):
            crosses = heights[i] * heights[j] < 0
            drawing.line([places[i], places[j]], INK if crosses else QUIET, 1.4, "" if crosses else "3 4")
            if not crosses:
                continue
            share = heights[i] / (heights[i] - heights[j])
            meets = towards(places[i], places[j], float(share))
            nearer = [k for k, size in ((i, abs(heights[i])), (j, abs(heights[j])))
                      if size <= min(abs(heights[i]), abs(heights[j]))]
            for k in nearer:
                drawing.arrow(meets, towards(places[k], meets, 0.12), WRONG if len(nearer) == 2 else DARK, 2.2)
            drawing.dot(meets, INK, 2.6)
        for p, h in zip(places, heights):
            drawing.dot(p, INK, 4.5)
            words = str(h).replace("-", "−")
            side = 1 if p[0] > left + 165 else -1
            if panel == 1 and xs[1] < p[0] - left < xs[3]:
                drawing.text((p[0] + 12, p[1] - 5), words, size=15, anchor="start")
            else:
                drawing.text((p[0] + 12 * side, p[1] + (18 if h < 0 else -4)), words, size=15,
                             anchor="start" if side > 0 else "end")
    drawing.text((160, 286), "two above, two below", QUIET)
    drawing.text((480, 286), "one above, three below", QUIET)
    return drawing


def meets(p, q, triangle):
    """Whether the segment pq and the triangle have a point in common; a segment in its plane counts."""
    minus = lambda a, b: [x - y for x, y in zip(a, b)]
    det = lambda u, v, w: sum(u[i] * (v[i - 2] * w[i - 1] - v[i - 1] * w[i - 2]) for i in range(3))
    a, b, c = triangle
    side = lambda x: det(minus(b, a), minus(c, a), minus(x, a))
    if side(p) * side(q) > 0:
        return False
    turns = [det(minus(q, p), minus(x, p), minus(y, p)) for x, y in ((a, b), (b, c), (c, a))]
    return not min(turns) < 0 < max(turns)


def sweep_and_cell():
    """A sweep that enters a cell through a face and meets no edge; a plane through a vertex of a cell."""
    points = [(0, 0, 0), (4, 0, 0), (0, 4, 0), (0, 0, 4)]
    blade = [(1, 1, -1), (2, 1, -1), (1, 1, 1)]
    tip = blade[2]
    assert min(tip) > 0 and sum(tip) < 4  # inside
    assert not any(meets(p, q, blade) for p, q in combinations(points, 2))
    drawing = Drawing(640, 300)
    place = lambda p: (118 + 40 * p[0] - 18 * p[1], 190 + 5 * p[0] + 14 * p[1] - 42 * p[2])
    crossing = [towards(tip, low, 0.5) for low in blade[:2]]
    assert all(p[2] == 0 for p in crossing)
    drawing.polygon([place(p) for p in blade], SHUT, "none", 0, 0.75)
    drawing.polygon([place(points[v]) for v in (1, 2, 3)], CELL, "none", 0, 0.6)
    for i, j in combinations(range(4), 2):
        hidden = 0 in (i, j)
        drawing.line([place(points[i]), place(points[j])], QUIET if hidden else INK, 1.5, "4 4" if hidden else "")
    drawing.line([place(p) for p in crossing], WRONG, 3)
    drawing.dot(place(tip), INK, 3)
    drawing.text((160, 290), "a sweep that meets no edge", QUIET)

    heights = (0, 3, -1, -2)
    chosen = closest(heights)
    assert chosen == {0, 2, 3}
    places = [(x, 140 - 34 * h) for x, h in zip((410, 480, 450, 560), heights)]
    drawing.polygon([(344, 150), (604, 150), (620, 130), (360, 130)], "#dddddd", "#bbbbbb", 1, 0.7)
    for i, j in combinations(range(4), 2):
        crosses = heights[i] * heights[j] <= 0
        drawing.line([places[i], places[j]], INK if crosses else QUIET, 1.4, "" if crosses else "3 4")
        if heights[i] * heights[j] < 0:
            share = Fraction(heights[i], heights[i] - heights[j])
            at = towards(places[i], places[j], float(share))
            k = i if abs(heights[i]) < abs(heights[j]) else j
            drawing.arrow(at, towards(places[k], at, 0.12), DARK, 2.2)
            drawing.dot(at, INK, 2.6)
    for v, p in enumerate(places):
        drawing.dot(p, WRONG if heights[v] == 0 else INK, 4.5)
        words = str(heights[v]).replace("-", "−")
        drawing.text((p[0] + (-14 if v in (0, 2) else 12), p[1] + (16 if heights[v] < 0 else -4)), words, size=15)
    drawing.text((480, 290), "a plane through a vertex", QUIET)
    return drawing


def branching():
    """Nearest-vertex selection on a straight sweep in general position that branches."""
    inner, outer = (0, -2), [(-2, -10), (5, 3), (1, 1), (-10, 4)]
    points = [inner] + outer
    assert all(y != 0 for _, y in points) and len({abs(y) for _, y in points}) == len(points)
    cells = [(0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 1)]
    chosen = {}
    for cell in cells:
        found = closest([points[v][1] for v in cell])
        if len(found) == 2:
            edge = tuple(sorted(cell[i] for i in found))
            chosen[edge] = chosen.get(edge, 0) + 1
    assert set(chosen) == {(0, 2), (0, 3), (0, 4)}
    # The same in space: tetrahedra around an edge at height -2, whose link are the outer points.
    for a, b in ((1, 2), (2, 3), (3, 4), (4, 1)):
        heights = [-2, -2, points[a][1], points[b][1]]
        assert len(closest(heights)) == (3 if (0, a) in chosen or (0, b) in chosen else 2)
    drawing = Drawing(480, 300)
    place = lambda p: (250 + 21 * p[0], 92 - 18 * p[1])
    for cell in cells:
        drawing.polygon([place(points[v]) for v in cell], CELL)
    drawing.line([(24, 92), (456, 92)], INK, 2, "2 5")
    drawing.text((452, 82), "sweep", INK, 14, anchor="end", slanted=True)
    for edge, by in sorted(chosen.items()):
        drawing.line([place(points[v]) for v in edge], WRONG if by == 2 else DARK, 4)
    for v, p in enumerate(points):
        drawing.dot(place(p), INK, 3.5)
        shift = {0: (-14, 14), 1: (16, 6), 2: (14, 0), 3: (10, -8), 4: (-12, 0)}[v]
        x, y = place(p)
        drawing.text((x + shift[0], y + shift[1]), v, size=16)
    return drawing


def equation_1():
    """A rotation of the unit cell, and the forces that equation (1) as printed makes of it."""
    unit = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
    rotated = [(-y, x, 0) for x, y, _ in unit]  # e3 cross p
    lame = (Fraction(1), Fraction(1))
    third = Fraction(1, 3)
    printed = cell_forces(unit, rotated, lame, mended=False)
    assert printed == [[third, -third, 0], [0, third, 0], [-third, 0, 0], [0, 0, 0]]
    assert all(x == 0 for force in cell_forces(unit, rotated, lame, mended=True) for x in force)
    sheared = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 0, 1)]
    only = lambda axis: [[0, 0, 0], [int(i == axis) for i in range(3)], [0, 0, 0], [0, 0, 0]]
    along_x, along_y = (cell_forces(sheared, only(axis), lame, mended=False)[1] for axis in (0, 1))
    assert along_x[1] == Fraction(-1, 2) and along_y[0] == Fraction(-1, 6)
    along_x, along_y = (cell_forces(sheared, only(axis), lame, mended=True)[1] for axis in (0, 1))
    assert along_x[1] == along_y[0]

    drawing = Drawing(520, 280)
    place = lambda p: (200 + 190 * p[0] - 100 * p[1], 170 + 30 * p[0] + 70 * p[1] - 130 * p[2])
    drawing.polygon([place(unit[v]) for v in (1, 2, 3)], CELL, "none", 0, 0.6)
    for i, j in combinations(range(4), 2):
        hidden = 0 in (i, j)
        drawing.line([place(unit[i]), place(unit[j])], QUIET if hidden else INK, 1.5, "4 4" if hidden else "")
    for p, u, f in zip(unit, rotated, printed):
        if any(u):
            drawing.arrow(place(p), place([x + 0.42 * y for x, y in zip(p, u)]), GREEN, 2.2)
        if any(f):
            shift = 7 if any(u) else 0
            start, end = place(p), place([float(x + Fraction(11, 10) * y) for x, y in zip(p, f)])
            drawing.arrow((start[0], start[1] + shift), (end[0], end[1] + shift), WRONG, 2.6)
    for v, beside in enumerate(((-10, -8), (14, -6), (-14, -6), (0, -10))):
        x, y = place(unit[v])
        drawing.dot((x, y), INK, 3.5)
        drawing.text((x + beside[0], y + beside[1]), v, size=16)
    for y, colour, words in ((42, GREEN, "displacement"), (66, WRONG, "force as printed")):
        drawing.arrow((340, y), (380, y), colour, 2.4)
        drawing.text((388, y + 5), words, INK, 14, anchor="start")
    return drawing


def supports():
    """A cell held in one vertex: a rotation about it costs no energy, so K is not definite."""
    points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
    rotated = [(-y, x, 0) for x, y, _ in points]
    force = cell_forces(points, rotated, (Fraction(1), Fraction(1)), mended=True)
    assert rotated[0] == (0, 0, 0) and any(any(u) for u in rotated)
    assert sum(x * y for u, f in zip(rotated, force) for x, y in zip(u, f)) == 0
    drawing = Drawing(480, 300)
    for angle, fill, stroke, dash in ((0.0, CELL, INK, ""), (0.42, "none", GREEN, "6 5")):
        turned = lambda p, a=angle: (p[0] * math.cos(a) - p[1] * math.sin(a), p[0] * math.sin(a) + p[1] * math.cos(a))
        place = lambda p, t=turned: (170 + 210 * t(p)[0], 250 - 210 * t(p)[1])
        corners = [place(p) for p in ((0, 0), (1, 0), (0.35, 0.8))]
        if dash:
            drawing.line(corners + corners[:1], stroke, 2, dash)
            for p, q in zip(before, corners):
                if p != q:
                    drawing.arrow(towards(p, q, 0.12), towards(p, q, 0.88), GREEN, 2)
        else:
            drawing.polygon(corners, fill, stroke, 1.5)
        before = corners
    drawing.polygon([(170, 250), (156, 276), (184, 276)], INK, INK, 1)
    drawing.line([(146, 277), (194, 277)], INK, 2)
    drawing.dot((170, 250), WRONG, 5)
    drawing.text((205, 270), "the only vertex held", INK, 14, anchor="start")
    return drawing


def hinge():
    """Two triangles that share a vertex and no facet turn about it, and no strain tells."""
    cells = [(0, 1, 2), (0, 3, 4)]
    assert copies(cells, set(), 0) == 2 and not any(len(at) == 2 for at in sides(cells).values())
    drawing = Drawing(480, 290)
    place = lambda x, y: (240 + x, 185 - y)
    for angle, dash in ((0.0, ""), (0.8, "6 5")):
        turned = lambda x, y, a=angle: place(x * math.cos(a) - y * math.sin(a), x * math.sin(a) + y * math.cos(a))
        right = [turned(0, 0), turned(150, -42), turned(150, 42)]
        if dash:
            drawing.line(right + right[:1], GREEN, 2, dash)
            for p, q in [(middle(before[1:]), middle(right[1:]))]:
                drawing.arrow(towards(p, q, 0.12), towards(p, q, 0.88), GREEN, 2)
        else:
            drawing.polygon([place(0, 0), place(-150, 52), place(-150, -52)], CELL, INK, 1.5)
            drawing.polygon(right, OTHER, INK, 1.5)
        before = right
    drawing.line([place(-150, 66), place(-150, -66)], INK, 4)
    drawing.dot(place(0, 0), WRONG, 5)
    drawing.text((240, 216), "hinge", WRONG, 15)
    drawing.text((90, 274), "held", INK, 14)
    return drawing


def torus():
    """The torus with seven vertices unrolled, and on it a cycle that does not separate it."""
    triangles = [tuple(sorted((i, (i + a) % 7, (i + 3) % 7))) for i in range(7) for a in (1, 2)]
    assert len(set(triangles)) == 14 and all(len(at) == 2 for at in sides(triangles).values())
    cycle = (0, 1, 2)
    edges = {frozenset(pair) for pair in combinations(cycle, 2)}
    assert all(edge in sides(triangles) for edge in edges) and frozenset(cycle) not in map(frozenset, triangles)
    apexes = ("a", "b")
    cells = [t + (apex,) for t in triangles for apex in apexes]
    cells = [tuple(v if isinstance(v, int) else 7 + apexes.index(v) for v in cell) for cell in cells]
    cut = {edge | {7} for edge in edges}
    for vertex in cycle:  # every interior ridge at the apex has degree 0 or 2
        assert sum(frozenset((7, vertex)) <= facet for facet in cut) == 2
    assert not opened(cells, cut) and copies(cells, cut, 7) == 1
    drawing = Drawing(520, 226)
    # Unrolled: a step right adds 1 to the number of a vertex, a step up adds 3.
    place = lambda i, j: (42 + 56 * i + 28 * j, 148 - 92 * j)
    number = lambda i, j: (i + 3 * j) % 7
    for i in range(7):
        for corner in ([(i, 0), (i + 1, 0), (i, 1)], [(i + 1, 0), (i + 1, 1), (i, 1)]):
            assert tuple(sorted(number(*at) for at in corner)) in triangles
            drawing.polygon([place(*at) for at in corner], CELL, "#ffffff", 1.6)
    grid = [(i, j) for i in range(8) for j in range(2)]
    for p, q in combinations(grid, 2):
        if (q[0] - p[0], q[1] - p[1]) in ((1, 0), (0, 1), (-1, 1)) or (p[0] - q[0], p[1] - q[1]) == (-1, 1):
            if frozenset((number(*p), number(*q))) in edges:
                drawing.line([place(*p), place(*q)], SHUT, 4.5)
    for at in grid:
        drawing.dot(place(*at), "#ffffff", 10)
        drawing.text((place(*at)[0], place(*at)[1] + 5), number(*at), INK, 15)
    drawing.text((260, 188), "orange: the cut, three facets from these edges to tip 7", SHUT)
    drawing.text((260, 212), "equal numbers are one vertex; each triangle is joined to 7 and 8", QUIET, 14)
    return drawing


def ring():
    """Sixteen triangles around a hole, and a blade from the hole to the outside: one edge, one piece."""
    cells = []
    for i in range(8):
        j = (i + 1) % 8
        cells += [(i, 8 + i, j), (8 + i, j, 8 + j)]
    around = [(2, 1), (1, 2), (-1, 2), (-2, 1), (-2, -1), (-1, -2), (1, -2), (2, -1)]
    points = {i + 8 * k: (size * x, size * y) for i, (x, y) in enumerate(around) for k, size in ((0, 2), (1, 1))}
    blade = ((Fraction(0), Fraction(0)), (Fraction(26, 5), Fraction(13, 5)))
    turn = lambda p, q, r: (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
    centres = [tuple(Fraction(sum(points[v][k] for v in cell), 3) for k in range(2)) for cell in cells]
    inner = {facet: at for facet, at in sides(cells).items() if len(at) == 2}
    assert len(inner) == 16 and all(len(at) < 3 for at in sides(cells).values())

    def crosses(at):
        p, q = (centres[c] for c in at)
        signs = [turn(*blade, p), turn(*blade, q), turn(p, q, blade[0]), turn(p, q, blade[1])]
        assert 0 not in signs
        return signs[0] * signs[1] < 0 and signs[2] * signs[3] < 0

    cut = {facet for facet, at in inner.items() if crosses(at)}
    assert cut == {frozenset((0, 8))} and opened(cells, cut) == cut
    # Every vertex is on the boundary: no ridge inside at which the number could be odd.
    assert all(any(v in facet and len(at) == 1 for facet, at in sides(cells).items()) for v in points)
    reached = [0]
    for c in reached:
        for facet, at in inner.items():
            reached += [d for d in at if c in at and facet not in cut and d not in reached]
    assert len(reached) == len(cells)
    drawing = Drawing(420, 330)
    place = lambda p: (175 + 38 * float(p[0]), 165 - 38 * float(p[1]))
    places = {v: place(p) for v, p in points.items()}
    draw_cut(drawing, cells, places, cut, gape=0.13)
    drawing.line([place(p) for p in blade], WRONG, 2.4)
    for end in blade:
        drawing.dot(place(end), WRONG, 4)
    at = place((Fraction(26, 5), Fraction(13, 5)))
    drawing.text((at[0], at[1] - 10), "blade", WRONG, 15)
    drawing.text(place((Fraction(-1, 10), Fraction(-1))), "hole", QUIET, 15)
    return drawing


def moebius():
    """Five triangles on five vertices, every edge in at most two, that nothing orients."""
    cells = [(0, 1, 2), (1, 2, 3), (2, 3, 4), (3, 4, 0), (4, 0, 1)]
    assert all(len(at) <= 2 for at in sides(cells).values())
    joins = [at for at in sides(cells).values() if len(at) == 2]

    def induced(cell, facet):
        i = next(k for k, v in enumerate(cell) if v not in facet)
        rest = [v for v in cell if v in facet]
        return (1 if i % 2 == 0 else -1) * (1 if rest == sorted(rest) else -1)

    signs = range(2 ** len(cells))
    coherent = lambda s, at: (induced(cells[at[0]], set(cells[at[0]]) & set(cells[at[1]]))
                              * (1 if s >> at[0] & 1 else -1)
                              == -induced(cells[at[1]], set(cells[at[0]]) & set(cells[at[1]]))
                              * (1 if s >> at[1] & 1 else -1))
    assert not any(all(coherent(s, at) for at in joins) for s in signs)
    drawing = Drawing(480, 230)
    strip_ = [0, 1, 2, 3, 4, 0, 1]
    places = [(55 + 62 * i, 160 if i % 2 == 0 else 60) for i in range(7)]
    for i in range(5):
        corner = places[i:i + 3]
        drawing.polygon(corner, CELL, "#ffffff", 1.4)
        centre = middle(corner)
        turns = [2 * math.pi * k / 24 for k in range(3, 22)]
        ring = [(centre[0] + 14 * math.cos(a), centre[1] + 14 * math.sin(a)) for a in turns]
        drawing.line(ring, DARK, 1.6)
        drawing.arrow(ring[-2], ring[-1], DARK, 1.6, 7)
    for ends in (places[:2], places[5:]):
        drawing.arrow(towards(ends[0], ends[1], 0.1), towards(ends[0], ends[1], 0.9), WRONG, 3, 11)
    for v, p in zip(strip_, places):
        drawing.dot(p, INK, 3.5)
        drawing.text((p[0], p[1] + (22 if p[1] > 100 else -10)), v, size=16)
    drawing.text((240, 215), "the two red edges are one", QUIET)
    return drawing


def first_step():
    """One step of conjugate gradients that lowers the error by less than the bound allows."""
    kappa = 4
    error = (Fraction(4), Fraction(1))  # of the start; the matrix is diag(1, 4)
    residual = (error[0], kappa * error[1])
    alpha = (residual[0] ** 2 + residual[1] ** 2) / (residual[0] ** 2 + kappa * residual[1] ** 2)
    after = tuple(e - alpha * r for e, r in zip(error, residual))
    energy = lambda e: e[0] ** 2 + kappa * e[1] ** 2
    assert energy(after) / energy(error) == Fraction(9, 25)      # so the error falls by 3/5
    bound = Fraction(math.isqrt(kappa) - 1, math.isqrt(kappa) + 1)
    assert bound == Fraction(1, 3) and Fraction(3, 5) > bound
    drawing = Drawing(480, 300)
    place = lambda e: (235 + 47 * float(e[0]), 135 - 47 * float(e[1]))
    for level, colour in ((energy(error), QUIET), (energy(after), QUIET), (energy(error) * bound ** 2, GREEN)):
        size = math.sqrt(float(level))
        drawing.line([place((size * math.cos(2 * math.pi * k / 90), size / 2 * math.sin(2 * math.pi * k / 90)))
                      for k in range(91)], colour, 1.4, "" if colour == QUIET else "5 4")
    drawing.arrow(place(error), place(after), WRONG, 2.6)
    drawing.dot(place(error), INK, 4)
    drawing.dot(place((0, 0)), INK, 4)
    x, y = place(error)
    drawing.text((x + 8, y - 8), "start", INK, 15, anchor="start")
    drawing.text((place((0, 0))[0], place((0, 0))[1] - 8), "solution", INK, 14)
    drawing.arrow((24, 282), (54, 282), WRONG, 2.6)
    drawing.text((62, 287), "one step: 3/5 of the error is left", INK, 14, anchor="start")
    drawing.line([(314, 282), (344, 282)], GREEN, 1.4, "5 4")
    drawing.text((352, 287), "1/3 of it", INK, 14, anchor="start")
    return drawing


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__))
    for draw in (figure_7, split_tetrahedron, glue, figure_8, strip, lemma_1, sweep_and_cell, branching,
                 equation_1, supports, hinge, torus, ring, moebius, first_step):
        draw().write(folder, draw.__name__.replace("_", "-"), draw.__doc__)  # one line, without < and &


if __name__ == "__main__":
    main()
