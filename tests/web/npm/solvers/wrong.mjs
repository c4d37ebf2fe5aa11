// SPDX-License-Identifier: BSL-1.0
// Bounces with twice the restitution.
import { solve as sound } from './sound.mjs';

export const law = 'frictionless', name = 'wrong', version = '7';

export default function solve(collision) {
  sound(collision);
  return sound({ ...collision, restitution: Math.min(1, 2 * collision.restitution) });
}
