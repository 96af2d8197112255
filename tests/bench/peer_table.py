#!/usr/bin/env python3
"""Prints the reports of peers_bench as the tables of docs/measurements.md.

usage: peer_table.py REPORT.json..      (peers_bench --benchmark_out=REPORT.json)

A row is a mesh, a column a program; in brackets stands how many times as long as the library it
took.
"""
import json
import sys

TITLES = {
    "peers_assembly": "Assembly, million cells per second",
    "peers_memory": "Memory, bytes per cell: held, and at the worst moment",
    "peers_neighbours": "All neighbours, nanoseconds per cell",
    "peers_stars": "All stars, nanoseconds per visit of a cell",
    "peers_cut": "A cut, nanoseconds per facet",
}
# What peers_bench reports besides a figure for each program.
NOT_PROGRAMS = ("cells", "facets", "copies", "ratio")
# What Google Benchmark says of each benchmark.
ITS_OWN = {"family_index", "per_family_instance_index", "repetitions", "repetition_index", "threads",
           "iterations", "real_time", "cpu_time"}
FIRST = ("ours", "bare", "located", "indexed", "index_made", "flat")


def digits(value):
    """Three digits that mean something."""
    if value >= 1000:
        return f"{float(f'{value:.3g}'):,.0f}".replace(",", " ")
    return f"{value:.0f}" if value >= 100 else f"{value:.1f}" if value >= 10 else f"{value:.2f}"


def programs(rows):
    names = {name for counters in rows.values() for name in counters
             if name not in NOT_PROGRAMS and not name.endswith(("_x", "_refuses", "_peak"))}
    return [name for name in FIRST if name in names] + sorted(names - set(FIRST))


def cell(counters, name):
    if name + "_refuses" in counters:
        return "refuses"
    if name not in counters:
        return "-"
    if name.endswith("_held"):
        return digits(counters[name]) + ", " + digits(counters[name[:-5] + "_peak"])
    times = 1 / counters["ratio"] if name == "flat" else counters.get(name + "_x")
    return digits(counters[name]) + (f" ({digits(times)})" if times else "")


def heading(name):
    return {"flat": "yardstick", "ours": "Cleave"}.get(name.removesuffix("_held"),
                                                       name.removesuffix("_held").replace("_", " "))


def lines(rows):
    """The table of {mesh: {counter: value}}."""
    columns = programs(rows)
    yield "| mesh | " + " | ".join(heading(name) for name in columns) + " |"
    yield "|---" * (1 + len(columns)) + "|"
    for mesh, counters in rows.items():
        yield f"| {mesh} | " + " | ".join(cell(counters, name) for name in columns) + " |"


def main(paths):
    tables = {}
    for path in paths:
        with open(path, encoding="utf-8") as file:
            for benchmark in json.load(file)["benchmarks"]:
                if benchmark.get("error_occurred"):
                    continue
                kind, dimension, mesh = benchmark["name"].split("/")[:3]
                counters = {key: value for key, value in benchmark.items()
                            if isinstance(value, (int, float)) and key not in ITS_OWN}
                tables.setdefault((kind, dimension), {})[mesh] = counters
    for (kind, dimension), rows in tables.items():
        print(f"### {TITLES[kind]}, {dimension[0]} = {dimension[1:]}\n")
        print("\n".join(lines(rows)) + "\n")


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(sys.argv[1:])
