#!/usr/bin/env python3
"""Measures the tables of docs/measurements.md and prints them in Markdown.

usage: tables.py PROGRAMS PROGRAMS64 [--write] [NAME..]

The first two are the folders of the programs with ids of 32 and of 64 bits. Without names: all
tables. Each is followed by the command that runs its benchmarks. With --write, the tables also take
the place of those in docs/measurements.md: what is there between "<!-- table NAME -->" and
"<!-- end -->".
"""
import os
import re
import sys

import figures
import peer_table
from peer_table import digits


def count(number):
    """12 345 678 as a reader wants it: 12.3M."""
    for unit, name in ((10**9, "G"), (10**6, "M")):
        if number >= unit:
            return f"{number / unit:.1f}".removesuffix(".0") + name
    return f"{number:,}".replace(",", " ")


def mesh(given):
    """The Kuhn cube of a row."""
    tetrahedra = count(6 * given["cubes"] ** 3)
    if "shuffled" in given:
        return tetrahedra + (", shuffled" if given["shuffled"] else ", in mesh order")
    return tetrahedra


def caches(given):
    return "no" if given.get("cold") else "yes"


class Table:
    """Columns are (heading, what to show): a counter's name, or a function of the parameters."""

    program = "topology_bench"

    def __init__(self, title, pattern, *columns):
        self.title, self.pattern, self.columns = title, pattern, columns

    def lines(self, counters):
        yield "| " + " | ".join(heading for heading, _ in self.columns) + " |"
        yield "|---" * len(self.columns) + "|"
        for name, values in counters.items():
            yield "| " + " | ".join(self.cell(what, name, values) for _, what in self.columns) + " |"

    @staticmethod
    def cell(what, name, values):
        if callable(what):
            return what(figures.parameters(name)[1])
        if what == "benchmark":
            return figures.parameters(name)[0].split("/")[-1].replace("_", " ")
        return digits(values[what]) if what in values else "-"

    def command(self, name):
        return (f"./dev bench --tables {name}\n"
                f"./dev bench -- --benchmark_filter='{self.pattern}'    # the benchmarks alone")


class PeerTable(Table):
    """One table for each dimension, as peer_table.py prints them."""

    program = "peers_bench"

    def lines(self, counters):
        by_dimension = {}
        for name, values in counters.items():
            dimension, row = name.split("/")[1:3]
            by_dimension.setdefault(dimension, {})[row] = values
        for dimension, rows in by_dimension.items():
            yield f"D = {dimension[1:]}:"
            yield ""
            yield from peer_table.lines(rows)
            yield ""


TETS = ("tetrahedra", mesh)
FLAT = ("yardstick", "flat")
RATIO = ("time / yardstick", "ratio")

TABLES = {
    "memory": Table(
        "The memory of the machine", "^memory_",
        ("", "benchmark"), ("MiB", lambda given: str(given["MiB"])), ("GB/s", "GB/s"),
        ("ns per load", "ns/load")),
    "mates": Table(
        "Mates from tuples, orientations compared: the first half of assembly, Mtet/s",
        "^match_cells/",
        TETS, ("ours", "Mtet/s"), FLAT, RATIO),
    "orientation": Table(
        "Mates and signs from tuples, Mtet/s", "^orient_cells/cubes:(40|100)/",
        TETS, ("`orient`", "Mtet/s"), FLAT, RATIO),
    "assembly": Table(
        "Assembly: from tuples to a validated complex, Mtet/s",
        "^assemble_cells/cubes:(40|63|80|100)/",
        TETS, ("`assemble`", "Mtet/s"), FLAT, RATIO, ("bytes per tet, held", "held_B/cell"),
        ("peak", "peak_B/cell")),
    "threads": Table(
        "Assembly on two threads, by the clock", "^assemble_on_two_threads/",
        TETS, ("times as fast as on one", "speedup"),
        ("ns per tet of the calling thread, one", "ours_of_1"), ("of two", "ours_of_2")),
    "neighbours": Table(
        "All neighbours: nanoseconds per tetrahedron", "^all_neighbours/",
        TETS, ("array of mates", "ns/tet"), FLAT, RATIO, ("`neighbours` of each cell", "range")),
    "stars": Table(
        "All stars, through the mates: nanoseconds per incidence of vertex and tetrahedron",
        "^all_stars/",
        TETS, ("ours", "ns/incidence"), FLAT, RATIO),
    "index": Table(
        "All stars, by an index of the corners of each vertex: nanoseconds per incidence",
        "^indexed_stars/",
        TETS, ("to visit", "ns/incidence"), FLAT, RATIO, ("to make", "make"),
        ("yardstick", "make_flat"), ("time / yardstick", "make_ratio")),
    "facet": Table(
        "Cutting one facet in a random place: nanoseconds", "^unglue_one_facet/",
        TETS, ("ours", "ns/facet"), ("with verification", "verified"), FLAT, RATIO),
    "cutting": Table(
        "Cutting: nanoseconds per cut facet", "^unglue_patches/",
        TETS, ("facets", lambda given: count(given["facets"])), ("stars in cache before", caches),
        ("ours", "ns/facet"), ("with verification", "verified"), FLAT, RATIO,
        ("growth from 0.4M tets", "growth")),
    "stitching": Table(
        "Taking back: nanoseconds per facet", "^stitch_patches/",
        TETS, ("facets", lambda given: count(given["facets"])), ("stitch", "ns/facet"),
        ("with verification", "verified"), FLAT, RATIO, ("cut", "cut"), ("stitch / cut", "per_cut"),
        ("every second facet", "half")),
    "checking": Table(
        "`check` with all rules and levels", "^check_cells/",
        TETS, ("seconds", "s"), ("ns per tet", "ns/cell"), FLAT, RATIO,
        ("peak bytes per tet", "peak_B/cell")),
    "certifying": Table(
        "`certify` of a cut", "^certify_cut/",
        TETS, ("facets", lambda given: count(given["facets"])), ("seconds", "s"),
        ("ns per tet", "ns/cell"), FLAT, RATIO, ("peak bytes per tet", "peak_B/cell")),
    "dimensions": Table(
        "D = 1, 2, 4 beside D = 3: nanoseconds per corner", "^dimension/",
        ("", "benchmark"), ("D", lambda given: str(given["D"])), ("ns per corner", "ns/corner"),
        ("D = 3", "D3"), ("D / 3", "per_D3"), RATIO),
    "peers-assembly": PeerTable("Assembly beside other programs, M cells/s", "^peers_assembly/"),
    "peers-memory": PeerTable("Bytes per cell beside other programs", "^peers_memory/"),
    "peers-neighbours": PeerTable(
        "All neighbours beside other programs: nanoseconds per cell", "^peers_neighbours/"),
    "peers-stars": PeerTable(
        "All stars beside other programs: nanoseconds per incidence", "^peers_stars/"),
    "peers-cutting": PeerTable(
        "Cutting beside other programs: nanoseconds per facet", "^peers_cut/"),
}


# What 64-bit ids cost: the same benchmarks in both programs.
PRICED = {"assemble_cells/cubes:100/shuffled:0": "Mtet/s",
          "assemble_cells/cubes:40/shuffled:1": "Mtet/s",
          "all_neighbours/cubes:100/shuffled:0": "ns/tet",
          "all_stars/cubes:100/shuffled:0": "ns/incidence",
          "unglue_patches/cubes:100/facets:10000/cold:1": "ns/facet",
          "stitch_patches/cubes:100/facets:10000": "ns/facet",
          "check_cells/cubes:100/shuffled:0": "ns/cell",
          "certify_cut/cubes:100/facets:100000": "ns/cell"}


def price_lines(narrow, wide):
    """The price is that of time beside the yardstick, whose numbers have 32 bits in both."""
    yield "| benchmark | | 32 bits | 64 bits | time, 64 / 32 |"
    yield "|---|---|---|---|---|"
    for name, unit in PRICED.items():
        if name in narrow and name in wide:
            yield (f"| `{name}` | {unit} | {digits(narrow[name][unit])} | "
                   f"{digits(wide[name][unit])} | "
                   f"{wide[name]['ratio'] / narrow[name]['ratio']:.2f} |")
    name = next(iter(PRICED))
    for what in ("held_B/cell", "peak_B/cell"):
        if name in narrow and name in wide:
            yield (f"| `{name}` | {what} | {narrow[name][what]:.1f} | {wide[name][what]:.1f} | "
                   f"{wide[name][what] / narrow[name][what]:.2f} |")


def measure(name, programs, programs64):
    """The title, and the lines of the table and of the command."""
    if name == "ids":
        pattern = "|".join(f"^{priced}/" for priced in PRICED)
        lines = price_lines(*(figures.run(os.path.join(folder, "topology_bench"), pattern)
                              for folder in (programs, programs64)))
        title, command = "The price of 64-bit ids", "./dev bench --tables ids"
    else:
        table = TABLES[name]
        counters = figures.run(os.path.join(programs, table.program), table.pattern)
        lines, title, command = table.lines(counters), table.title, table.command(name)
    return title, "\n".join([*lines, "", "```sh", command, "```"])


def put_into(text, name, lines):
    """The text with these lines in the place that is marked for the table."""
    found = re.search(f"<!-- table {re.escape(name)} -->\n.*?<!-- end -->", text, re.DOTALL)
    if not found:
        raise SystemExit(f"tables: there is no place for table {name}")
    return (text[:found.start()] + f"<!-- table {name} -->\n{lines}\n<!-- end -->"
            + text[found.end():])


def main(arguments):
    names = [name for name in arguments[2:] if name != "--write"] or [*TABLES, "ids"]
    for name in names:
        if name not in TABLES and name != "ids":
            sys.exit(f"tables: there is no table {name}; there are {', '.join([*TABLES, 'ids'])}")
    for name in names:
        title, lines = measure(name, *arguments[:2])
        print(f"## {title}\n\n{lines}\n", flush=True)
        if "--write" in arguments:
            with open("docs/measurements.md", encoding="utf-8") as file:
                text = put_into(file.read(), name, lines)
            with open("docs/measurements.md", "w", encoding="utf-8") as file:
                file.write(text)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(sys.argv[1:])
