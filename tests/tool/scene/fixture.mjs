// SPDX-License-Identifier: BSL-1.0
// node fixture.mjs FILE: writes a replay for checks of the drawing. Six balls and a cube in a room bounce, slide, roll
// and come to rest. A ball on the ground has an angular velocity that rotates and changes. The physics is simple,
// because no verdict depends on it.
import { writeFileSync } from "node:fs";

const gravity = 9.81;
const duration = 6;
const step = 1 / 2000;
const friction = 0.25;
const size = [2, 1.2, 0.9];
const length = (v) => Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];

const ball = (name, radius, p, v, w) => ({ name, kind: "sphere", radius, mass: 4000 * radius ** 3, p, v, w, a: [0, 0, 0],
  b: [0, 0, 0], phase: "flying", loss: 0.75, arcs: [] });
const bodies = [
  ball("cue", 0.09, [0.3, 0.3, 0.09], [1.5, 0.35, 0], [6, -9, 12]),
  ball("two", 0.09, [1.2, 0.52, 0.09], [0, 0, 0], [0, 0, 0]),
  ball("three", 0.07, [0.6, 0.9, 0.7], [0.4, -0.3, 0], [0, 8, 3]),
  ball("four", 0.11, [1.6, 0.8, 0.5], [-0.5, 0.1, 0.5], [5, 0, 5]),
  ball("five", 0.06, [1.0, 0.2, 0.8], [0.2, 0.5, -1], [0, 0, 20]),
  ball("top", 0.08, [1.75, 0.2, 0.08], [0, 0, 0], [0, 0, 15]),
];
const half = 0.1;
const vertices = [0, 1, 2, 3, 4, 5, 6, 7].map((n) => [n & 1, (n >> 1) & 1, n >> 2].map((bit) => (bit ? half : -half)));
bodies.push({ ...ball("die", half * 1.3, [0.45, 0.55, 0.6], [0.5, 0.2, 0.5], [2, 3, 1]), kind: "polyhedron", vertices,
  faces: [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]], q: [1, 0, 0, 0] });
const planes = [0, 1, 2].flatMap((axis) => [1, -1].map((sign) => ({
  name: `${"xyz"[axis]}${sign > 0 ? "−" : "+"}`,
  normal: [0, 1, 2].map((i) => (i === axis ? sign : 0)),
  point: [0, 1, 2].map((i) => (i === axis && sign < 0 ? size[axis] : 0)),
})));

/** The phase of the body, its acceleration and its angular acceleration. On the floor, the vertical velocity ends. */
function settle(body) {
  const radius = body.radius;
  if (body.p[2] > radius + 1e-4 || Math.abs(body.v[2]) > 0.12) {
    return ["flying", [0, 0, -gravity], [0, 0, 0]];
  }
  body.p[2] = radius;
  body.v[2] = 0;
  const slip = [body.v[0] - body.w[1] * radius, body.v[1] + body.w[0] * radius, 0];
  const speed = length(slip);
  if (speed > 0.02) {
    const a = slip.map((x) => -friction * gravity * x / speed);
    return ["sliding", a, cross([0, 0, -1], a).map((x) => x * 2.5 / radius)];
  }
  body.w[0] = -body.v[1] / radius;
  body.w[1] = body.v[0] / radius;
  const pace = length(body.v);
  if (pace > 0.03) {
    const a = body.v.map((x) => -0.12 * x / pace);
    const b = cross([0, 0, 1], a).map((x) => x / radius);
    return ["rolling", a, [b[0], b[1], Math.abs(body.w[2]) > 0.3 ? -Math.sign(body.w[2]) * 2 : 0]];
  }
  body.v = [0, 0, 0];
  return Math.abs(body.w[2]) > 0.3 ? ["spinning", [0, 0, 0], [0, 0, -Math.sign(body.w[2]) * 2]]
    : ["resting", [0, 0, 0], [0, 0, 0]];
}

function turned([w, x, y, z], rate, h) {
  const [a, b, c] = rate.map((r) => r * h / 2);
  const q = [w - a * x - b * y - c * z, x + a * w + b * z - c * y, y + b * w + c * x - a * z, z + c * w + a * y - b * x];
  const norm = Math.sqrt(q.reduce((sum, n) => sum + n * n, 0));
  return q.map((n) => n / norm);
}

const impacts = [];
const series = { t: [], kinetic: [], potential: [], lost: [], spin: [] };
let total;
const round = (x) => Number(x.toPrecision(12));

function arc_of(body, time) {
  return [time, ...body.p, ...body.v, ...body.a, ...body.w, ...body.b].map(round).concat(body.phase, (body.q ?? []).map(round));
}

function measure(time) {
  let [kinetic, potential, spin] = [0, 0, 0];
  for (const { mass, radius, v, w, p } of bodies) {
    spin += 0.2 * mass * radius ** 2 * length(w) ** 2;
    kinetic += 0.5 * mass * length(v) ** 2;
    potential += mass * gravity * p[2];
  }
  total ??= kinetic + spin + potential;
  series.t.push(round(time));
  series.kinetic.push(round(kinetic + spin));
  series.potential.push(round(potential));
  series.lost.push(round(total - kinetic - spin - potential));
  series.spin.push(round(spin));
}

function bounce(time, body, index) {
  let hit = false;
  planes.forEach(({ normal, point }, plane) => {
    const axis = normal.findIndex((n) => n !== 0);
    const sign = normal[axis];
    if ((body.p[axis] - point[axis]) * sign < body.radius && body.v[axis] * sign < 0) {
      const before = body.v[axis];
      const kept = axis === 2 && Math.abs(before) < 0.12 ? 0 : -body.loss * before;
      body.v[axis] = kept;
      body.p[axis] = point[axis] + sign * body.radius;
      const at = body.p.map((x, i) => (i === axis ? point[axis] : x));
      if (body.phase === "flying" || axis !== 2) {
        impacts.push([time, index, -1 - plane, ...at, ...normal.map((n) => Math.abs(n) * body.mass * (kept - before))].map(round));
        if (body.q) {
          body.w = body.w.map((x, i) => -0.6 * x + 1.5 * (i === axis ? 0.4 : 1) * Math.abs(before));
        }
      }
      hit = true;
    }
  });
  return hit;
}

function collide(time, one, two) {
  const [a, b] = [bodies[one], bodies[two]];
  const apart = a.p.map((x, i) => x - b.p[i]);
  const distance = length(apart);
  const normal = apart.map((x) => x / distance);
  const closing = normal.reduce((sum, n, i) => sum + n * (a.v[i] - b.v[i]), 0);
  if (distance >= a.radius + b.radius || closing >= 0) {
    return false;
  }
  const size_of = -(1 + 0.9) * closing / (1 / a.mass + 1 / b.mass);
  a.v = a.v.map((x, i) => x + normal[i] * size_of / a.mass);
  b.v = b.v.map((x, i) => x - normal[i] * size_of / b.mass);
  impacts.push([time, one, two, ...b.p.map((x, i) => x + normal[i] * b.radius), ...normal.map((n) => n * size_of)].map(round));
  return true;
}

for (let n = 0; n <= duration / step; ++n) {
  const time = n * step;
  const changed = bodies.map((body, index) => n === 0 || bounce(time, body, index));
  for (let one = 0; one < bodies.length; ++one) {
    for (let two = one + 1; two < bodies.length; ++two) {
      if (collide(time, one, two)) {
        changed[one] = changed[two] = true;
      }
    }
  }
  bodies.forEach((body, index) => {
    const [phase, a, b] = settle(body);
    const is_due = phase === "sliding" ? n % 40 === 0 : body.q && body.phase !== "resting" && n % 20 === 0;
    if (changed[index] || phase !== body.phase || is_due) {
      Object.assign(body, { phase, a, b });
      body.arcs.push(arc_of(body, time));
    }
  });
  if (n % 20 === 0) {
    measure(time);
  }
  for (const body of bodies) {
    body.p = body.p.map((x, i) => x + (body.v[i] + body.a[i] * step / 2) * step);
    body.v = body.v.map((x, i) => x + body.a[i] * step);
    if (body.q) {
      body.q = turned(body.q, body.w, step);
    }
    body.w = body.w.map((x, i) => x + body.b[i] * step);
  }
}

writeFileSync(process.argv[2], JSON.stringify({
  title: "Six balls and a die in a room", law: "reflection", duration, gravity: [0, 0, -gravity],
  bodies: bodies.map(({ name, kind, radius, vertices: corners, faces }) => (kind === "sphere" ? { name, kind, radius }
    : { name, kind, vertices: corners, faces })),
  planes, room: { least: [0, 0, 0], greatest: size }, arcs: bodies.map(({ arcs }) => arcs), impacts, series,
}));
