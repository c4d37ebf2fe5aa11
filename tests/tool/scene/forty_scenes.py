#!/usr/bin/env python3
# SPDX-License-Identifier: BSL-1.0
"""Runs forty scenes that one would try first: forty_scenes.py CAROM [--page]

A run may hold (exit status 0), or say why it cannot (2), but nothing is violated (1). `--page` prints
docs/reference/scenes/forty-scenes.md."""

import json
import math
import pathlib
import subprocess
import sys
import tempfile
import time

FLOOR = {"normal": [0, 0, 1], "point": [0, 0, 0]}


def ball(x, y, z, radius=0.1, velocity=(0, 0, 0), spin=(0, 0, 0), density=1000):
    return {"radius": radius, "density": density, "position": [x, y, z], "velocity": list(velocity),
            "angular_velocity": list(spin)}


def box(x, y, z, size=(1, 1, 1), velocity=(0, 0, 0), spin=(0, 0, 0), orientation=(1, 0, 0, 0)):
    corners = [[sx * size[0] / 2, sy * size[1] / 2, sz * size[2] / 2]
               for sx in (-1, 1) for sy in (-1, 1) for sz in (-1, 1)]
    return {"vertices": corners, "density": 700, "position": [x, y, z], "velocity": list(velocity),
            "angular_velocity": list(spin), "orientation": list(orientation)}


def slope(degrees):
    angle = math.radians(degrees)
    return {"normal": [math.sin(angle), 0, math.cos(angle)], "point": [0, 0, 0]}


def scene(duration, bodies, planes=(FLOOR,), gravity=(0, 0, -9.81), restitution=0.5, friction=0.3, **other):
    """`other`: fields of the contact or of the scene."""
    contact = {"materials": ["default", "default"], "restitution": restitution, "friction": friction}
    for name in ("tangential_restitution", "rolling_resistance", "spinning_resistance"):
        if name in other:
            contact[name] = other.pop(name)
    return {"duration": duration, "gravity": list(gravity), "materials": ["default"], "contacts": [contact],
            "planes": list(planes), "spheres": [body for body in bodies if "radius" in body],
            "polyhedra": [body for body in bodies if "vertices" in body], **other}


def rack():
    """A cue ball and a rack of fifteen balls that touch."""
    radius = 0.028575
    rows = [ball(row * radius * math.sqrt(3), (2 * k - row) * radius, radius, radius)
            for row in range(5) for k in range(row + 1)]
    return [ball(-0.5, 0.001, radius, radius, (8, 0, 0))] + rows


def box_of_balls(speed):
    lattice = {"count": [10, 10, 2], "first": [0.15, 0.15, 0.3], "spacing": [0.19, 0.19, 0.3], "radius": 0.05,
               "density": 1000, "speed": speed, "seed": 1}
    return {"lattices": [lattice], "room": {"least": [0, 0, 0], "greatest": [2, 2, 1]}}


NO_GRAVITY = (0, 0, 0)
ABOVE_SLOPE = 0.1 / math.cos(math.radians(10))
SCENES = [
    ("drop", "a ball falls 1 m", scene(5, [ball(0, 0, 1.1)])),
    ("drop_elastic", "the same, ε = 1", scene(10, [ball(0, 0, 1.1)], restitution=1)),
    ("drop_plastic", "the same, ε = 0", scene(5, [ball(0, 0, 1.1)], restitution=0)),
    ("drop_sticky_law", "a spinning ball falls, law sticking",
     scene(5, [ball(0, 0, 1.1, spin=(0, 20, 5))], law="sticking")),
    ("head_on", "two equal balls, head-on", scene(2, [ball(-1, 0, 0, velocity=(1, 0, 0)), ball(1, 0, 0)], (), NO_GRAVITY)),
    ("glancing", "two balls meet off centre",
     scene(2, [ball(-1, 0.1, 0, velocity=(2, 0, 0)), ball(1, 0, 0)], (), NO_GRAVITY)),
    ("light_on_heavy", "a ball of 4 g strikes one of 4 t",
     scene(5, [ball(-1, 0, 0, 0.01, (3, 0, 0)), ball(1, 0.3, 0, 1)], (), NO_GRAVITY, 0.9)),
    ("cradle", "Newton's cradle, with decimals that touch",
     scene(5, [ball(-1, 0, 0, velocity=(1, 0, 0))] + [ball(x, 0, 0) for x in (0.1, 0.3, 0.5, 0.7)],
           ({"normal": [1, 0, 0], "point": [-2, 0, 0]}, {"normal": [-1, 0, 0], "point": [2, 0, 0]}), NO_GRAVITY, 1)),
    ("touching", "balls that touch the floor, a wall and each other, in decimals",
     scene(2, [ball(0.1, 0, 0.1), ball(0.3, 0, 0.1), ball(0.2, round(0.1 * math.sqrt(3), 15), 0.1)],
           (FLOOR, {"normal": [1, 0, 0], "point": [0, 0, 0]}))),
    ("tennis_ball", "a small ball on a large one, dropped together",
     scene(2, [ball(0, 0, 1.12, 0.12, density=80), ball(0, 0, 1.2735, 0.033, density=370)], restitution=0.8)),
    ("ball_on_ball", "a ball falls on a ball on the floor", scene(3, [ball(0, 0, 0.2, 0.2), ball(0, 0, 0.7, 0.2)])),
    ("rolls_off", "the same, 1 mm off centre", scene(3, [ball(0, 0, 0.2, 0.2), ball(0.001, 0, 0.7, 0.2)])),
    ("pyramid", "a ball falls between three on the floor",
     scene(3, [ball(0, 0, 0.1), ball(0.2, 0, 0.1), ball(0.1, 0.17320508075688773, 0.1), ball(0.1, 0.0577, 0.5)])),
    ("slope", "a ball rolls 20 s down a slope of 10°", scene(20, [ball(0, 0, 1)], (slope(10),), restitution=0.6)),
    ("slope_resistance", "the same, with rolling resistance",
     scene(20, [ball(0, 0, ABOVE_SLOPE)], (slope(10),), rolling_resistance=0.1)),
    ("slope_rest", "the same, with more resistance", scene(20, [ball(0, 0, 1)], (slope(10),), rolling_resistance=0.2)),
    ("slope_steep", "a ball slides down a slope of 60°", scene(10, [ball(0, 0, 1)], (slope(60),))),
    ("slope_across", "a ball is thrown across a slope, with spin",
     scene(10, [ball(0, 0, 0.5, velocity=(-2, 3, 0), spin=(5, 5, 30))], (slope(15),), rolling_resistance=0.02,
           spinning_resistance=0.02)),
    ("gravity_aslant", "gravity in no direction of an axis",
     scene(20, [ball(1, 1, 1, velocity=(1, 0, 0))], gravity=(3, -1, -9), rolling_resistance=0.05)),
    ("groove", "a ball falls into a groove", scene(5, [ball(0.1, 0, 1)], ({"normal": [1, 0, 1], "point": [0, 0, 0]},
                                                                         {"normal": [-1, 0, 1], "point": [0, 0, 0]}))),
    ("corner", "a ball is thrown into a corner",
     scene(10, [ball(1, 1, 1, velocity=(-2, -3, 0))],
           (FLOOR, {"normal": [1, 0, 0], "point": [0, 0, 0]}, {"normal": [0, 1, 0], "point": [0, 0, 0]}),
           rolling_resistance=0.01)),
    ("spin_on_floor", "a ball spins in place", scene(10, [ball(0, 0, 0.1, spin=(0, 0, 50))], spinning_resistance=0.02)),
    ("backspin", "a ball with backspin comes back",
     scene(20, [ball(0, 0, 0.1, velocity=(1, 0, 0), spin=(0, -60, 0))], rolling_resistance=0.01)),
    ("super_ball", "a ball with e_t = 1 under a table",
     scene(5, [ball(0, 0, 0.5, 0.03, (3, 0, -3))], (FLOOR, {"normal": [0, 0, -1], "point": [0, 0, 0.7]}),
           restitution=0.9, friction=1, tangential_restitution=1)),
    ("billiards", "a break; the balls of the rack touch",
     scene(10, rack(), restitution=0.93, friction=0.2, rolling_resistance=0.01, spinning_resistance=0.02)),
    ("balls_fall", "200 balls fall in a box", scene(20, [], (), **box_of_balls(1))),
    ("gas", "200 elastic balls without gravity", scene(5, [], (), NO_GRAVITY, 1, 0, **box_of_balls(2))),
    ("fast", "a ball flies off at 10⁵ m/s", scene(1e6, [ball(0, 0, 1, velocity=(1e5, 0, 0)), ball(0, 1, 1)], (), NO_GRAVITY)),
    ("fast_wall", "a ball strikes a wall at 10⁴ m/s",
     scene(1, [ball(-50, 0, 0, velocity=(1e4, 0, 0))], ({"normal": [-1, 0, 0], "point": [0, 0, 0]},), NO_GRAVITY)),
    ("too_fast", "a ball at 8·10³⁰⁷ m/s", scene(1, [ball(0, 0, 1, velocity=(8e307, 0, 0)), ball(3, 0, 1)])),
    ("tiny", "balls of 1 µm",
     scene(0.01, [ball(0, 0, 1e-6, 1e-6), ball(1e-7, 0, 2e-5, 1e-6)], rolling_resistance=0.01)),
    ("huge", "planets meet at 10 km/s",
     scene(1e4, [ball(-3e7, 0, 0, 6e6, (1e4, 0, 0), density=5500), ball(0, 2e6, 0, 3e6, density=4000)], (), NO_GRAVITY)),
    ("digits", "coordinates of twenty digits",
     scene(3, [ball(0.12345678901234567891, 0.98765432109876543210, 1.00000000000000000001, 0.033333333333333333333),
               ball(0.12345678901234567892, 0.98765432109876543211, 1.1, 0.033333333333333333333)])),
    ("nothing", "a ball at rest without gravity", scene(5, [ball(0, 0, 1)], (), NO_GRAVITY)),
    ("flat_box", "a box falls flat", scene(2, [box(0, 0, 1, (1, 0.6, 0.4))])),
    ("tilted_box", "a box falls on an edge", scene(2, [box(0, 0, 1, (1, 0.6, 0.4), orientation=(1, 0.3, 0.1, 0))])),
    ("box_on_box", "a box on a box on the floor, in decimals",
     scene(2, [box(0, 0, 0.1, (0.2, 0.2, 0.2)), box(0, 0, 0.3, (0.2, 0.2, 0.2))])),
    ("dominoes", "five boxes in a row; the first falls",
     scene(2, [box(0.3 * k, 0, 0.5, (0.1, 0.4, 1), spin=(0, 1 if k == 0 else 0, 0)) for k in range(5)])),
    ("ball_on_cube", "a ball falls on a cube",
     scene(3, [box(0, 0, 0.6), ball(0.05, 0.02, 1.5, 0.3)], restitution=0, friction=0.5)),
    ("weightless_box", "a box tumbles in a room without gravity",
     scene(5, [box(0.5, 1, 1, (0.3, 0.5, 0.7), (1, 0.5, 0.2), (1, 2, 3))], (), NO_GRAVITY, 0.9,
           room={"least": [0, 0, 0], "greatest": [2, 2, 2]})),
]
CANNOT = """digits ball_on_ball rolls_off pyramid groove balls_fall too_fast flat_box tilted_box box_on_box dominoes
ball_on_cube""".split()  # the status is 2
PAGE = """# Forty scenes

Generated by `python3 tests/tool/scene/forty_scenes.py build/carom --page`, which runs `carom scene` on each. The run is
of {date}, on a shared core. If a line says nothing else, balls have the radius 0.1 m, ε = 0.5, μ = 0.3, and the law is
`rough`. Nothing is violated. Each scene runs to its end and holds, or says why it does not. Then nothing was found until
that time. [scenes.md](../../guide/scenes.md) explains the words. Among all scenes, the greatest rounding of an event or arc
is {worst} of its bound.

| scene | what it is | what the run says | s |
| --- | --- | --- | ---: |"""


def run(carom, directory, name, content):
    path = directory / f"{name}.json"
    path.write_text(json.dumps(content))
    begin = time.monotonic()
    done = subprocess.run([carom, "scene", str(path)], capture_output=True, text=True)
    seconds = time.monotonic() - begin
    lines = done.stdout.splitlines()
    if not lines:
        return done.returncode, done.stderr.strip().replace(f"{path}: ", "").replace("carom: ", ""), "0", seconds
    reasons = [line.removeprefix("  ended early: ").removesuffix(", which this simulation cannot follow")
               for line in lines if line.startswith("  ended early: ")]
    worst = [line.split(" at most ")[1].split()[0] for line in lines if " of the bound of " in line]
    says = "holds" if done.returncode == 0 else (reasons or lines)[-1]
    return done.returncode, says, worst[0], seconds


def main():
    carom, *options = sys.argv[1:]
    assert len(SCENES) == 40 and set(CANNOT) <= {name for name, _, _ in SCENES}
    wrong = False
    rows = []
    greatest = 0.0
    with tempfile.TemporaryDirectory() as directory:
        for name, what, content in SCENES:
            status, says, worst, seconds = run(carom, pathlib.Path(directory), name, content)
            rows.append(f"| {name} | {what} | {says.replace('|', '/')} | {seconds:.2f} |")
            greatest = max(greatest, float(worst))
            if status != (2 if name in CANNOT else 0):
                wrong = True
                print(f"{name}: exit status {status}: {says}", file=sys.stderr)
    if "--page" in options:
        print(PAGE.format(date=time.strftime("%Y-%m-%d"), worst=greatest))
        print("\n".join(rows))
    return 1 if wrong else 0


sys.exit(main())
