// SPDX-License-Identifier: BSL-1.0
import { Motion } from "./motion.mjs";

/** Reads the page's replay, with a Motion for each body, and the impacts in the order of time. */
export function read(text) {
  const raw = JSON.parse(text);
  const duration = Math.max(Number(raw.duration) || 0, 1e-12);
  const bodies = (raw.bodies ?? []).map((body, index) => ({ ...body, name: body.name || `body ${index + 1}` }));
  const planes = raw.planes ?? [];
  const impacts = (raw.impacts ?? [])
    .map(([time, a, b, ...n]) => ({ time, a, b, point: n.slice(0, 3), impulse: n.slice(3, 6) }))
    .sort((left, right) => left.time - right.time);
  return {
    title: raw.title ?? "",
    law: raw.law ?? "",
    duration,
    of_duration: raw.of_duration ?? duration,
    gravity: raw.gravity ?? [0, 0, 0],
    bodies,
    planes,
    room: raw.room ?? null,
    motions: bodies.map((body, index) => new Motion(raw.arcs[index], duration)),
    impacts,
    series: { t: [], kinetic: [], potential: [], lost: [], spin: [], ...raw.series },
  };
}

/** The radius of the smallest ball about a body's centre that contains the body [m]. */
export function radius_of(body) {
  return body.kind === "sphere" ? body.radius : Math.max(...body.vertices.map((v) => Math.hypot(...v)));
}

/** The median of the bodies' radii [m]; infinite if there are no bodies. */
export function typical_radius(bodies) {
  return bodies.map(radius_of).sort((a, b) => a - b)[bodies.length >> 1] ?? Infinity;
}

/** The count of numbers, out of `count` ascending ones, that are at most x. */
export function count_up_to(count, number_at, x) {
  let low = 0;
  let high = count;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (number_at(middle) <= x) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}
