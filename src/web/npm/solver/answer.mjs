// SPDX-License-Identifier: BSL-1.0
import { status, write_outcome, write_status } from './doubles.mjs';

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

function object(value, place) {
  expect(typeof value === 'object' && value !== null, place, 'expected an object', value);
  return value;
}

function three_numbers(value, place) {
  const is_array = Array.isArray(value) || value instanceof Float64Array || value instanceof Float32Array;
  expect(is_array && value.length === 3, place, 'expected an array of 3 numbers', value);
  for (let i = 0; i < 3; ++i) {
    expect(typeof value[i] === 'number', `${place.slice(0, -2)}/${i}: `, 'expected a number', value[i]);
  }
  return value;
}

function motion(result, name) {
  const body = object(result[name], `/${name}: `);
  return {
    velocity: three_numbers(body.velocity, `/${name}/velocity: `),
    angular_velocity: three_numbers(body.angular_velocity, `/${name}/angular_velocity: `),
  };
}

function matrix(C) {
  expect(Array.isArray(C) && C.length === 3, '/C: ', 'expected an array of 3 rows', C);
  return C.map((row, i) => three_numbers(row, `/C/${i}: `));
}

function printable(text) {
  return text.length > longest_text ? `${text.slice(0, longest_text)}…` : text;
}

/** The message of anything that was thrown. */
export function message_of(thrown) {
  try {
    return printable(thrown instanceof Error ? thrown.message || thrown.name : String(thrown));
  } catch {
    return 'threw a value that cannot be shown';
  }
}

function write_checked(numbers, at, result, has_matrix) {
  expect(typeof result === 'object' && result !== null, '', 'expected an object { a, b }', result);
  if ('skipped' in result) {
    expect(typeof result.skipped === 'string', '/skipped: ', 'expected a string', result.skipped);
    expect(!('a' in result || 'b' in result), '', 'expected either the outcome a and b, or skipped', result);
    write_status(numbers, at, status.skipped);
    return printable(result.skipped);
  }
  const outcome = { a: motion(result, 'a'), b: motion(result, 'b') };
  if (has_matrix && result.C !== undefined) {
    outcome.C = matrix(result.C);
  }
  write_outcome(numbers, at, outcome);
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
