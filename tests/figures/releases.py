#!/usr/bin/env python3
# SPDX-License-Identifier: BSL-1.0
"""Runs four phenomena in released versions of engines from npm: releases.py DIRECTORY [ENGINE…]

DIRECTORY keeps a copy of the adapters for each release, with the packages that npm installs. The script writes
docs/findings/data/releases.csv; with ENGINE, it replaces the rows of that engine. It prints the table of
docs/findings/releases.md. The step is 1/60 s, and 24 phases of the impact within a step give the least, the median and
the greatest value. With "pass-through", the median is the share of phases."""

import csv
import json
import math
import pathlib
import shutil
import statistics
import subprocess
import sys

TOP = pathlib.Path(__file__).resolve().parents[2]
ADAPTERS = TOP / "src/subjects/engines/npm"
TABLE = TOP / "docs/findings/data/releases.csv"
RELEASES = {
    "rapier": ("@dimforge/rapier3d-compat", "0.12.0 0.13.0 0.13.1 0.14.0 0.15.0 0.15.1 0.16.0 0.16.2 0.17.1 "
               "0.17.2 0.17.3 0.18.0 0.18.1 0.18.2 0.19.0 0.19.1 0.19.2 0.19.3 0.20.0 0.21.0"),
    "jolt": ("jolt-physics", "0.28.0 0.29.0 0.30.0 0.31.0 0.33.0 0.34.0 0.35.0 0.36.0 0.37.0 0.38.0 0.38.1 0.39.0 "
             "1.0.0 1.1.0"),
    "cannon": ("cannon-es", "0.15.0 0.15.1 0.16.0 0.17.0 0.17.1 0.18.0 0.19.0 0.20.0"),
    "physx": ("physx-js-webidl", "2.3.1 2.7.2 2.7.3"),
    "oimo": ("oimophysics", "1.2.1 1.2.2"),
    "mujoco": ("@mujoco/mujoco", "3.9.0 3.10.0 3.12.0 3.13.0 3.14.0"),
    "planck": ("planck", "1.0.5 1.0.6 1.1.2 1.3.0 1.4.2 1.4.3 1.5.0"),
}
SETTINGS = ("configured", "as-shipped")
STEP, PHASES = 1 / 60, 24
G, RADIUS, FALL = 9.81, 0.1, 1.0  # [m/s²], [m], [m]
INERTIA = 0.4 * RADIUS**2  # [kg m²] of a solid sphere of 1 kg
FLOOR = {"fixed": True, "half_space": [0, 1, 0], "position": [0, 0, 0]}
WALL = {"fixed": True, "box": [0.02, 8, 8], "position": [0, 0, 0]}


def ball(position, velocity=(0, 0, 0), spin=0):
    return {"sphere": RADIUS, "mass": 1, "principal_inertia": [INERTIA] * 3, "position": list(position),
            "orientation": [1, 0, 0, 0], "velocity": list(velocity), "angular_velocity": [0, 0, spin]}


def run(bodies, steps, report, restitution, friction=0, gravity=G, continuous=False):
    return {"cmd": "run", "step": STEP, "steps": steps, "report": report,
            "scene": {"gravity": [0, -gravity, 0], "restitution": restitution, "friction": friction,
                      "continuous": continuous, "bodies": bodies}}


def apex(states, impacts):
    """The greatest height after so many impacts, over FALL; 0 if there are fewer."""
    above = [state[1]["position"][1] - RADIUS for state in states]
    rises = [i for i in range(2, len(above)) if above[i - 1] <= above[i - 2] and above[i] > above[i - 1]]
    ends = [*rises[1:], len(above)]
    return max(above[rises[impacts - 1]:ends[impacts - 1]]) / FALL if len(rises) >= impacts else 0


# A phenomenon yields requests, and what is read from their states: name, known answer, function.

def bounce():
    """The sphere falls from FALL. Its heights after impacts; the truth is ε²ⁿ."""
    for restitution, numbers in ((0.5, [1]), (1, [1, 4])):
        seconds = math.sqrt(2 * FALL / G) * (1 + 2 * sum(restitution**n for n in range(1, numbers[-1] + 1)))
        steps = math.ceil(seconds / STEP)
        # The states on the parabola, parts of a step after the fall began
        times = [STEP * k / PHASES for k in range(PHASES)]
        balls = [ball([0, RADIUS + FALL - G * t**2 / 2, 0], [0, -G * t, 0]) for t in times]
        yield ([run([FLOOR, each], steps, list(range(steps + 1)), restitution) for each in balls],
               [(f"height {n} at restitution {restitution}", restitution**(2 * n), lambda states, n=n: apex(states, n))
                for n in numbers])


def spin():
    """The sphere meets a wall obliquely, without gravity, at ε = ½. Its velocity along the wall and its spin."""
    along, towards, restitution = 2.0, 3.0, 0.5  # [m/s]
    for friction in (0.1, 1):
        change = min(friction * (1 + restitution) * towards, 2 / 7 * along)
        steps = math.ceil((0.3 / towards + STEP) / STEP) + 6
        gaps = [0.3 + towards * STEP * k / PHASES for k in range(PHASES)]
        yield ([run([FLOOR, ball([0, RADIUS + gap, 0], [along, -towards, 0])], steps, [steps], restitution, friction,
                    gravity=0) for gap in gaps],
               [(f"velocity at friction {friction}", along - change, lambda states: states[-1][1]["velocity"][0]),
                (f"spin at friction {friction}", -change * RADIUS / INERTIA,
                 lambda states: states[-1][1]["angular_velocity"][2])])


def slide_to_roll():
    """The sphere starts on the floor without spin. The end of its slip, and its velocity after one second."""
    start, friction, steps = 2.0, 0.2, 60  # [m/s]

    def slip_ends(states):
        slips = [abs(state[1]["velocity"][0] + RADIUS * state[1]["angular_velocity"][2]) for state in states]
        return next((i * STEP for i, slip in enumerate(slips) if slip < 0.01 * start), math.inf)

    yield ([run([FLOOR, ball([0, RADIUS, 0], [start, 0, 0])], steps, list(range(steps + 1)), 0, friction)],
           [("time of slipping", 2 * start / (7 * friction * G), slip_ends),
            ("velocity after 1 s", 5 / 7 * start, lambda states: states[-1][1]["velocity"][0])])


def pass_through():
    """The sphere flies at a wall of 2 cm, at a sphere, or at one that comes. Whether it passes."""
    for continuous in (False, True):
        for target, reach, share in (("wall", 0.01, 0), ("sphere", RADIUS, 0), ("coming sphere", RADIUS, 0.25)):
            for diameters in (1, 4, 16):
                speed = diameters * 2 * RADIUS / STEP  # of the approach
                body = WALL if target == "wall" else ball([0, 0, 0], [-share * speed, 0, 0])
                starts = [-(reach + RADIUS + speed * STEP * (2 + (k + 0.37) / PHASES)) for k in range(PHASES)]
                yield ([run([body, ball([x, 0, 0], [(1 - share) * speed, 0, 0])], 6, [6], 1, gravity=0,
                            continuous=continuous) for x in starts],
                       [(f"{target}, {diameters} diameters a step, continuous {'on' if continuous else 'off'}", 0,
                         lambda states: float(states[-1][1]["position"][0] > states[-1][0]["position"][0]))])


PHENOMENA = {"bounce": bounce, "spin": spin, "slide-to-roll": slide_to_roll, "pass-through": pass_through}


def installed(directory, engine, package, release):
    """A copy of the adapters with this release of the engine."""
    copy = directory / f"{engine}-{release}"
    shutil.copytree(ADAPTERS, copy, ignore=shutil.ignore_patterns("node_modules", "package*"), dirs_exist_ok=True)
    if not (copy / "node_modules" / package).exists():
        (copy / "package.json").write_text('{"private": true, "type": "module"}\n', encoding="utf-8")
        options = ["--silent", "--ignore-scripts", "--no-audit", "--no-fund", "--legacy-peer-deps"]
        subprocess.run(["npm", "install", *options, f"{package}@{release}"], cwd=copy, check=True)
    return copy


# An engine of WebAssembly would spend most of the time on optimising code that runs for a second.
NODE = ["node", "--wasm-lazy-compilation", "--no-wasm-tier-up"]


def replies(copy, engine, setting, requests):
    """The replies of an adapter to the requests; or why there are none."""
    lines = [{"cmd": "start", "protocol": 1}, *({**each, "id": i} for i, each in enumerate(requests)), {"cmd": "stop"}]
    try:
        done = subprocess.run([*NODE, f"time/{engine}.mjs", setting], cwd=copy, capture_output=True, text=True,
                              input="".join(json.dumps(line) + "\n" for line in lines), timeout=1200)
    except subprocess.TimeoutExpired:
        return "takes more than 1200 s"
    if done.returncode != 0:
        errors = [line for line in done.stderr.splitlines() if "Error" in line]
        return (errors or ["ends with status " + str(done.returncode)])[0].strip()
    return [json.loads(line) for line in done.stdout.splitlines()[1:]]


def rows_of(copy, engine, release, setting):
    groups = [(phenomenon, *group) for phenomenon, groups_of in PHENOMENA.items() for group in groups_of()]
    answers = replies(copy, engine, setting, [each for _, requests, _ in groups for each in requests])
    for phenomenon, requests, quantities in groups:
        why = answers if isinstance(answers, str) else ""
        if not why:
            part, answers = answers[:len(requests)], answers[len(requests):]
            why = next((each.get("skipped") or each.get("error") for each in part if "states" not in each), "")
        for quantity, truth, value in quantities:
            row = {"engine": engine, "release": release, "setting": setting, "phenomenon": phenomenon,
                   "quantity": quantity, "truth": f"{truth:.6g}", "note": why}
            if not why:
                values = sorted(value(each["states"]) for each in part)
                middle = statistics.mean(values) if phenomenon == "pass-through" else statistics.median(values)
                row.update(least=f"{values[0]:.6g}", median=f"{middle:.6g}", greatest=f"{values[-1]:.6g}")
            yield row


FIELDS = "engine release setting phenomenon quantity least median greatest truth note".split()


def read_table():
    if not TABLE.exists():
        return []
    with TABLE.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def write_table(rows):
    order = list(RELEASES)
    with TABLE.open("w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, FIELDS, lineterminator="\n", restval="")
        writer.writeheader()
        writer.writerows(sorted(rows, key=lambda row: order.index(row["engine"])))


COLUMNS = {"height 1 at restitution 0.5": "first height, ε = ½", "height 4 at restitution 1": "fourth height, ε = 1",
           "spin at friction 0.1": "spin at μ = 0.1 [rad/s]", "velocity after 1 s": "rolls at [m/s]",
           "wall, 4 diameters a step, continuous off": "passes a wall",
           "wall, 4 diameters a step, continuous on": "… continuous",
           "sphere, 4 diameters a step, continuous on": "passes a sphere, continuous",
           "coming sphere, 4 diameters a step, continuous on": "… that comes"}


def print_table(rows):
    """A line for each run of releases that agree to three digits."""
    rows = [row for row in rows if row["setting"] == "configured"]
    truths = {row["quantity"]: row["truth"] for row in rows}
    print("| engine | releases |", " | ".join(COLUMNS.values()), "|")
    print("| --- " * (2 + len(COLUMNS)) + "|")
    print("| *known answer* | |", " | ".join(f"{float(truths[name]):.4g}" for name in COLUMNS), "|")
    last = None
    for engine in RELEASES:
        for release in dict.fromkeys(row["release"] for row in rows if row["engine"] == engine):
            of = {row["quantity"]: row for row in rows if row["engine"] == engine and row["release"] == release}
            cells = [f"{float(of[name]['median']):.3g}" if of[name]["median"] else "–" for name in COLUMNS]
            if set(cells) == {"–"}:
                continue  # npm or Node cannot load it
            if last and last[0] == engine and last[2] == cells:
                last[1].append(release)
            else:
                if last:
                    print_line(*last)
                last = [engine, [release], cells]
    print_line(*last)


def print_line(engine, releases, cells):
    print(f"| {engine} | {', '.join(releases)} |", " | ".join(cells), "|")


def main():
    directory, *engines = sys.argv[1:]
    for engine in engines or RELEASES:
        package, releases = RELEASES[engine]
        measured = []
        for release in releases.split():
            copy = installed(pathlib.Path(directory), engine, package, release)
            for setting in SETTINGS:
                rows = list(rows_of(copy, engine, release, setting))
                measured += rows
                print(engine, release, setting, *{row["note"] for row in rows}, flush=True)
        write_table([row for row in read_table() if row["engine"] != engine] + measured)
    print_table(read_table())


main()
