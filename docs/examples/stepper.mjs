// SPDX-License-Identifier: BSL-1.0
// A small engine that speaks Carom's line protocol and steps scenes in time: spheres above half-spaces, no packages.
import { createInterface } from 'node:readline';

const sum = (a, b) => a.map((x, i) => x + b[i]);
const times = (k, a) => a.map((x) => k * x);
const dot = (a, b) => a.reduce((s, x, i) => s + x * b[i], 0);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const length = (a) => Math.hypot(...a);

/** The orientation w, x, y, z after a turn by the vector `angle` [rad]. */
function turned([w, ...v], angle) {
  const theta = length(angle);
  const axis = theta === 0 ? [0, 0, 0] : times(Math.sin(theta / 2) / theta, angle);
  const cosine = Math.cos(theta / 2);
  return [cosine * w - dot(axis, v), ...sum(sum(times(cosine, v), times(w, axis)), cross(axis, v))];
}

/** If the sphere meets the half-space, changes its velocities by Newton's restitution and Coulomb's friction. */
function collide(ball, wall, { restitution, friction }) {
  const normal = times(1 / length(wall.half_space), wall.half_space);
  const gap = dot(sum(ball.position, times(-1, wall.position)), normal) - ball.sphere;
  const approach = -dot(ball.velocity, normal);
  if (gap > 0 || approach <= 0) {
    return;
  }
  const lever = times(-ball.sphere, normal);
  const impulse = (1 + restitution) * approach * ball.mass;
  const at_contact = sum(ball.velocity, cross(ball.angular_velocity, lever));
  const slip = sum(at_contact, times(approach, normal));
  const moment = ball.principal_inertia[0];
  const sticks = length(slip) / (1 / ball.mass + ball.sphere ** 2 / moment);  // the impulse that ends the slip
  const friction_impulse = length(slip) === 0 ? 0 : -Math.min(friction * impulse, sticks) / length(slip);
  const total = sum(times(impulse, normal), times(friction_impulse, slip));
  ball.velocity = sum(ball.velocity, times(1 / ball.mass, total));
  ball.angular_velocity = sum(ball.angular_velocity, times(1 / moment, cross(lever, total)));
}

/** Steps of the symplectic Euler method. The engine has one ball. */
function advance(bodies, scene, h, steps) {
  const [walls, [ball]] = [bodies.filter((body) => body.fixed), bodies.filter((body) => !body.fixed)];
  for (let i = 0; i < steps; ++i) {
    ball.velocity = sum(ball.velocity, times(h, scene.gravity));
    walls.forEach((wall) => collide(ball, wall, scene));
    ball.position = sum(ball.position, times(h, ball.velocity));
    ball.orientation = turned(ball.orientation, times(h, ball.angular_velocity));
  }
}

const state = ({ position, orientation = [1, 0, 0, 0], velocity = [0, 0, 0], angular_velocity = [0, 0, 0] }) =>
  ({ position, orientation, velocity, angular_velocity });

function run({ id, step: h, report, scene }) {
  if (!(h > 0) || scene.bodies.some(({ fixed, mass }) => !fixed && !(mass > 0))) {
    return { id, error: 'the step and the masses must be positive' };
  }
  if (scene.bodies.filter(({ fixed }) => !fixed).length !== 1) {
    return { id, skipped: 'this engine has one ball' };
  }
  const [copy, bodies] = [0, 1].map(() => scene.bodies.map((body) => ({ ...body })));
  advance(copy, scene, h, 10);  // warms up
  const states = [];
  let seconds = 0;
  for (const [i, count] of report.entries()) {
    const start = performance.now();
    advance(bodies, scene, h, count - (report[i - 1] ?? 0));
    seconds += (performance.now() - start) / 1000;
    states.push(bodies.map(state));
  }
  return { id, states, seconds };
}
const introduction = { protocol: 1, name: 'stepper', version: '1', precision: 'binary64', model: 'coulomb', time: true,
  cannot: ['box', 'continuous'] };
for await (const line of createInterface({ input: process.stdin })) {
  const request = JSON.parse(line);
  if (request.cmd === 'stop') {
    break;
  }
  process.stdout.write(JSON.stringify(request.cmd === 'start' ? introduction : run(request)) + '\n');
}
