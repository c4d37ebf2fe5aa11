#!/usr/bin/env python3
# SPDX-License-Identifier: BSL-1.0
"""The exact truth of `carom replay` equals, in every component, the answer of the proved laws over the rational
numbers.

usage: bridge_test.py CAROM PROVED COLLISIONS [FILE…]

PROVED is the program of properties/proofs/bridge. COLLISIONS collisions are drawn from all families in turn. Each
FILE adds collisions: JSON Lines, or a witness.
"""

import concurrent.futures
import itertools
import json
import math
import re
import subprocess
import sys
import tempfile
from fractions import Fraction

# The collision of the lemma opposite_cone in friction.v. The formula of κ, the share of friction in `rough`, divides by
# 0 here, although κ exists.
ON_OPPOSITE_CONE = {
    "a": {"mass": 1, "principal_inertia": [0.25, 0.25, 0.25], "position": [0, 0, 0], "velocity": [-4, -2, 0],
          "angular_velocity": [0, 0, 0]},
    "b": {"immovable": True, "position": [0, 0, 0], "velocity": [0, 0, 0], "angular_velocity": [0, 0, 0]},
    "point": [0.5, -0.5, 0], "normal": [0, 1, 0], "restitution": 0, "friction": 2, "tangential_restitution": 0}
LAWS = ("frictionless", "reflection", "sticking", "rough")
RADICAL = re.compile(r"(\S+) \+ (\S+) √\((\S+)\)")


def drawn(carom):
    """The first case of each seed and family of valid collisions."""
    for seed in itertools.count(1):
        said = subprocess.run([carom, "families", "--format", "json", "--seed", str(seed)], capture_output=True, check=True)
        for family in json.loads(said.stdout):
            if family["name"] != "invalid":
                yield family["example"]


def collisions_of(name):
    with open(name) as file:
        text = file.read()
    try:
        records = [json.loads(text)]
    except json.JSONDecodeError:
        records = [json.loads(line) for line in text.splitlines() if line.strip()]
    return [record.get("collision", record) for record in records]


def root(number):
    """The rational square root, or None."""
    over, under = math.isqrt(number.numerator), math.isqrt(number.denominator)
    return Fraction(over, under) if over * over == number.numerator and under * under == number.denominator else None


def parts(text):
    """p and the signed square of q √s, for the text "p + q √(s)". Numbers are equal if and only if these parts are."""
    if match := RADICAL.fullmatch(text):
        rational, coefficient, under_root = (Fraction(part) for part in match.groups())
        whole = root(under_root)
        if whole is not None:
            return rational + coefficient * whole, Fraction(0)
        return rational, coefficient * abs(coefficient) * under_root
    return Fraction(text), Fraction(0)


def lines_of(command, collisions):
    with tempfile.NamedTemporaryFile("w", suffix=".jsonl") as file:
        file.writelines(json.dumps(collision) + "\n" for collision in collisions)
        file.flush()
        with open(file.name) as again:
            said = subprocess.run(command(file.name), stdin=again, capture_output=True, text=True)
    if said.returncode != 0:
        raise RuntimeError(said.stderr)
    return [json.loads(line) for line in said.stdout.splitlines()]


def differences(carom, proved, collisions):
    """The number of compared components, how many are irrational, and the differences."""
    truths = lines_of(lambda name: [carom, "replay", name, "--format", "json"], collisions)
    answers = lines_of(lambda name: [proved], collisions)
    if not len(truths) == len(answers) == len(collisions):
        raise RuntimeError(f"{len(collisions)} collisions, {len(truths)} truths, {len(answers)} answers")
    compared, irrational, different = 0, 0, []
    for collision, truth, answer in zip(collisions, truths, answers):
        for law, body, vector, i in itertools.product(LAWS, "ab", ("velocity", "angular_velocity"), range(3)):
            of_truth, of_answer = (text[law][body][vector][i] for text in (truth["truth"], answer))
            compared += 1
            irrational += parts(of_truth)[1] != 0
            if of_truth != of_answer and parts(of_truth) != parts(of_answer):
                different.append(f"{law}, {body}.{vector}[{i}]: {of_truth} and {of_answer} of {json.dumps(collision)}")
    return compared, irrational, different


def main(carom, proved, count, *files):
    collisions = [ON_OPPOSITE_CONE] + [collision for name in files for collision in collisions_of(name)]
    collisions += itertools.islice(drawn(carom), int(count))
    block = 100
    blocks = [collisions[i : i + block] for i in range(0, len(collisions), block)]
    compared, irrational, different = 0, 0, []
    with concurrent.futures.ThreadPoolExecutor(max_workers=2) as pool:
        for more, of_these, found in pool.map(lambda some: differences(carom, proved, some), blocks):
            compared += more
            irrational += of_these
            different += found
    for line in different[:10]:
        print(line)
    print(f"{len(collisions)} collisions, {compared} components, {irrational} of them irrational: {len(different)} differ")
    return 1 if different or irrational == 0 else 0


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
