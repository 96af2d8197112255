#!/usr/bin/env python3
"""Draws the pictures of docs/guides from what the programs in examples/ write.

    docs/pictures/guides.py PROGRAMS [OUT]    PROGRAMS is the folder of example_seams, example_crack

Needs nothing but Python. The pictures, guide-seams.svg and guide-crack.svg, are written to the
folder OUT, or beside this script; the same programs give the same bytes.
"""

import os
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
LIGHT, CRACK, EDGE, SEAM = (158, 202, 225), (230, 85, 13), "#4a6a85", "#d7191c"


def obj_of(program):
    """Points, texture places and faces (vertex numbers from 0) of what an example writes."""
    with tempfile.NamedTemporaryFile(suffix=".obj") as file:
        subprocess.run([program, file.name], check=True, stdout=subprocess.DEVNULL)
        rows = [line.split() for line in open(file.name, encoding="ascii")]
    points = [tuple(map(float, row[1:])) for row in rows if row[0] == "v"]
    places = [tuple(map(float, row[1:])) for row in rows if row[0] == "vt"]
    faces = [[int(v.split("/")[0]) - 1 for v in row[1:]] for row in rows if row[0] == "f"]
    return points, places, faces


def svg(width, height, shapes, title):
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" '
            f'width="{width}" height="{height}" font-family="sans-serif" font-size="14">'
            f"<title>{title}</title>\n"
            f'<rect width="{width}" height="{height}" fill="white"/>\n' + "\n".join(shapes) +
            "\n</svg>\n")


def polygon(corners, fill, stroke=EDGE, width=0.7):
    path = " ".join(f"{x:.1f},{y:.1f}" for x, y in corners)
    return (f'<polygon points="{path}" fill="{fill}" stroke="{stroke}" stroke-width="{width}" '
            f'stroke-linejoin="round"/>')


def line(a, b, colour, width):
    return (f'<line x1="{a[0]:.1f}" y1="{a[1]:.1f}" x2="{b[0]:.1f}" y2="{b[1]:.1f}" '
            f'stroke="{colour}" stroke-width="{width}" stroke-linecap="round"/>')


def text(x, y, words):
    return f'<text x="{x}" y="{y}" text-anchor="middle" fill="#222">{words}</text>'


def towards_the_eye(point, scale, origin):
    """An oblique view: x to the right, y to the back, z upwards; and the depth."""
    x, y, z = point
    return (origin[0] + scale * (x + 0.42 * y), origin[1] - scale * (z + 0.36 * y)), y - 0.36 * z


def shaded(colour, corners):
    a, b, c = corners
    u, v = [p - q for p, q in zip(b, a)], [p - q for p, q in zip(c, a)]
    normal = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
    size = sum(n * n for n in normal) ** 0.5
    light = abs(0.3 * normal[0] - 0.5 * normal[1] + 0.8 * normal[2]) / (size or 1)
    return "#%02x%02x%02x" % tuple(round(c * (0.62 + 0.38 * min(1, light))) for c in colour)


def open_edges(faces):
    count = {}
    for face in faces:
        for a, b in zip(face, face[1:] + face[:1]):
            count[min(a, b), max(a, b)] = count.get((min(a, b), max(a, b)), 0) + 1
    return [edge for edge, times in sorted(count.items()) if times == 1]


def seams(program):
    points, places, faces = obj_of(program)
    shapes = []
    seen = lambda v: towards_the_eye(points[v], 120, (40, 210))[0]
    depth = lambda face: sum(towards_the_eye(points[v], 1, (0, 0))[1] for v in face)
    for face in sorted(faces, key=depth, reverse=True):
        shapes.append(polygon(map(seen, face), "rgba(158,202,225,0.55)"))
    for a, b in open_edges(faces):
        shapes.append(line(seen(a), seen(b), SEAM, 3))
    shapes.append(text(130, 260, f"{len(set(points))} points, 7 seams"))
    flat = lambda v: (260 + 340 * places[v][0], 230 - 255 * places[v][1] * 0.85)
    for face in faces:
        shapes.append(polygon(map(flat, face), "#c9dfee"))
    for a, b in open_edges(faces):
        shapes.append(line(flat(a), flat(b), SEAM, 3))
    shapes.append(text(430, 260, f"{len(points)} vertices, each with one place in the texture"))
    return svg(640, 280, shapes, "A cube with seven seams, and its texture")


def crack(program):
    points, _, faces = obj_of(program)
    limits = [(min(p[i] for p in points), max(p[i] for p in points)) for i in range(3)]
    on_side = lambda face, i, end: all(abs(points[v][i] - limits[i][end]) < 1e-9 for v in face)
    hidden = lambda face: on_side(face, 0, 0) or on_side(face, 1, 1) or on_side(face, 2, 0)
    outside = lambda face: any(on_side(face, i, end) for i in range(3) for end in (0, 1))
    depth = lambda face: sum(towards_the_eye(points[v], 1, (0, 0))[1] for v in face)
    shapes = []
    for face in sorted(faces, key=depth, reverse=True):
        if hidden(face):
            continue
        colour = shaded(LIGHT if outside(face) else CRACK, [points[v] for v in face])
        shapes.append(polygon([towards_the_eye(points[v], 62, (20, 350))[0] for v in face], colour))
    return svg(560, 370, shapes, "A branching crack in a block of tetrahedra, opened")


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    out = sys.argv[2] if len(sys.argv) == 3 else HERE
    for name, draw in (("seams", seams), ("crack", crack)):
        picture = draw(os.path.join(sys.argv[1], "example_" + name))
        with open(os.path.join(out, f"guide-{name}.svg"), "w", encoding="ascii") as file:
            file.write(picture)


main()
