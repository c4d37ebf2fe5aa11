#!/usr/bin/env python3
# SPDX-License-Identifier: BSL-1.0
"""Compares the times of the solvers with those of the note in plain C++ (plain_note.hpp) from the same run.

against_note.py RESULTS

RESULTS is what `solvers --benchmark_out=RESULTS --benchmark_out_format=json` writes. The exit status is 1 if a
ratio exceeds its limit, and 2 if a time is missing.
"""
import json
import re
import statistics
import sys

# On one host, `frictionless` takes 1.6 times as long as the plain code, and `reflection` 2.1 times. On another host,
# each ratio differs by less than a factor of two. A batch is useless if it is not faster than the plain code.
LIMIT_OF_SOLVERS = 4
LIMIT_OF_BATCHES = 1
CONTACTS = 64  # 36 KB with their outcomes


def nanoseconds(runs, pattern):
    """The median time of the repetitions of a benchmark. If several benchmarks match, the least of their medians."""
    times = {}
    for run in runs:
        if run.get("run_type") == "iteration" and re.fullmatch(pattern, run["run_name"]):
            times.setdefault(run["run_name"], []).append(run["cpu_time"])
    if not times:
        print(f"against_note: no benchmark is named {pattern}", file=sys.stderr)
        sys.exit(2)
    return min(map(statistics.median, times.values()))


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        runs = json.load(file)["benchmarks"]
    status = 0
    for law in ("frictionless", "reflection"):
        plain = nanoseconds(runs, f"plain/{law}")
        for name, pattern, limit in ((f"{law}-double", f"{law}-double", LIMIT_OF_SOLVERS),
                                     (f"quickest batch of {law}", f"batch/{law}/double/{CONTACTS}/.*", LIMIT_OF_BATCHES)):
            ratio = nanoseconds(runs, pattern) / plain
            says = "" if ratio <= limit else "   BEYOND THE LIMIT"
            print(f"{name:32} {ratio:6.2f} times the note in plain C++, limit {limit}{says}")
            status = status if ratio <= limit else 1
    return status


if __name__ == "__main__":
    sys.exit(main())
