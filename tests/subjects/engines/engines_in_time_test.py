# SPDX-License-Identifier: BSL-1.0
"""Runs adapters on scenes with known answers.

engines_in_time_test.py ADAPTER    runs one program, on the scenes alone
engines_in_time_test.py NPM        runs each adapter in the folder NPM/time whose engine is installed, with both settings.
                                   The exit status is 77 if no engine is installed."""

import json
import math
import pathlib
import subprocess
import sys
import unittest

GIVEN = pathlib.Path(sys.argv[1])
PACKAGES = {"rapier": "@dimforge/rapier3d-compat", "jolt": "jolt-physics", "physx": "physx-js-webidl",
            "cannon": "cannon-es", "oimo": "oimophysics", "mujoco": "@mujoco/mujoco", "planck": "planck"}
PROGRAMS = [(GIVEN, "configured")] if GIVEN.is_file() else [
    (GIVEN / "time" / f"{name}.mjs", setting) for name, package in PACKAGES.items()
    if (GIVEN / "node_modules" / package).exists() for setting in ("configured", "as-shipped")]
STEP, G, RADIUS = 1 / 240, 9.81, 0.1  # [s], [m/s²], [m]
FLOOR = {"fixed": True, "half_space": [0, 2, 0], "position": [0, 0, 0]}  # the length of a direction means nothing


def ball(height, velocity=(0, 0, 0)):
    moments = [0.4 * 2 * RADIUS**2] * 3
    return {"sphere": RADIUS, "mass": 2, "principal_inertia": moments, "position": [0, height + RADIUS, 0],
            "orientation": [1, 0, 0, 0], "velocity": list(velocity), "angular_velocity": [0, 0, 0]}


def box(velocity):
    size, mass = (0.4, 0.2, 0.3), 3
    moments = [mass / 12 * (sum(s * s for s in size) - size[i]**2) for i in range(3)]
    return {"box": size, "mass": mass, "principal_inertia": moments, "position": [0, size[1] / 2, 0],
            "orientation": [2, 0, 0, 0], "velocity": velocity, "angular_velocity": [0, 0, 0]}


def request(bodies, report, **scene):
    return {"cmd": "run", "step": STEP, "steps": max(report), "report": report,
            "scene": {"gravity": [0, -G, 0], "restitution": 0, "friction": 0.3, "continuous": False, "bodies": bodies,
                      **scene}}


def ask(program, *requests):
    """The reply to `start`, and the replies to the requests."""
    lines = [{"cmd": "start", "protocol": 1}, *({"id": i, **each} for i, each in enumerate(requests)), {"cmd": "stop"}]
    # Without these options, an engine of WebAssembly spends seconds on optimising.
    node = ["node", "--wasm-lazy-compilation", "--no-wasm-tier-up"]
    done = subprocess.run([*node, *program], input="".join(json.dumps(line) + "\n" for line in lines),
                          capture_output=True, text=True, check=True)
    return [json.loads(line) for line in done.stdout.splitlines()]


class InTime(unittest.TestCase):
    def states(self, reply):
        """The states of a reply, in which each number is finite and each orientation has the length 1."""
        self.assertIn("states", reply, reply)
        self.assertGreaterEqual(reply["seconds"], 0)
        for body in (body for state in reply["states"] for body in state):
            self.assertEqual([len(body[name]) for name in ("position", "orientation", "velocity", "angular_velocity")],
                             [3, 4, 3, 3])
            self.assertTrue(all(map(math.isfinite, sum(body.values(), []))), body)
            # Binary32 rounds four components.
            self.assertAlmostEqual(sum(x * x for x in body["orientation"]), 1, delta=1e-6)
        return reply["states"]

    def test_scenes(self):
        for program in PROGRAMS:
            with self.subTest(program=program):
                self.check_scenes(program)

    def check_scenes(self, program):
        introduction, fall, rest, slide = ask(program, request([ball(5)], [0, 120]), request([FLOOR, ball(0)], [240]),
                                              request([FLOOR, box([1, 0, 0])], [0, 240]))
        self.assertTrue(introduction["time"])
        # A step of any method moves a falling ball by the speed at its begin, at its end, or between.
        before, after = (state[0] for state in self.states(fall))
        self.assertEqual([round(x, 6) for x in before["position"] + before["velocity"]], [0, 5 + RADIUS, 0, 0, 0, 0])
        seconds = 120 * STEP
        damping = 0.05 if "as-shipped" in program else 0  # [1/s], the greatest of an engine
        self.assertAlmostEqual(after["velocity"][1], -G * seconds, delta=G * seconds * (damping * seconds + 1e-5))
        self.assertAlmostEqual(after["position"][1], 5 + RADIUS - G * seconds**2 / 2,
                               delta=G * seconds * STEP / 2 + damping * G * seconds**3 + 1e-5)
        # The engines correct neither a gap nor a depth below their slop, which is at most 2 cm.
        resting = self.states(rest)[0][1]
        self.assertAlmostEqual(resting["position"][1], RADIUS, delta=0.02)
        self.assertLess(math.hypot(*resting["velocity"]), G * STEP)
        if "box" not in introduction.get("cannot", []):
            before, after = (state[1] for state in self.states(slide))
            self.assertEqual([round(x, 6) for x in before["velocity"]], [1, 0, 0])
            self.assertLess(math.hypot(*after["velocity"]), G * STEP)
            # cannon-es limits friction at each of four corners, and its limit grows as the step shrinks. So the box
            # only has to move at all, and at most 10 % beyond v²/2μg.
            self.assertGreater(after["position"][0], 1e-4)
            self.assertLess(after["position"][0], 1.1 / (2 * 0.3 * G))

    def test_save_and_restore(self):
        for program in PROGRAMS if GIVEN.is_dir() else []:
            with self.subTest(program=program):
                self.check_save_and_restore(program)

    def check_save_and_restore(self, program):
        more = {"cmd": "run", "step": STEP, "steps": 60, "report": [60]}
        introduction, *replies = ask(program, request([FLOOR, ball(5)], [60]), {"cmd": "save"}, more, {"cmd": "restore"}, more)
        if introduction.get("restores"):
            self.assertEqual(replies[2]["states"], replies[4]["states"])
            self.assertNotEqual(replies[0]["states"], replies[2]["states"])
        else:
            self.assertIn("error", replies[1])

    def test_malformed_requests(self):
        for program in PROGRAMS if GIVEN.is_dir() else []:
            with self.subTest(program=program):
                self.check_malformed_requests(program)

    def check_malformed_requests(self, program):
        def without(field, body=1):
            bad = json.loads(json.dumps(request([FLOOR, ball(1)], [1])))
            del bad["scene"]["bodies"][body][field]
            return bad

        good = request([FLOOR, ball(1)], [1])
        wrong = [({"cmd": "run", "step": STEP, "steps": 1, "report": [1]}, "scene"),
                 ({**good, "step": 0}, "step"), ({**good, "steps": 1.5}, "steps"), ({**good, "report": [2]}, "report"),
                 (without("mass"), "scene.bodies[1].mass"), (without("sphere"), "scene.bodies[1]"),
                 (without("velocity"), "scene.bodies[1].velocity"), (without("fixed", 0), "scene.bodies[0].fixed"),
                 (request([FLOOR, ball(1)], [1], restitution=2), "scene.restitution"),
                 (request([FLOOR, ball(1)], [1], gravity=["nan", 0, 0]), "scene.gravity"),
                 (request([], [1]), "scene.bodies"), ({"cmd": "walk"}, "cmd")]
        for (bad, field), reply in zip(wrong, ask(program, *(bad for bad, _ in wrong))[1:]):
            self.assertTrue(reply.get("error", "").startswith(field + ":"), (field, reply))


if not PROGRAMS:
    print(f"no engine is installed: npm ci --prefix {GIVEN}")
    sys.exit(77)
unittest.main(argv=sys.argv[:1])
