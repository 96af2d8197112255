#!/usr/bin/env python3
"""Draws what a cut costs over its size and that of the mesh: plot.py PROGRAM OUT.svg

Runs `topology_bench` with cold caches; needs gnuplot.
"""
import subprocess
import sys

import figures
from tables import count

STYLES = {40: "lc rgb '#4477aa' pt 7", 100: "lc rgb '#228833' pt 5", 159: "lc rgb '#aa3377' pt 9"}


def script(counters, out):
    """What gnuplot is told."""
    points = {}
    for name, values in counters.items():
        given = figures.parameters(name)[1]
        points.setdefault(given["cubes"], []).append(
            (given["facets"], values["ns/facet"], values["verified"], values["flat"]))
    lines = ["set terminal svg size 760,440 font 'sans,13' background 'white'",
             f"set output '{out}'", "set logscale xy", "set xlabel 'facets in the cut'",
             "set ylabel 'nanoseconds per facet'", "set grid ytics lc rgb '#dddddd'",
             "set key outside right top Left reverse", "set format x '10^{%T}'", "set border 3",
             "set tics nomirror", "set xrange [0.7:1e6]"]
    plots = []
    for cubes, rows in sorted(points.items()):
        block = f"$cubes{cubes}"
        lines += [f"{block} << end", *(" ".join(map(str, row)) for row in sorted(rows)), "end"]
        tets = count(6 * cubes ** 3)
        for column, what, dash in ((2, "unglue", 1), (3, "verified", 2), (4, "plain arrays", 3)):
            plots.append(f"{block} using 1:{column} with linespoints ps 0.6 dt {dash} lw 1.5 "
                         f"{STYLES[cubes]} title '{what}, {tets} tets'")
    return "\n".join([*lines, "plot " + ", \\\n  ".join(plots), ""])


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    subprocess.run(["gnuplot"], check=True, text=True, input=script(
        figures.run(sys.argv[1], "^unglue_patches/.*cold:1"), sys.argv[2]))
