// SPDX-License-Identifier: BSL-1.0
import { unit } from '../posing.mjs';

/** Throws an error that names the field, unless the condition holds. */
function expect(holds, field, expected, found) {
  if (!holds) {
    throw new Error(`${field}: expected ${expected}, found ${JSON.stringify(found)}`);
  }
}

function number(json, field, is_valid = () => true, expected = 'a finite number') {
  expect(Number.isFinite(json) && is_valid(json), field, expected, json);
  return json;
}

const positive = (json, field) => number(json, field, (x) => x > 0, 'a finite number greater than 0');

function vector(json, field, count = 3) {
  const is_valid = Array.isArray(json) && json.length === count && json.every(Number.isFinite);
  expect(is_valid, field, `${count} finite numbers`, json);
  return json;
}

function direction(json, field, count) {
  const v = vector(json, field, count);
  expect(v.some((x) => x !== 0), field, 'a nonzero length', json);
  return unit(v);
}

const shapes = {
  sphere: positive,
  box: (json, field) => vector(json, field).map((x, i) => positive(x, `${field}[${i}]`)),
  half_space: (json, field) => direction(json, field, 3),
};

// A fixed body may leave out its mass and its velocities.
function read_body(json, field) {
  expect(json !== null && typeof json === 'object', field, 'an object', json);
  const names = Object.keys(shapes).filter((name) => name in json);
  expect(names.length === 1, field, 'one of sphere, box, half_space', names);
  const [shape] = names;
  const body = {
    shape,
    fixed: json.fixed === true,
    [shape]: shapes[shape](json[shape], `${field}.${shape}`),
    position: vector(json.position, `${field}.position`),
    orientation: direction(json.orientation ?? [1, 0, 0, 0], `${field}.orientation`, 4),  // w, x, y, z
  };
  expect(body.fixed || shape !== 'half_space', `${field}.fixed`, 'true for a half_space', json.fixed);
  for (const name of ['velocity', 'angular_velocity']) {
    body[name] = vector(body.fixed ? json[name] ?? [0, 0, 0] : json[name], `${field}.${name}`);
    expect(!body.fixed || body[name].every((x) => x === 0), `${field}.${name}`, '0 for a fixed body', json[name]);
  }
  if (!body.fixed) {
    body.mass = positive(json.mass, `${field}.mass`);
    body.principal_inertia = vector(json.principal_inertia, `${field}.principal_inertia`)
      .map((x, i) => positive(x, `${field}.principal_inertia[${i}]`));
  }
  return body;
}

function read_scene(json) {
  expect(json !== null && typeof json === 'object', 'scene', 'an object', json);
  expect(Array.isArray(json.bodies) && json.bodies.length > 0, 'scene.bodies', 'a list of bodies', json.bodies);
  expect([undefined, true, false].includes(json.continuous), 'scene.continuous', 'true or false', json.continuous);
  return {
    gravity: vector(json.gravity, 'scene.gravity'),
    restitution: number(json.restitution, 'scene.restitution', (x) => x >= 0 && x <= 1, 'a number from 0 to 1'),
    friction: number(json.friction, 'scene.friction', (x) => x >= 0, 'a finite number of at least 0'),
    continuous: json.continuous === true,
    bodies: json.bodies.map((body, i) => read_body(body, `scene.bodies[${i}]`)),
  };
}

/** The request `run`. Without a scene, the run continues the last one. Throws an error that names the wrong field. */
export function read_run({ step, steps, report, scene }) {
  const is_count = (n) => Number.isInteger(n) && n >= 0;
  expect(is_count(steps), 'steps', 'an integer of at least 0', steps);
  const is_next = (n, i) => is_count(n) && n <= steps && (i === 0 || n > report[i - 1]);
  const is_report = Array.isArray(report) && report.length > 0 && report.every(is_next);
  expect(is_report, 'report', `ascending integers from 0 to ${steps}`, report);
  return { step: positive(step, 'step'), steps, report, scene: scene === undefined ? undefined : read_scene(scene) };
}

/** Whether the scene lives in the plane z = 0: nothing in it moves, points or turns out of the plane. */
export function is_planar({ gravity, bodies }) {
  const out_of_plane = ({ half_space = [0, 0, 0], position, orientation, velocity, angular_velocity }) =>
    [half_space[2], position[2], velocity[2], ...orientation.slice(1, 3), ...angular_velocity.slice(0, 2)];
  return [gravity[2], ...bodies.flatMap(out_of_plane)].every((x) => x === 0);
}
