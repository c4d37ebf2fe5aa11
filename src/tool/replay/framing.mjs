// SPDX-License-Identifier: BSL-1.0
import { Vector3 } from "three";

import { radius_of } from "./replay_data.mjs";

/** The box that must be visible, as [least, greatest]: the room, or the box that the bodies move in. */
export function box_of(replay) {
  if (replay.room) {
    return [replay.room.least, replay.room.greatest];
  }
  const least = [Infinity, Infinity, Infinity];
  const greatest = [-Infinity, -Infinity, -Infinity];
  replay.motions.forEach((motion, index) => {
    const radius = radius_of(replay.bodies[index]);
    const [low, high] = motion.extent(replay.duration);
    for (let i = 0; i < 3; ++i) {
      least[i] = Math.min(least[i], low[i] - 2 * radius);
      greatest[i] = Math.max(greatest[i], high[i] + 2 * radius);
    }
  });
  return replay.motions.length > 0 ? [least, greatest] : [[-1, -1, -1], [1, 1, 1]];
}

export function corners_of([least, greatest]) {
  return [0, 1, 2, 3, 4, 5, 6, 7].map((bits) => new Vector3(
    ...[0, 1, 2].map((axis) => ((bits >> axis) & 1 ? greatest[axis] : least[axis]))));
}

/** The unit vector against gravity; z if there is no gravity. */
export function up_of({ gravity }) {
  const strength = Math.hypot(...gravity);
  return strength > 0 ? gravity.map((x) => -x / strength || 0) : [0, 0, 1];
}

/**
 * Places the camera in this direction from the target, so that all corners are visible and fill the picture. The target
 * moves with the camera, because the near half of the box takes more of the picture than the far half.
 */
export function frame(camera, target, corners, direction) {
  camera.position.copy(target).add(direction);
  camera.lookAt(target);
  camera.updateMatrixWorld();
  const right = new Vector3().setFromMatrixColumn(camera.matrixWorld, 0);
  const upward = new Vector3().setFromMatrixColumn(camera.matrixWorld, 1);
  const toward = new Vector3().setFromMatrixColumn(camera.matrixWorld, 2);
  const tall = Math.tan(camera.fov * Math.PI / 360) * 0.94;
  const wide = tall * camera.aspect;
  const places = corners.map((corner) => corner.clone().sub(target))
    .map((from) => ({ nearness: from.dot(toward), sideways: [from.dot(right), from.dot(upward)] }));
  // Let the camera be `shift` aside and `distance` away. Then |sideways − shift| ≤ half · (distance − nearness) must
  // hold on both sides. At the least distance, both sides are equal.
  const fits = [wide, tall].map((half, axis) => {
    const high = Math.max(...places.map(({ sideways, nearness }) => sideways[axis] + half * nearness));
    const low = Math.min(...places.map(({ sideways, nearness }) => sideways[axis] - half * nearness));
    return { shift: (high + low) / 2, distance: (high - low) / (2 * half) };
  });
  target.addScaledVector(right, fits[0].shift).addScaledVector(upward, fits[1].shift);
  camera.position.copy(target).addScaledVector(toward, Math.max(fits[0].distance, fits[1].distance));
}
