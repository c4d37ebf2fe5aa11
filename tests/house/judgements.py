# SPDX-License-Identifier: BSL-1.0
"""Counts the judgements in a gate's reports: judgements.py REPORT_DIRECTORY…

A judgement is the decision of one invariant about one answer, or about the related answers that it compares. The exit
status is 1 if a subject that is expected to pass was rejected or not judged.
"""
import json
import pathlib
import sys


def counts(subject):
    total = {"holds": 0, "violated": 0}
    for family in subject["families"]:
        for of_invariant in family["invariants"].values():
            for verdict in total:
                total[verdict] += of_invariant[verdict]
    return total


def main(directories):
    sound = {"holds": 0, "violated": 0}
    subjects = set()
    bad = []
    for directory in directories:
        report = json.loads((pathlib.Path(directory) / "report.json").read_text())
        for subject in report["subjects"]:
            if not subject["expected_to_pass"]:
                continue
            subjects.add(subject["name"])
            for verdict, count in counts(subject).items():
                sound[verdict] += count
            if subject["status"] != "sound":
                bad.append(f"{subject['name']}, seed {report['seed']}: {subject['status']}")
    print(f"{sum(sound.values()):,} judgements of {len(subjects)} subjects that are expected to pass, {sound['violated']:,} violated")
    for line in bad:
        print(line)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
