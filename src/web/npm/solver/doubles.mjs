// SPDX-License-Identifier: BSL-1.0
// Collisions and answers as the judge's memory holds them: rows of doubles.

export const collision_size = 45;
export const answer_size = 23;
const body_size = 18;
const matrix_at = 13;

export const status = { outcome: 0, refused: 1, skipped: 2 };

const vector = (numbers, at) => [numbers[at], numbers[at + 1], numbers[at + 2]];

function body_at(numbers, at) {
  const motion = {
    position: vector(numbers, at + 9),
    velocity: vector(numbers, at + 12),
    angular_velocity: vector(numbers, at + 15),
  };
  if (numbers[at] !== 0) {
    return { immovable: true, ...motion };
  }
  const orientation = [numbers[at + 5], numbers[at + 6], numbers[at + 7], numbers[at + 8]];  // w, x, y, z
  return {
    immovable: false, mass: numbers[at + 1], principal_inertia: vector(numbers, at + 2), orientation, ...motion,
  };
}

/** The collision whose 45 doubles begin at `at`. */
export function collision_at(numbers, at) {
  return {
    a: body_at(numbers, at),
    b: body_at(numbers, at + body_size),
    point: vector(numbers, at + 36),
    normal: vector(numbers, at + 39),
    restitution: numbers[at + 42],
    friction: numbers[at + 43],
    tangential_restitution: numbers[at + 44],
  };
}

/** Writes an outcome, with its collision matrix if `C` is given, to the 23 doubles that begin at `at`. */
export function write_outcome(numbers, at, { a, b, C }) {
  numbers[at] = status.outcome;
  [a.velocity, a.angular_velocity, b.velocity, b.angular_velocity].forEach((v, i) => numbers.set(v, at + 1 + 3 * i));
  numbers[at + matrix_at] = C === undefined ? 0 : 1;
  C?.forEach((row, i) => numbers.set(row, at + matrix_at + 1 + 3 * i));
}

/** Writes an answer without an outcome. */
export function write_status(numbers, at, of_answer) {
  numbers.fill(0, at, at + answer_size);
  numbers[at] = of_answer;
}
