// SPDX-License-Identifier: BSL-1.0
// The memory that a judge's thread shares with the thread of its solver.
import { answer_size, collision_size } from '../solver/doubles.mjs';

/** The most collisions of one batch. */
export const capacity = 1024;

/** Indices of the flags. */
export const flag = { state: 0, count: 1, done: 2 };

/** Values of the flag `state`. The solver's thread changes `asked` to another value; the judge's thread the others. */
export const state = { idle: 0, asked: 1, failed: 2, ended: 3 };

const header = 16;  // bytes

export function new_buffer() {
  return new SharedArrayBuffer(header + 8 * capacity * (collision_size + answer_size));
}

/** The flags, the collisions and the answers in the buffer. */
export function views_of(buffer) {
  return {
    flags: new Int32Array(buffer, 0, header / 4),
    collisions: new Float64Array(buffer, header, capacity * collision_size),
    answers: new Float64Array(buffer, header + 8 * capacity * collision_size, capacity * answer_size),
  };
}

export function set_state(flags, value) {
  Atomics.store(flags, flag.state, value);
  Atomics.notify(flags, flag.state);
}
