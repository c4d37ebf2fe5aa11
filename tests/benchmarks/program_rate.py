#!/usr/bin/env python3
# SPDX-License-Identifier: BSL-1.0
"""Cases a second of the gate with every relation, on one job: for a built-in solver, and for the same solver as a
program that exchanges JSON or hexadecimal numbers. Prints medians, and the median ratio of the rounds.

    program_rate.py BUILD [SUBJECT [CASES [ROUNDS]]]
"""
import json
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path


def measured(build, subject, cases):
    """Cases a second by the clock, and by the processor time of the gate and the program."""
    with tempfile.TemporaryDirectory() as out:
        before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
        subprocess.run([f"{build}/carom", "gate", subject, "--cases", cases, "--relations-every", "1", "--jobs", "1",
                        "--out", out], stdout=subprocess.DEVNULL)
        elapsed, after = time.monotonic() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
        judged = json.loads(Path(out, "report.json").read_text())["subjects"][0]["cases"]
    return judged / elapsed, judged / (after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)


def main():
    build, name, cases, rounds = sys.argv[1:] + ["reflection-double", "100", "5"][len(sys.argv) - 2 :]
    program = f"exec:{Path(build).resolve()}/tests/subjects/protocol/well_behaved {name}"
    subjects = {"built-in": name, "JSON": program, "hexadecimal": program + " hex"}
    rates = [{form: measured(build, subject, cases) for form, subject in subjects.items()} for _ in range(int(rounds))]
    print(f"{name:<14}{'cases/s':>9}{'ratio':>8}{'cases/s of processor time':>28}{'ratio':>8}")
    for form in subjects:
        texts = []
        for k in range(2):
            rate = statistics.median(one[form][k] for one in rates)
            ratio = statistics.median(one[form][k] / one["built-in"][k] for one in rates)
            texts.append((f"{rate:.0f}", f"{ratio:.2f}"))
        print(f"{form:<14}{texts[0][0]:>9}{texts[0][1]:>8}{texts[1][0]:>28}{texts[1][1]:>8}")


main()
