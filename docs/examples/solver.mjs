// SPDX-License-Identifier: BSL-1.0
// A frictionless collision response that speaks Carom's line protocol. It needs Node and no packages.
import { createInterface } from 'node:readline';

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const sum = (a, b) => a.map((x, i) => x + b[i]);
const times = (k, a) => a.map((x) => k * x);

/** v/‖v‖. Divides by the largest component first, so that no square overflows or underflows. */
function unit(v) {
  const scaled = times(1 / Math.max(...v.map(Math.abs)), v);
  return times(1 / Math.sqrt(scaled.reduce((s, x) => s + x * x, 0)), scaled);
}

/** The rows of the rotation from body axes to world axes. */
function rotation(quaternion) {
  const [w, x, y, z] = unit(quaternion);
  return [
    [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
    [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
    [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
  ];
}

/**
 * The change of spin J⁻¹ (r × N) by a unit impulse along N, and its product with r × N: J⁻¹ = R diag(1/I) Rᵀ. Both r and
 * N are turned into body axes first: in world axes, rounding of r × N would turn a thin rod about its long axis.
 */
function turning({ orientation = [1, 0, 0, 0], principal_inertia }, leverArm, normal) {
  const axes = rotation(orientation);
  const inBody = (v) => [0, 1, 2].map((i) => dot(axes.map((row) => row[i]), v));
  const torque = cross(inBody(leverArm), inBody(normal));
  const divided = torque.map((t, i) => t / principal_inertia[i]);
  return [axes.map((row) => dot(row, divided)), dot(torque, divided)];
}

function solve({ a, b, point, normal: anyLength, restitution }) {
  const normal = unit(anyLength);
  const bodies = [a, b].map((body, i) => {
    const leverArm = sum(point, times(-1, body.position));
    const made = { body, leverArm, sign: i === 0 ? 1 : -1 };
    made.atContact = sum(body.velocity, cross(body.angular_velocity, leverArm));
    if (!body.immovable) {
      const [spin, alongTorque] = turning(body, leverArm, normal);
      made.response = spin;
      made.inertness = 1 / body.mass + alongTorque;
    }
    return made;
  });
  const approach = dot(normal, sum(bodies[0].atContact, times(-1, bodies[1].atContact)));
  const movable = bodies.filter(({ body }) => !body.immovable);
  const impulse = approach < 0 ? -((1 + restitution) * approach) / movable.reduce((s, x) => s + x.inertness, 0) : 0;
  return bodies.map(({ body, response, sign }) =>
    body.immovable || impulse === 0
      ? { velocity: body.velocity, angular_velocity: body.angular_velocity }
      : {
          velocity: sum(body.velocity, times((sign * impulse) / body.mass, normal)),
          angular_velocity: sum(body.angular_velocity, times(sign * impulse, response)),
        });
}

const finite = (v) => v.every(Number.isFinite);

/** The defect of the input; undefined if there is none. JSON has no NaN or infinity, so these come as strings. */
function defect({ a, b, point, normal, restitution }) {
  for (const body of [a, b]) {
    if (!finite([...body.position, ...body.velocity, ...body.angular_velocity])) {
      return 'positions and velocities must be finite';
    }
    if (!body.immovable) {
      const positive = [body.mass, ...body.principal_inertia];
      const orientation = body.orientation ?? [1, 0, 0, 0];
      if (!finite(positive) || positive.some((x) => x <= 0)) {
        return 'mass and moments of inertia must be positive';
      }
      if (!finite(orientation) || !orientation.some((x) => x !== 0)) {
        return 'an orientation must be finite and not zero';
      }
    }
  }
  if (!finite(point) || !finite(normal) || !normal.some((x) => x !== 0)) {
    return 'point and normal must be finite, and the normal not zero';
  }
  return Number.isFinite(restitution) && restitution >= 0 && restitution <= 1 ? undefined : 'restitution must be in [0, 1]';
}

function replyTo({ cmd, id, collision }) {
  if (cmd === 'start') {
    return { protocol: 1, name: 'example-node', version: '1', precision: 'binary64', model: 'frictionless' };
  }
  const why = defect(collision);
  if (why) {
    return { id, error: why };
  }
  const [a, b] = solve(collision);
  return { id, a, b };
}

for await (const line of createInterface({ input: process.stdin })) {
  const request = JSON.parse(line);
  if (request.cmd === 'stop') {
    break;
  }
  process.stdout.write(JSON.stringify(replyTo(request)) + '\n');
}
