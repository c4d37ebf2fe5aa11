// SPDX-License-Identifier: BSL-1.0
// Friction against the wrong slip: this solver opposes the slip before the impulse.
// The law opposes the slip after the impulse.
export const name = 'friction against the wrong slip', law = 'coulomb';

export function solve(collision) {
  refuseInvalid(collision);
  const { a, b, point, restitution, friction } = collision;
  const n = unit(collision.normal); // from B to A
  const [armA, armB] = [subtract(point, a.position), subtract(point, b.position)];
  const velocity = subtract(velocityAt(a, armA), velocityAt(b, armB));
  const approach = dot(n, velocity);
  if (approach >= 0 || (a.immovable && b.immovable)) return { a, b };
  const across = subtract(velocity, scale(approach, n));
  const slip = Math.hypot(...across);
  const t = slip > 0 ? unit(across) : [0, 0, 0];
  const K = (u, v) =>
    dot(u, add(change(a, armA, v).atContact, change(b, armB, v).atContact));
  const [nn, nt, tt] = [K(n, n), K(n, t), K(t, t)];
  const bounce = -(1 + restitution) * approach;
  // The impulse lies along n − k t. With k = stick, the slip along t stops.
  const stick = slip > 0 ? (slip * nn + bounce * nt) / (slip * nt + bounce * tt) : 0;
  const k = Math.min(Math.max(stick, 0), friction);
  const impulse = scale(bounce / (nn - k * nt), subtract(n, scale(k, t)));
  return { a: struck(a, armA, impulse), b: struck(b, armB, scale(-1, impulse)) };
}

/** The changes of velocity, spin, and velocity at the contact by an impulse. */
function change(body, arm, impulse) {
  if (body.immovable) return { atContact: [0, 0, 0] };
  const axes = bodyAxes(body.orientation);
  const toBody = (v) => axes.map((axis) => dot(axis, v));
  const torque = cross(toBody(arm), toBody(impulse));
  const ofSpin = combine(axes, torque.map((t, i) => t / body.principal_inertia[i]));
  const ofVelocity = scale(1 / body.mass, impulse);
  return { ofVelocity, ofSpin, atContact: add(ofVelocity, cross(ofSpin, arm)) };
}

function struck(body, arm, impulse) {
  if (body.immovable) return body;
  const { ofVelocity, ofSpin } = change(body, arm, impulse);
  return {
    velocity: add(body.velocity, ofVelocity),
    angular_velocity: add(body.angular_velocity, ofSpin),
  };
}

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

function refuseInvalid({ a, b, point, normal, restitution, friction }) {
  const isDirection = (v) => v.every(Number.isFinite) && v.some((x) => x !== 0);
  const isPositive = (x) => x > 0 && x < Infinity;
  const isValid = (body) =>
    [body.position, body.velocity, body.angular_velocity].every((v) => v.every(Number.isFinite))
    && (body.immovable || isDirection(body.orientation)
      && isPositive(body.mass) && body.principal_inertia.every(isPositive));
  if (!(isValid(a) && isValid(b) && point.every(Number.isFinite) && isDirection(normal)
    && restitution >= 0 && restitution <= 1 && friction >= 0 && friction < Infinity)) {
    throw new Error('this is not a collision');
  }
}
