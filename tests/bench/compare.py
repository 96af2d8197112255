#!/usr/bin/env python3
"""Compares the figures of topology_bench with a baseline.

usage: compare.py PROGRAM BASELINE [--save MACHINE]

A figure is a counter that does not depend on how busy the machine is: `ratio` and `.._ratio`, our
time to that of the yardstick in the same run, and `..B/cell`, memory. Each is printed beside its
baseline. One that is more than 1.25 times the baseline is measured anew, at most twice, and the
least value counts; if that is still too much, the exit status is 1. With --save the baseline is
written instead: the median of three runs, of a MACHINE described in a few words.
"""
import datetime
import json
import re
import statistics
import sys

import figures

LIMIT = 1.25   # times the baseline
TRIES = 3      # the first one included
RUNS = 3       # for a baseline

# What is measured: all that fits the largest cache, and of what does not fit it the main figures.
SUBSET = ("^(match_cells|orient_cells|assemble_cells|all_neighbours|all_stars|indexed_stars|check_cells)"
          "/cubes:40/"
          "|^assemble_cells/cubes:100/shuffled:0"
          "|^(unglue_one_facet|unglue_patches|stitch_patches|certify_cut)/cubes:40"
          "|^(unglue_patches/cubes:100/facets:10000/cold:1|stitch_patches/cubes:100/facets:10000/)"
          "|^dimension/(assembly|stars|unglue)/")


def figures_of(counters):
    """{"benchmark counter": value} of those counters that can be compared."""
    return {f"{name} {counter}": value
            for name, values in counters.items() for counter, value in values.items()
            if counter == "ratio" or counter.endswith(("_ratio", "B/cell"))}


def too_much(measured, baseline):
    """The figures that are worse than the limit allows."""
    return [figure for figure, value in measured.items()
            if figure in baseline and value > LIMIT * baseline[figure]]


def compare(baseline, measure, say=print):
    """Measures, tells each figure, and returns those that are too much, in spite of all tries.

    `measure(names)` returns the figures of these benchmarks, or of all of the subset (None)."""
    measured = measure(None)
    for _ in range(TRIES - 1):
        suspects = too_much(measured, baseline)
        if not suspects:
            break
        say(f"measuring anew: {', '.join(suspects)}")
        again = measure(sorted({figure.split(" ")[0] for figure in suspects}))
        measured.update({figure: min(measured[figure], again.get(figure, measured[figure]))
                         for figure in suspects})

    failed = too_much(measured, baseline)
    width = max(map(len, [*measured, *baseline]), default=0)
    say(f"{'figure':<{width}}  baseline      now  now/baseline")
    for figure in sorted({*measured, *baseline}):
        was, now = baseline.get(figure), measured.get(figure)
        if now is None:
            say(f"{figure:<{width}}  {was:8.3f}        -  missing")
        elif was is None:
            say(f"{figure:<{width}}         -  {now:7.3f}  new")
        else:
            remark = "  TOO MUCH" if figure in failed else ""
            say(f"{figure:<{width}}  {was:8.3f}  {now:7.3f}  {now / was if was else 1:.2f}{remark}")
    missing = [figure for figure in baseline if figure not in measured]
    if missing:
        say(f"{len(missing)} figures of the baseline were not measured: a benchmark failed, or "
            "has another name now; then save a new baseline")
    return failed + missing


def save(path, measure, machine, say=print):
    """Writes the medians of some runs."""
    runs = [measure(None) for _ in range(RUNS)]
    medians = {figure: float(f"{statistics.median(run[figure] for run in runs):.4g}")
               for figure in sorted(runs[0]) if all(figure in run for run in runs)}
    with open(path, "w", encoding="utf-8") as out:
        json.dump({"date": datetime.date.today().isoformat(), "machine": machine,
                   "figures": medians}, out, indent=1)
        out.write("\n")
    say(f"{len(medians)} figures written to {path}")


def main(arguments):
    program, path = arguments[:2]

    def measure(names):
        pattern = SUBSET if names is None else \
            "|".join(f"^{re.escape(name)}(/|$)" for name in names)
        return figures_of(figures.run(program, pattern))

    if arguments[2:3] == ["--save"]:
        save(path, measure, " ".join(arguments[3:]))
        return 0
    with open(path, encoding="utf-8") as text:
        baseline = json.load(text)
    print(f"baseline of {baseline['date']}, {baseline['machine']}")
    failed = compare(baseline["figures"], measure)
    for figure in failed:
        print(f"compare: {figure} is missing, or more than {LIMIT} times the baseline",
              file=sys.stderr)
    return 1 if failed else 0


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1:]))
