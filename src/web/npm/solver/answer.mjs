// SPDX-License-Identifier: BSL-1.0
import { place_of_matrix, place_of_outcome, status, write_status } from './doubles.mjs';
import { well_formed } from './exact_json.mjs';

const longest_text = 2000;

/** Says why a solver's result is no answer. */
export class InvalidAnswer extends Error {}

export function is_promise(result) {
  return typeof result?.then === 'function';
}

/** A short description of any value. */
export function shown(value) {
  const type = typeof value;
  if (type === 'string') {
    return JSON.stringify(value.length > 60 ? `${value.slice(0, 60)}…` : value);
  }
  if (Array.isArray(value) || ArrayBuffer.isView(value)) {
    return `an array of ${value.length}`;
  }
  return type === 'object' && value !== null ? 'an object' : type === 'function' ? 'a function' : String(value);
}

function expect(holds, place, expected, value) {
  if (!holds) {
    throw new InvalidAnswer(`returned an invalid answer: ${place}${expected}, found ${shown(value)}`);
  }
}

/** Writes three numbers. `place` names the vector. */
function write_vector(numbers, at, value, place) {
  const is_array = Array.isArray(value) || value instanceof Float64Array || value instanceof Float32Array;
  expect(is_array && value.length === 3, place, ': expected an array of 3 numbers', value);
  for (let i = 0; i < 3; ++i) {
    const x = value[i];
    if (typeof x !== 'number') {
      expect(false, `${place}/${i}`, ': expected a number', x);
    }
    numbers[at + i] = x;
  }
}

const motions = ['a', 'b'].map((name) => ({
  name, place: `/${name}`, velocity: `/${name}/velocity`, angular_velocity: `/${name}/angular_velocity`,
}));

function write_outcome(numbers, at, result) {
  numbers[at] = status.outcome;
  let to = at + place_of_outcome;
  for (const { name, place, velocity, angular_velocity } of motions) {
    const body = result[name];
    expect(typeof body === 'object' && body !== null, place, ': expected an object', body);
    write_vector(numbers, to, body.velocity, velocity);
    write_vector(numbers, to + 3, body.angular_velocity, angular_velocity);
    to += 6;
  }
}

function write_matrix(numbers, at, C) {
  expect(Array.isArray(C) && C.length === 3, '/C', ': expected an array of 3 rows', C);
  for (let i = 0; i < 3; ++i) {
    write_vector(numbers, at + 3 * i, C[i], `/C/${i}`);
  }
}

function printable(text) {
  return well_formed(text.length > longest_text ? `${text.slice(0, longest_text)}…` : text);
}

/** The message of an Error, after its kind if that tells something. */
function words_of({ name, message }) {
  return [name, message].filter((text) => text && text !== 'Error').join(': ') || 'Error';
}

/** The message of anything that was thrown. */
export function message_of(thrown) {
  try {
    return printable(thrown instanceof Error ? words_of(thrown) : String(thrown));
  } catch {
    return 'threw a value that cannot be shown';
  }
}

function write_checked(numbers, at, result, has_matrix) {
  expect(typeof result === 'object' && result !== null, '', 'expected an object { a, b }', result);
  if ('skipped' in result) {
    expect(typeof result.skipped === 'string', '/skipped', ': expected a string', result.skipped);
    expect(!('a' in result || 'b' in result), '', 'expected either the outcome a and b, or skipped', result);
    write_status(numbers, at, status.skipped);
    return printable(result.skipped);
  }
  write_outcome(numbers, at, result);
  const shows_matrix = has_matrix && result.C !== undefined;
  numbers[at + place_of_matrix] = shows_matrix ? 1 : 0;
  if (shows_matrix) {
    write_matrix(numbers, at + place_of_matrix + 1, result.C);
  }
  return '';
}

/**
 * Writes what a solver returned. Returns the reason of a skip, or an empty text. Throws InvalidAnswer if the result is
 * neither an outcome nor a skip.
 */
export function write_result(numbers, at, result, has_matrix) {
  try {
    return write_checked(numbers, at, result, has_matrix);
  } catch (error) {
    if (error instanceof InvalidAnswer) {
      throw error;
    }
    throw new InvalidAnswer(`returned an invalid answer: reading it throws ${message_of(error)}`);
  }
}

/** Writes a refusal: a solver refuses a collision by throwing. Returns the reason. */
export function write_refusal(numbers, at, thrown) {
  write_status(numbers, at, status.refused);
  return message_of(thrown);
}
