// SPDX-License-Identifier: BSL-1.0
// Fails in the way that its word names, at the first collision with a friction above 1/2.
import { solve as sound } from './sound.mjs';

const failures = {
  hang() { for (;;); },
  promise: () => new Promise(() => {}),
  exit: () => process.exit(3),
  exit_later(collision) {
    Promise.reject(new Error('planted')).catch(() => process.exit(4));
    return sound(collision);
  },
  late: () => new Promise(() => setTimeout(() => { throw new TypeError('planted'); }, 0)),
  strings: ({ a, b }) => ({ a: { velocity: ['0', 0, 0], angular_velocity: a.angular_velocity }, b }),
  short: ({ a, b }) => ({ a: { velocity: [0, 0], angular_velocity: a.angular_velocity }, b }),
  nothing: () => undefined,
  refuse() { throw new Error('not today'); },
  skip: () => ({ skipped: 'too much friction' }),
};

export function failing(word) {
  return (collision) => {
    const outcome = sound(collision);
    return collision.friction > 0.5 ? failures[word](collision) : outcome;
  };
}
