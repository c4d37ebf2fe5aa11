#!/usr/bin/env python3
# SPDX-License-Identifier: BSL-1.0
"""Prints the share of executed lines of each folder, from the output of `gcovr --csv`."""

import collections
import csv
import os
import sys


def main():
    folders = collections.defaultdict(lambda: [0, 0])  # executed lines, lines
    for row in csv.DictReader(sys.stdin):
        for folder in (os.path.dirname(row["filename"]), "together"):
            folders[folder][0] += int(row["line_covered"])
            folders[folder][1] += int(row["line_total"])
    if not folders:
        sys.exit("coverage_by_folder: nothing was measured")
    together = folders.pop("together")
    width = max(map(len, [*folders, "together"]))
    print(f"{'folder':<{width}}   lines     run")
    for folder, (run, lines) in [*sorted(folders.items()), ("together", together)]:
        share = f"{100 * run / lines:.1f} %" if lines else "-"
        print(f"{folder:<{width}}  {lines:>6}  {share:>7}")


main()
