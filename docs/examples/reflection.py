#!/usr/bin/env python3
# SPDX-License-Identifier: BSL-1.0
"""A collision response by the law of reflection. It shows its collision matrix, speaks Carom's line protocol, and needs no packages."""
import json
import math
import sys


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def plus(a, b, factor=1.0):
    """a + factor b."""
    return [x + factor * y for x, y in zip(a, b)]


def unit(v):
    """v/‖v‖. Divides by the largest component first, so that no square overflows or underflows."""
    largest = max(abs(x) for x in v)
    scaled = [x / largest for x in v]
    length = math.sqrt(sum(x * x for x in scaled))
    return [x / length for x in scaled]


def body_axes(quaternion):
    """The axes of the body in world coordinates."""
    w, x, y, z = unit(quaternion)
    return [
        [1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)],
        [2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)],
        [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)],
    ]


def in_world(axes, v):
    return [sum(v[i] * axes[i][k] for i in range(3)) for k in range(3)]


class Body:
    def __init__(self, record, point):
        self.velocity = vector(record["velocity"])
        self.spin = vector(record["angular_velocity"])
        self.lever_arm = plus(vector(point), vector(record["position"]), -1)
        self.inverse_mass = 0.0
        self.turns = []  # for each body axis e with moment I: e, e × r, 1/I. An impulse F has torque (e × r)·F about e
        if not record.get("immovable", False):
            self.inverse_mass = 1 / float(record["mass"])
            moments = vector(record["principal_inertia"])
            is_round = moments[0] == moments[1] == moments[2]
            axes = body_axes([1, 0, 0, 0] if is_round else vector(record.get("orientation", [1, 0, 0, 0])))
            x, y, z = [dot(e, self.lever_arm) for e in axes]
            # e × r in body axes: in world axes, rounding of e × r would turn a thin rod about its long axis
            turns = [in_world(axes, turn) for turn in ([0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0])]
            self.turns = [(e, turn, 1 / moment) for e, turn, moment in zip(axes, turns, moments)]

    def velocity_at_contact(self):
        return plus(self.velocity, cross(self.spin, self.lever_arm))

    def spin_by(self, impulse):
        """J⁻¹ (r × F): the torque about each body axis, divided by its moment."""
        change = [0.0, 0.0, 0.0]
        for axis, turn, inverse_moment in self.turns:
            change = plus(change, axis, dot(turn, impulse) * inverse_moment)
        return change

    def strike(self, impulse):
        self.velocity = plus(self.velocity, impulse, self.inverse_mass)
        self.spin = plus(self.spin, self.spin_by(impulse))


def collision_matrix(bodies):
    """K = λ I + [r_A]ᵀ J_A⁻¹ [r_A] + [r_B]ᵀ J_B⁻¹ [r_B], in world axes [1/kg]."""
    terms = [(turn, inverse_moment) for body in bodies for _, turn, inverse_moment in body.turns]
    total = sum(body.inverse_mass for body in bodies)
    entry = lambda i, j: (total if i == j else 0.0) + sum(t[i] * t[j] * inverse for t, inverse in terms)
    return [[entry(i, j) for j in range(3)] for i in range(3)]


def solved(k, b, least):
    """K⁻¹ b by K = L D Lᵀ. `least` is a lower bound of the eigenvalues and replaces a pivot that rounding makes smaller."""
    d0 = max(k[0][0], least)
    l10, l20 = k[1][0] / d0, k[2][0] / d0
    d1 = max(k[1][1] - l10 * k[1][0], least)
    e21 = k[2][1] - l20 * k[1][0]
    l21 = e21 / d1
    d2 = max(k[2][2] - l20 * k[2][0] - l21 * e21, least)
    y1 = b[1] - l10 * b[0]
    x2 = (b[2] - l20 * b[0] - l21 * y1) / d2
    x1 = y1 / d1 - l21 * x2
    return [b[0] / d0 - l10 * x1 - l20 * x2, x1, x2]


def change_at_contact(bodies, impulse):
    """K F, computed from the motion of the bodies, not from K."""
    change = [0.0, 0.0, 0.0]
    for body in bodies:
        change = plus(change, impulse, body.inverse_mass)
        for _, turn, inverse_moment in body.turns:
            change = plus(change, turn, dot(turn, impulse) * inverse_moment)
    return change


def solve(record):
    """The bodies after the impulse, and the matrix of the solve; None if there is no impulse."""
    bodies = [Body(record[name], record["point"]) for name in ("a", "b")]
    a, b = bodies
    normal = unit(vector(record["normal"]))
    approach = dot(normal, plus(a.velocity_at_contact(), b.velocity_at_contact(), -1))
    total = a.inverse_mass + b.inverse_mass
    if approach >= 0 or total == 0:
        return a, b, None
    k = collision_matrix(bodies)
    wanted = [-(1 + record["restitution"]) * approach * n for n in normal]
    if all(body.inverse_mass == 0 or not any(cross(body.lever_arm, normal)) for body in bodies):
        impulse = [x / total for x in wanted]  # K N = λ N, because r × N = 0; λ is `total`
    else:
        impulse = solved(k, wanted, total)
        impulse = plus(impulse, solved(k, plus(wanted, change_at_contact(bodies, impulse), -1), total))
    a.strike(impulse)
    b.strike([-x for x in impulse])
    return a, b, k


def vector(numbers):
    return [float(x) for x in numbers]  # also takes "nan", "inf" and "-inf"


def defect(record):
    """The defect of the input; None if there is none."""
    for name in ("a", "b"):
        body = record[name]
        for field in ("position", "velocity", "angular_velocity"):
            if not all(map(math.isfinite, vector(body[field]))):
                return f"{name}.{field} is not finite"
        if not body.get("immovable", False):
            if not all(math.isfinite(x) and x > 0 for x in vector([body["mass"], *body["principal_inertia"]])):
                return f"{name}: mass and moments of inertia must be positive"
            orientation = vector(body.get("orientation", [1, 0, 0, 0]))
            if not all(map(math.isfinite, orientation)) or not any(orientation):
                return f"{name}.orientation must be finite and not zero"
    if not all(map(math.isfinite, vector(record["point"]))):
        return "point is not finite"
    normal = vector(record["normal"])
    if not all(map(math.isfinite, normal)) or not any(normal):
        return "normal must be finite and not zero"
    if not 0 <= float(record["restitution"]) <= 1:
        return "restitution must be in [0, 1]"
    return None


def velocities(body):
    return {"velocity": body.velocity, "angular_velocity": body.spin}


def reply_to(request):
    if request["cmd"] == "start":
        about = {"name": "example-reflection", "version": "1", "precision": "binary64", "model": "reflection"}
        return {"protocol": 1, **about, "matrix": True}
    why = defect(request["collision"])
    if why:
        return {"id": request["id"], "error": why}
    a, b, matrix = solve(request["collision"])
    reply = {"id": request["id"], "a": velocities(a), "b": velocities(b)}
    return reply if matrix is None else {**reply, "C": matrix}


for line in sys.stdin:
    message = json.loads(line)
    if message["cmd"] == "stop":
        break
    print(json.dumps(reply_to(message)), flush=True)
