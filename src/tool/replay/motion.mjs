// SPDX-License-Identifier: BSL-1.0
import { Orientations, at } from "./orientation.mjs";

/** The numbers of an arc: t, position, velocity, acceleration, angular velocity, its rate. The phase is next. */
const numbers = 16;

export const phases = ["flying", "sliding", "rolling", "spinning", "resting"];

/** The arcs of one body (its motions between two events), and its state at a time. */
export class Motion {
  constructor(arcs, duration) {
    this.count = arcs.length;
    this.numbers = new Float64Array(this.count * numbers);
    this.phases = new Uint8Array(this.count);
    arcs.forEach((arc, index) => {
      this.numbers.set(arc.slice(0, numbers), index * numbers);
      this.phases[index] = Math.max(0, phases.indexOf(arc[numbers]));
    });
    this.orientations = new Orientations(arcs.map((arc, index) => ({
      start: arc[0],
      end: index + 1 < arcs.length ? arcs[index + 1][0] : Math.max(arc[0], duration),
      w: arc.slice(10, 13),
      b: arc.slice(13, 16),
      q: arc.length > numbers + 4 ? arc.slice(numbers + 1, numbers + 5) : undefined,
    })));
    this.latest = 0;
  }

  start_of(index) {
    return this.numbers[index * numbers];
  }

  /** The index of the last arc that has begun at this time; 0 if none has begun. */
  arc_at(time) {
    // From one frame to the next, the arc stays the same or is the next one.
    for (let index = this.latest; index < Math.min(this.latest + 2, this.count); ++index) {
      const ends = index + 1 < this.count ? this.start_of(index + 1) : Infinity;
      if (this.start_of(index) <= time && time < ends) {
        this.latest = index;
        return index;
      }
    }
    let low = 0;
    let high = this.count - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.start_of(middle) <= time) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    this.latest = low;
    return low;
  }

  /** The position, orientation, velocities and phase at this time. */
  at(time) {
    const index = this.arc_at(time);
    const n = this.numbers.subarray(index * numbers, (index + 1) * numbers);
    const s = time - n[0];
    const velocity = [0, 1, 2].map((i) => n[4 + i] + n[7 + i] * s);
    return {
      position: [0, 1, 2].map((i) => n[1 + i] + (n[4 + i] + n[7 + i] * s / 2) * s),
      velocity,
      angular_velocity: at([n[10], n[11], n[12]], [n[13], n[14], n[15]], s),
      orientation: this.orientations.at(index, time),
      phase: this.phases[index],
    };
  }

  /** The smallest box that the body's centre stays in, as [least, greatest]. */
  extent(duration) {
    const least = [Infinity, Infinity, Infinity];
    const greatest = [-Infinity, -Infinity, -Infinity];
    for (let index = 0; index < this.count; ++index) {
      const n = this.numbers.subarray(index * numbers, (index + 1) * numbers);
      const length = Math.max(0, (index + 1 < this.count ? this.start_of(index + 1) : duration) - n[0]);
      for (let i = 0; i < 3; ++i) {
        const turning = n[7 + i] !== 0 ? -n[4 + i] / n[7 + i] : 0;
        for (const s of [0, length, Math.min(Math.max(turning, 0), length)]) {
          const x = n[1 + i] + (n[4 + i] + n[7 + i] * s / 2) * s;
          least[i] = Math.min(least[i], x);
          greatest[i] = Math.max(greatest[i], x);
        }
      }
    }
    return [least, greatest];
  }
}
