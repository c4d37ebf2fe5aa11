#!/usr/bin/env python3
# SPDX-License-Identifier: BSL-1.0
"""A frictionless collision response that speaks Carom's line protocol. It needs plain Python and no packages."""
import json
import math
import sys


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(v):
    """v/‖v‖. Divides by the largest component first, so that no square overflows or underflows."""
    largest = max(abs(x) for x in v)
    scaled = [x / largest for x in v]
    length = math.sqrt(sum(x * x for x in scaled))
    return [x / length for x in scaled]


def rotation(quaternion):
    w, x, y, z = unit(quaternion)
    return [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]


class Body:
    def __init__(self, record, point):
        self.immovable = record.get("immovable", False)
        self.velocity = vector(record["velocity"])
        self.spin = vector(record["angular_velocity"])
        self.lever_arm = [p - x for p, x in zip(vector(point), vector(record["position"]))]
        if not self.immovable:
            self.mass = float(record["mass"])
            self.moments = vector(record["principal_inertia"])
            self.orientation = vector(record.get("orientation", [1, 0, 0, 0]))

    def velocity_at_contact(self):
        return [v + t for v, t in zip(self.velocity, cross(self.spin, self.lever_arm))]

    def turning(self, normal):
        """J⁻¹ (r × N), and its product with r × N, by J⁻¹ = R diag(1/I) Rᵀ. Both r and N are turned into body axes
        before they are multiplied: in world axes, rounding of r × N would turn a thin rod about its long axis."""
        axes = rotation(self.orientation)
        in_body = lambda v: [sum(axes[k][i] * v[k] for k in range(3)) for i in range(3)]
        torque = cross(in_body(self.lever_arm), in_body(normal))
        divided = [t / moment for t, moment in zip(torque, self.moments)]
        return [dot(row, divided) for row in axes], dot(torque, divided)


def solve(record):
    a = Body(record["a"], record["point"])
    b = Body(record["b"], record["point"])
    normal = unit(vector(record["normal"]))
    approach = dot(normal, [u - v for u, v in zip(a.velocity_at_contact(), b.velocity_at_contact())])
    movable = [(body, sign) for body, sign in ((a, 1), (b, -1)) if not body.immovable]
    if approach < 0 and movable:
        turning = {body: body.turning(normal) for body, _ in movable}
        denominator = sum(1 / body.mass + turning[body][1] for body, _ in movable)
        impulse = -(1 + record["restitution"]) * approach / denominator
        for body, sign in movable:
            body.velocity = [v + sign * impulse / body.mass * n for v, n in zip(body.velocity, normal)]
            body.spin = [w + sign * impulse * r for w, r in zip(body.spin, turning[body][0])]
    return a, b


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
        return {"protocol": 1, "name": "example-python", "version": "1", "precision": "binary64", "model": "frictionless"}
    why = defect(request["collision"])
    if why:
        return {"id": request["id"], "error": why}
    a, b = solve(request["collision"])
    return {"id": request["id"], "a": velocities(a), "b": velocities(b)}


for line in sys.stdin:
    message = json.loads(line)
    if message["cmd"] == "stop":
        break
    print(json.dumps(reply_to(message)), flush=True)
