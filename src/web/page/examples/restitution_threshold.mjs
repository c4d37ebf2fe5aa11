// SPDX-License-Identifier: BSL-1.0
// A restitution threshold: slow contacts do not bounce, as in many engines.
// The law says that they do. The last line of this block would declare the threshold.
// Then choose the domain approach=0.5: too, so that few cases are slow.
export const name = 'restitution threshold', law = 'frictionless';
// export const claims = { restitution_threshold: 0.5 };

export function solve(collision) {
  refuseInvalid(collision);
  const { a, b, point, restitution } = collision;
  const n = unit(collision.normal); // from B to A
  const [armA, armB] = [subtract(point, a.position), subtract(point, b.position)];
  const approach = dot(n, subtract(velocityAt(a, armA), velocityAt(b, armB)));
  if (approach >= 0 || (a.immovable && b.immovable)) return { a, b };
  const [changeA, changeB] = [change(a, armA, n), change(b, armB, n)];
  const bounce = approach > -0.5 ? 0 : restitution; // m/s;
  const impulse = -(1 + bounce) * approach / (changeA.ofSpeed + changeB.ofSpeed);
  return { a: struck(a, changeA, impulse), b: struck(b, changeB, -impulse) };
}

/** The changes of velocity, spin, and speed at the contact by a unit impulse along n. */
function change(body, arm, n) {
  if (body.immovable) return { ofSpeed: 0 };
  const axes = bodyAxes(body.orientation);
  const toBody = (v) => axes.map((axis) => dot(axis, v));
  const torque = cross(toBody(arm), toBody(n));
  const turn = torque.map((t, i) => t / body.principal_inertia[i]);
  return {
    ofVelocity: scale(1 / body.mass, n),
    ofSpin: combine(axes, turn),
    ofSpeed: 1 / body.mass + dot(torque, turn),
  };
}

const struck = (body, { ofVelocity, ofSpin }, impulse) => body.immovable ? body : {
  velocity: add(body.velocity, scale(impulse, ofVelocity)),
  angular_velocity: add(body.angular_velocity, scale(impulse, ofSpin)),
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
