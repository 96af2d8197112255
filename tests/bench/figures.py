"""Runs a benchmark program and reads the figures it reports."""
import json
import subprocess
import tempfile


def run(program, pattern):
    """The benchmarks of `program` that match the pattern, as {name: {counter: value}}."""
    with tempfile.NamedTemporaryFile(suffix=".json") as out:
        done = subprocess.run(
            [program, f"--benchmark_filter={pattern}", f"--benchmark_out={out.name}",
             "--benchmark_out_format=json"],
            check=False, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        if done.returncode != 0:
            raise SystemExit(f"{program} ended with {done.returncode}: {done.stderr[-500:]}")
        text = open(out.name, encoding="utf-8").read()
    # Without a match nothing is written.
    return counters_of(json.loads(text)) if text else {}


# What Google Benchmark itself says of each benchmark.
_ITS_OWN = {"name", "family_index", "per_family_instance_index", "run_name", "run_type",
            "repetitions", "repetition_index", "threads", "iterations", "real_time", "cpu_time",
            "time_unit"}


def counters_of(report):
    """{name: {counter: value}} of a report in Google Benchmark's JSON."""
    return {short(b["name"]): {key: value for key, value in b.items() if key not in _ITS_OWN}
            for b in report["benchmarks"] if not b.get("error_occurred")}


def short(name):
    """The name without what Google Benchmark appends to it."""
    return "/".join(part for part in name.split("/")
                    if part not in ("manual_time", "real_time", "process_time")
                    and not part.startswith("iterations:"))


def parameters(name):
    """("unglue", {"cubes": 40}) of "unglue/cubes:40"."""
    parts = name.split("/")
    given = dict(part.split(":", 1) for part in parts if ":" in part)
    return ("/".join(part for part in parts if ":" not in part),
            {key: int(value) if value.isdigit() else value for key, value in given.items()})
