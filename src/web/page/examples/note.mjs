// SPDX-License-Identifier: BSL-1.0
// The method of D. Eberly's note, "Computing Impulse Forces for Colliding Contact".
// Its basis holds a tangent along the slip. Bodies that meet head-on have only rounding
// errors for a slip, so that their tangent is arbitrary.
export const name = "the note's method", law = 'reflection';

export function solve(collision) {
  refuseInvalid(collision);
  const { a, b, point, restitution } = collision;
  const n = unit(collision.normal); // from B to A
  const [armA, armB] = [subtract(point, a.position), subtract(point, b.position)];
  const velocity = subtract(velocityAt(a, armA), velocityAt(b, armB));
  const approach = dot(n, velocity);
  if (approach >= 0 || (a.immovable && b.immovable)) return { a, b };
  const slip = subtract(velocity, scale(approach, n));
  const t0 = slip.some((x) => x !== 0) ? unit(slip) : [0, 0, 0];
  const basis = [n, t0, cross(n, t0)];
  const [changeA, changeB] = [change(a, armA, basis), change(b, armB, basis)];
  const C = [0, 1, 2].map((i) => add(changeA.matrix[i], changeB.matrix[i]));
  const first = cross(C[1], C[2]); // the first column of the inverse of C, times det C
  const f = scale(-(1 + restitution) * approach / dot(C[0], first), first);
  return { a: struck(a, changeA, basis, f), b: struck(b, changeB, basis, scale(-1, f)) };
}

/** The changes of spin by unit impulses along the basis, and the body's part of C. */
function change(body, arm, basis) {
  if (body.immovable) return { matrix: basis.map(() => [0, 0, 0]) };
  const axes = bodyAxes(body.orientation);
  const toBody = (v) => axes.map((axis) => dot(axis, v));
  const torques = basis.map((direction) => cross(toBody(arm), toBody(direction)));
  const turns = torques.map((torque) =>
    torque.map((t, i) => t / body.principal_inertia[i]));
  return {
    ofSpin: turns.map((turn) => combine(axes, turn)),
    matrix: torques.map((torque, i) =>
      turns.map((turn, j) => (i === j ? 1 / body.mass : 0) + dot(torque, turn))),
  };
}

const struck = (body, { ofSpin }, basis, f) => body.immovable ? body : {
  velocity: add(body.velocity, scale(1 / body.mass, combine(basis, f))),
  angular_velocity: add(body.angular_velocity, combine(ofSpin, f)),
};
const velocityAt = (body, arm) => add(body.velocity, cross(body.angular_velocity, arm));
const dot = (u, v) => u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
const cross = (u, v) =>
  [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
const add = (u, v) => u.map((x, i) => x + v[i]);
const subtract = (u, v) => u.map((x, i) => x - v[i]);
const scale = (k, v) => v.map((x) => k * x);
const combine = (vectors, k) =>
  add(add(scale(k[0], vectors[0]), scale(k[1], vectors[1])), scale(k[2], vectors[2]));

/** v / ‖v‖. The largest component divides first, so that no square overflows. */
function unit(v) {
  const scaled = scale(1 / Math.max(...v.map(Math.abs)), v);
  return scale(1 / Math.hypot(...scaled), scaled);
}

/** The axes of the body, in world axes. */
function bodyAxes(quaternion) {
  const [w, x, y, z] = unit(quaternion);
  return [
    [1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)],
    [2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)],
    [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)],
  ];
}

function refuseInvalid({ a, b, point, normal, restitution }) {
  const isDirection = (v) => v.every(Number.isFinite) && v.some((x) => x !== 0);
  const isPositive = (x) => x > 0 && x < Infinity;
  const isValid = (body) =>
    [body.position, body.velocity, body.angular_velocity].every((v) => v.every(Number.isFinite))
    && (body.immovable || isDirection(body.orientation)
      && isPositive(body.mass) && body.principal_inertia.every(isPositive));
  if (!(isValid(a) && isValid(b) && point.every(Number.isFinite) && isDirection(normal)
    && restitution >= 0 && restitution <= 1)) {
    throw new Error('this is not a collision');
  }
}
