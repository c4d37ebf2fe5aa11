// SPDX-License-Identifier: BSL-1.0
import { cross, dot } from "./quaternion.mjs";

// The space in which the bodies can be, between the planes and the walls of the room. It is an intersection of
// half-spaces normal · x ≥ offset.

function unit(vector) {
  const length = Math.hypot(...vector) || 1;
  return vector.map((x) => x / length);
}

/** Two unit vectors that span the plane of this normal. The first one is level. */
export function spanning(normal, up) {
  const level = cross(up, normal);
  const first = unit(Math.hypot(...level) > 1e-6 ? level : cross(Math.abs(normal[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0], normal));
  return [first, cross(normal, first)];
}

/** The half-spaces of a scene: its planes and its room. Without a room, `box` is a border for the picture only. */
export function half_spaces(planes, room, box) {
  const all = planes.map(({ normal, point }) => {
    const n = unit(normal);
    return { normal: n, offset: dot(n, point), real: true };
  });
  const [least, greatest] = room ? [room.least, room.greatest] : box;
  const size = Math.hypot(...greatest.map((x, i) => x - least[i]));
  for (let axis = 0; axis < 3; ++axis) {
    for (const sign of [1, -1]) {
      const normal = [0, 0, 0];
      normal[axis] = sign;
      const offset = sign > 0 ? least[axis] : -greatest[axis];
      const there = all.some((other) => dot(other.normal, normal) > 1 - 1e-9 && Math.abs(other.offset - offset) < 1e-6 * size);
      if (!there) {
        all.push({ normal, offset, real: room !== null });
      }
    }
  }
  return all;
}

/**
 * The face of a half-space in the region, as its corners in order. Each corner names the half-space that bounds the
 * face along the edge to the next corner. There are fewer than three corners if the region does not reach the face.
 */
export function face_of(index, spaces, size, up) {
  const { normal, offset } = spaces[index];
  const [first, second] = spanning(normal, up);
  const far = 1e4 * size;
  let corners = [[1, 1], [-1, 1], [-1, -1], [1, -1]].map(([a, b]) => ({
    point: normal.map((x, i) => x * offset + (first[i] * a + second[i] * b) * far),
    behind: -1,
  }));
  spaces.forEach((space, other) => {
    if (other !== index && corners.length > 0) {
      corners = clipped(corners, space, other, size * 1e-7);
    }
  });
  return corners;
}

function clipped(corners, { normal, offset }, other, slack) {
  const heights = corners.map(({ point }) => dot(normal, point) - offset);
  const kept = [];
  corners.forEach((corner, i) => {
    const next = (i + 1) % corners.length;
    const inside = heights[i] >= -slack;
    if (inside) {
      kept.push(corner);
    }
    if (inside !== heights[next] >= -slack) {
      const share = heights[i] / (heights[i] - heights[next]);
      const point = corner.point.map((x, k) => x + (corners[next].point[k] - x) * share);
      kept.push({ point, behind: inside ? other : corner.behind });
    }
  });
  return kept;
}

/** 1, 2 or 5 times a power of ten, for about `cells` cells in this length. */
export function grid_step(length, cells) {
  const raw = length / cells;
  const power = 10 ** Math.floor(Math.log10(raw));
  return [1, 2, 5, 10].map((x) => x * power).find((x) => x >= raw * (1 - 1e-9));
}

/** The lines of a grid within a face, as pairs of points. The face's edges are excluded. */
export function grid_on(corners, normal, step, up) {
  const pairs = [];
  const axes = spanning(normal, up);
  axes.forEach((axis, which) => {
    const along = axes[1 - which];
    const places = corners.map(({ point }) => dot(axis, point));
    const last = Math.max(...places);
    for (let k = Math.ceil(Math.min(...places) / step + 1e-3); k * step < last - step * 1e-3; ++k) {
      const hits = [];
      corners.forEach(({ point }, i) => {
        const next = (i + 1) % corners.length;
        const [a, b] = [places[i] - k * step, places[next] - k * step];
        if (a * b <= 0 && a !== b) {
          hits.push(point.map((x, n) => x + (corners[next].point[n] - x) * a / (a - b)));
        }
      });
      if (hits.length >= 2) {
        hits.sort((p, q) => dot(along, p) - dot(along, q));
        pairs.push([hits[0], hits[hits.length - 1]]);
      }
    }
  });
  return pairs;
}

/** The tangent of the angle at which the camera looks down: small into a room, larger onto a flat box. */
export function steepness([least, greatest], up) {
  const sides = least.map((low, axis) => greatest[axis] - low);
  const height = dot(sides, up.map(Math.abs));
  const flatness = 1 - Math.min(1, height / Math.max(...sides, Number.MIN_VALUE));
  return 0.5 + 2 * Math.max(0, flatness - 0.6);
}
