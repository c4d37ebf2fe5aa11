#!/usr/bin/env python3
# SPDX-License-Identifier: BSL-1.0
"""Runs the same benchmark program from two checkouts alternately and compares each benchmark.

compare.py BEFORE AFTER [--rounds N] [--slower PERCENT] [-- BENCHMARK FLAGS]

BEFORE and AFTER are programs of Google Benchmark. A disturbance of the machine affects both runs of a round. The
output is the ratio AFTER / BEFORE of the times within a round: its median, lowest and highest value. The exit status
is 1 if a benchmark is slower by more than PERCENT in every round, and 2 if a program cannot run.
"""
import argparse
import json
import statistics
import subprocess
import sys
import tempfile


def times_of(program, flags):
    """Nanoseconds per benchmark of one run: the median of the repetitions."""
    with tempfile.NamedTemporaryFile(suffix=".json") as out:
        command = [program, f"--benchmark_out={out.name}", "--benchmark_out_format=json", *flags]
        done = subprocess.run(command, stdout=subprocess.DEVNULL)
        if done.returncode != 0:
            print(f"compare: {program} ended with status {done.returncode}", file=sys.stderr)
            sys.exit(2)
        record = json.load(out)
    units = {"ns": 1, "us": 1e3, "ms": 1e6, "s": 1e9}
    repetitions = {}
    for run in record["benchmarks"]:
        if run.get("run_type") == "iteration":
            repetitions.setdefault(run["run_name"], []).append(run["real_time"] * units[run["time_unit"]])
    return {name: statistics.median(times) for name, times in repetitions.items()}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("before")
    parser.add_argument("after")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--slower", type=float, default=10)
    arguments, flags = parser.parse_known_args()
    rounds = []
    for number in range(arguments.rounds):
        pair = (arguments.before, arguments.after) if number % 2 == 0 else (arguments.after, arguments.before)
        times = {program: times_of(program, [flag for flag in flags if flag != "--"]) for program in pair}
        rounds.append((times[arguments.before], times[arguments.after]))
    slower = []
    print(f"{'benchmark':60} {'before ns':>12} {'after ns':>12} {'ratio':>7} {'lowest':>7} {'highest':>7}")
    for name in rounds[0][0]:
        pairs = [(before[name], after[name]) for before, after in rounds if name in before and name in after]
        if not pairs:
            continue
        ratios = [after / before for before, after in pairs]
        print(f"{name:60} {statistics.median(b for b, _ in pairs):12.4g} {statistics.median(a for _, a in pairs):12.4g}"
              f" {statistics.median(ratios):7.3f} {min(ratios):7.3f} {max(ratios):7.3f}")
        if min(ratios) > 1 + arguments.slower / 100:
            slower.append(name)
    for name in slower:
        print(f"slower by more than {arguments.slower:g} % in each of {arguments.rounds} rounds: {name}")
    return 1 if slower else 0


if __name__ == "__main__":
    sys.exit(main())
