// SPDX-License-Identifier: BSL-1.0
import { cross, normalized, product, turn } from "./quaternion.mjs";

/** The permitted error of one arc [rad]: a hundredth of a pixel on a ball that fills the screen. */
const tolerance = 1e-5;

/**
 * The number of equal steps that `turned` takes through an arc of this duration. At the time s after the start of the
 * arc, the angular velocity is w + b s. Let h be the duration of a step. The Magnus series, truncated after the term of
 * order h³, has an error of |w|³ |b| h⁵ / 720 a step. The errors of the steps add up. A step turns by at most half a
 * radian, well within the radius of convergence.
 */
export function steps_of(w, b, duration) {
  const sideways = Math.hypot(...cross(w, b));
  if (sideways === 0) {
    return 1; // a turn about one axis is exact in one step
  }
  const greatest = Math.max(Math.hypot(...w), Math.hypot(...w.map((x, i) => x + b[i] * duration)));
  const angle = greatest * duration;
  const change = Math.hypot(...b) * duration * duration;
  return Math.max(1, Math.ceil(angle * 2), Math.ceil((angle ** 3 * change / (720 * tolerance)) ** 0.25));
}

/** The orientation q, turned for a duration with the angular velocity w + b s. Both are in the world's frame. */
export function turned(q, w, b, duration, steps = steps_of(w, b, duration)) {
  const h = duration / steps;
  let result = q;
  for (let step = 0; step < steps; ++step) {
    const middle = (step + 0.5) * h;
    const velocity = [w[0] + b[0] * middle, w[1] + b[1] * middle, w[2] + b[2] * middle];
    const bend = cross(b, velocity);
    const third = h ** 3 / 12;
    result = product(turn(velocity.map((x, i) => x * h + bend[i] * third)), result);
  }
  return normalized(result);
}

/** An orientation is kept after this many steps, so that a frame takes few steps from there. */
const steps_between_knots = 24;

/**
 * The orientation of a body over its arcs, from the time, the angular velocity and its rate at the start of each arc.
 * An arc with a given orientation starts from this orientation. Any other arc continues the previous arc.
 */
export class Orientations {
  /** @param arcs [{ start, end, w, b, q or undefined }] */
  constructor(arcs) {
    this.arcs = arcs;
    this.knots = []; // for each arc, orientations at equal distances in time
    let q = [1, 0, 0, 0];
    for (const { start, end, w, b, q: given } of arcs) {
      q = given ? normalized(given) : q;
      const duration = Math.max(0, end - start);
      const pieces = Math.ceil(steps_of(w, b, duration) / steps_between_knots);
      const length = duration / pieces;
      const knots = [q];
      for (let piece = 0; piece < pieces; ++piece) {
        q = turned(q, at(w, b, piece * length), b, length);
        if (piece + 1 < pieces) {
          knots.push(q);
        }
      }
      this.knots.push({ knots, length });
    }
  }

  /** The orientation at a time within the arc of this index. */
  at(index, time) {
    const { start, w, b } = this.arcs[index];
    const { knots, length } = this.knots[index];
    const since = Math.max(0, time - start);
    const piece = length > 0 ? Math.min(knots.length - 1, Math.floor(since / length)) : 0;
    return turned(knots[piece], at(w, b, piece * length), b, since - piece * length);
  }
}

/** The angular velocity at the time `since` after an arc's start. */
export function at(w, b, since) {
  return w.map((x, i) => x + b[i] * since);
}
