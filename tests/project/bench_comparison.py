#!/usr/bin/env python3
"""The comparison of benchmarks tells a planted regression, and nothing else."""
import json
import os
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.join(sys.argv.pop(1) if len(sys.argv) > 1 else ".", "tests", "bench"))
del sys.argv[1:]
import compare  # noqa: E402
import figures  # noqa: E402
import tables  # noqa: E402

BASELINE = {"cut/cubes:40 ratio": 1.0, "cut/cubes:40 verified_ratio": 2.0, "held B/cell": 32.8}


class Measured:
    """Answers each call with the next of some results, restricted to what is asked for."""

    def __init__(self, *results):
        self.results, self.asked = list(results), []

    def __call__(self, names):
        self.asked.append(names)
        return {figure: value for figure, value in self.results.pop(0).items()
                if names is None or figure.split(" ")[0] in names}


def compared(*results):
    lines = []
    measured = Measured(*results)
    failed = compare.compare(BASELINE, measured, lines.append)
    return failed, lines, measured.asked


class Comparison(unittest.TestCase):
    def test_noise_passes(self):
        failed, _, asked = compared({key: 1.2 * value for key, value in BASELINE.items()})
        self.assertEqual((failed, asked), ([], [None]))

    def test_a_regression_is_named(self):
        slow = {**BASELINE, "cut/cubes:40 verified_ratio": 2.6}
        failed, lines, asked = compared(slow, slow, slow)
        self.assertEqual(failed, ["cut/cubes:40 verified_ratio"])
        self.assertEqual(asked, [None, ["cut/cubes:40"], ["cut/cubes:40"]])
        self.assertEqual([line.split()[1] for line in lines if "TOO MUCH" in line],
                         ["verified_ratio"])

    def test_a_hiccup_is_measured_anew(self):
        failed, _, asked = compared({**BASELINE, "cut/cubes:40 ratio": 3.0}, BASELINE)
        self.assertEqual((failed, asked), ([], [None, ["cut/cubes:40"]]))

    def test_a_missing_figure_fails(self):
        failed, lines, _ = compared({"cut/cubes:40 ratio": 1.0, "held B/cell": 32.8})
        self.assertEqual(failed, ["cut/cubes:40 verified_ratio"])
        self.assertTrue(any("missing" in line for line in lines))

    def test_a_new_figure_is_told(self):
        failed, lines, _ = compared({**BASELINE, "stitch ratio": 9.0})
        self.assertEqual(failed, [])
        self.assertTrue(any("stitch ratio" in line and "new" in line for line in lines))

    def test_what_depends_on_the_machine_is_no_figure(self):
        report = {"benchmarks": [{"name": "cut/cubes:40/iterations:5/manual_time", "cpu_time": 1.0,
                                  "ns/facet": 300.0, "flat": 200.0, "ratio": 1.5,
                                  "held_B/cell": 33.0},
                                 {"name": "broken", "error_occurred": True, "ratio": 1.0}]}
        self.assertEqual(compare.figures_of(figures.counters_of(report)),
                         {"cut/cubes:40 ratio": 1.5, "cut/cubes:40 held_B/cell": 33.0})

    def test_a_baseline_is_the_median_of_runs(self):
        with tempfile.NamedTemporaryFile(mode="w", suffix=".json") as file:
            compare.save(file.name, Measured(*({"a ratio": value} for value in (1.0, 9.0, 2.0))),
                         "a machine", lambda line: None)
            with open(file.name, encoding="utf-8") as text:
                saved = json.load(text)
        self.assertEqual((saved["machine"], saved["figures"]), ("a machine", {"a ratio": 2.0}))

    def test_the_committed_baseline_can_be_read(self):
        path = os.path.join(os.path.dirname(compare.__file__), "baseline.json")
        with open(path, encoding="utf-8") as text:
            self.assertTrue(all(value > 0 for value in json.load(text)["figures"].values()))


class Tables(unittest.TestCase):
    def test_a_row(self):
        lines = list(tables.TABLES["assembly"].lines(
            {"assemble_cells/cubes:100/shuffled:1":
             {"Mtet/s": 12.34, "flat": 1234.0, "ratio": 0.987, "held_B/cell": 32.84}}))
        self.assertEqual(lines[2], "| 6M, shuffled | 12.3 | 1 230 | 0.99 | 32.8 | - |")

    def test_a_table_takes_its_place(self):
        text = "a\n<!-- table x -->\nold\n<!-- end -->\n<!-- table y -->\n<!-- end -->\n"
        self.assertEqual(tables.put_into(text, "x", "| new |"),
                         text.replace("old", "| new |"))

    def test_the_guide_has_a_place_for_each_table(self):
        folder = os.path.dirname(compare.__file__)
        with open(os.path.join(folder, "../../docs/measurements.md"), encoding="utf-8") as text:
            guide = text.read()
        for name in [*tables.TABLES, "ids"]:
            tables.put_into(guide, name, "")


if __name__ == "__main__":
    unittest.main()
