// SPDX-License-Identifier: BSL-1.0
import { cross, normalized, product, turn } from "./quaternion.mjs";

/** What one arc may be off by, in radians: a hundredth of a pixel on a ball that fills the screen. */
const tolerance = 1e-5;

/**
 * In how many equal steps `turned` goes through an arc of this length, on which the angular velocity is w + b s.
 * Magnus' series, broken off after the term of order h³, leaves |w|³ |b| h⁵ / 720 a step, and that many steps add up.
 * Half a radian a step is well within where the series converges.
 */
export function steps_of(w, b, duration) {
  const sideways = Math.hypot(...cross(w, b));
  if (sideways === 0) {
    return 1; // about one axis the first step is exact
  }
  const greatest = Math.max(Math.hypot(...w), Math.hypot(...w.map((x, i) => x + b[i] * duration)));
  const angle = greatest * duration;
  const change = Math.hypot(...b) * duration * duration;
  return Math.max(1, Math.ceil(angle * 2), Math.ceil((angle ** 3 * change / (720 * tolerance)) ** 0.25));
}

/** The orientation q, turned for a duration by the angular velocity w + b s, both in the world's frame. */
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

/** After so many steps an orientation is kept, so that a frame has few to go from there. */
const steps_between_knots = 24;

/**
 * The orientation of a body over all its arcs, from the times, angular velocities and their rates at the arcs' starts.
 * Arcs of which the orientation is given start from that; the others go on from the arc before.
 */
export class Orientations {
  /** @param arcs [{ start, end, w, b, q or undefined }] */
  constructor(arcs) {
    this.arcs = arcs;
    this.knots = []; // of each arc: orientations at equal distances in time
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

  /** At a time within the arc of this index. */
  at(index, time) {
    const { start, w, b } = this.arcs[index];
    const { knots, length } = this.knots[index];
    const since = Math.max(0, time - start);
    const piece = length > 0 ? Math.min(knots.length - 1, Math.floor(since / length)) : 0;
    return turned(knots[piece], at(w, b, piece * length), b, since - piece * length);
  }
}

/** The angular velocity so long after an arc's start. */
export function at(w, b, since) {
  return w.map((x, i) => x + b[i] * since);
}
