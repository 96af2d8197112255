#!/usr/bin/env python3
"""Line coverage of a build with --coverage, per source file of the project.

usage: coverage_table.py BUILD_DIR

Asks gcov (of the compiler that made the build) for JSON, adds up the counts of each line over all
object files, and prints one row per file, the least covered first, and one per module.
"""
import collections
import json
import pathlib
import subprocess
import sys

MODULES = ("topology", "cutting", "fem", "app")


def line_counts(build, root):
    """{file: {line: count}} of the project's own sources."""
    counts = collections.defaultdict(lambda: collections.defaultdict(int))
    for data in sorted(build.rglob("*.gcda")):
        out = subprocess.run(["gcov", "--json-format", "--stdout", str(data)], cwd=build,
                             capture_output=True, text=True, check=True).stdout
        for text in out.splitlines():
            for source in json.loads(text)["files"]:
                path = (build / source["file"]).resolve()
                if root not in path.parents or build in path.parents:
                    continue
                name = path.relative_to(root)
                if name.parts[0] in MODULES:
                    for line in source["lines"]:
                        counts[name][line["line_number"]] += line["count"]
    return counts


def row(name, lines):
    covered = sum(1 for count in lines if count)
    return f"{100.0 * covered / len(lines):6.1f} %  {covered:6d} of {len(lines):6d}  {name}"


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    build = pathlib.Path(sys.argv[1]).resolve()
    root = pathlib.Path(__file__).resolve().parents[2]
    counts = line_counts(build, root)
    if not counts:
        sys.exit(f"{build} has no coverage data: build the preset `coverage` and run its tests")
    by_share = sorted(counts, key=lambda f: sum(map(bool, counts[f].values())) / len(counts[f]))
    for name in by_share:
        print(row(name, counts[name].values()))
    print()
    for module in MODULES:
        lines = [count for name in counts if name.parts[0] == module
                 for count in counts[name].values()]
        if lines:
            print(row(module, lines))


if __name__ == "__main__":
    main()
