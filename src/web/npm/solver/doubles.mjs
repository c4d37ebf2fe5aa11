// SPDX-License-Identifier: BSL-1.0
// Collisions and answers as the judge's memory holds them: rows of doubles.

export const collision_size = 45;
export const answer_size = 23;
const body_size = 18;

/** Where an answer has its outcome, and 1 if a matrix follows. */
export const place_of_outcome = 1;
export const place_of_matrix = 13;

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

/** Writes an answer without an outcome. */
export function write_status(numbers, at, of_answer) {
  numbers.fill(0, at, at + answer_size);
  numbers[at] = of_answer;
}
