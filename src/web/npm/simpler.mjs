// SPDX-License-Identifier: BSL-1.0
import { exact_json } from './solver/exact_json.mjs';

const complexity = (value) => exact_json(value).length;

/** The collision with `value` in place of what stands at the path. */
function replaced(collision, [name, ...rest], value) {
  const inner = rest.length === 0 ? value : replaced(collision[name], rest, value);
  return Object.assign(Array.isArray(collision) ? [...collision] : { ...collision }, { [name]: inner });
}

const at = (collision, path) => path.reduce((value, name) => value[name], collision);

function simplest_values() {
  const of_body = (name) => [
    [[name, 'velocity'], [0, 0, 0]],
    [[name, 'angular_velocity'], [0, 0, 0]],
    [[name, 'orientation'], [1, 0, 0, 0]],
    [[name, 'principal_inertia'], [1, 1, 1]],
    [[name, 'mass'], 1],
  ];
  return [
    ...of_body('a'), ...of_body('b'),
    [['friction'], 0], [['tangential_restitution'], 0], [['restitution'], 1], [['restitution'], 0],
  ];
}

/** The same collision with its contact point at the origin. */
function moved_to_origin(collision) {
  const moved = (body) => ({ ...body, position: body.position.map((x, i) => x - collision.point[i]) });
  return { ...collision, a: moved(collision.a), b: moved(collision.b), point: [0, 0, 0] };
}

function* number_paths(value, path = []) {
  if (typeof value === 'number') {
    yield path;
  } else if (typeof value === 'object') {
    for (const name of Object.keys(value)) {
      yield* number_paths(value[name], [...path, Array.isArray(value) ? Number(name) : name]);
    }
  }
}

function* changed(collision) {
  yield moved_to_origin(collision);
  for (const [path, value] of simplest_values()) {
    if (at(collision, path) !== undefined) {
      yield replaced(collision, path, value);
    }
  }
  for (const path of number_paths(collision)) {
    const x = at(collision, path);
    for (const simple of [0, Math.sign(x), Math.round(x), Number(x.toPrecision(2)), Number(x.toPrecision(5))]) {
      yield replaced(collision, path, simple);
    }
  }
}

/** Simpler collisions, the boldest change first. Each has fewer characters, so shrinking ends. `defects` checks one. */
export function* simpler_collisions(collision, defects) {
  const longest = complexity(collision);
  for (const simple of changed(collision)) {
    if (complexity(simple) < longest && defects(simple).length === 0) {
      yield simple;
    }
  }
}
