// SPDX-License-Identifier: BSL-1.0
import { AssertionError } from 'node:assert';

import fc from 'fast-check';

import { read_collision } from './engines/line_protocol.mjs';
import { judge_options, sorted_options } from './options.mjs';
import { domain_text, introduce } from './solver/introduction.mjs';
import { UsageError } from './solver/judge.mjs';
import { local_session } from './solver/local_session.mjs';
import { did_you_mean } from './solver/nearest_name.mjs';
import { this_judge } from './threads/node_judge.mjs';

const judge = await this_judge();
const all_names = judge({ cmd: 'list', what: 'families' })
  .filter(({ beyond_domain }) => !beyond_domain).map(({ name }) => name);
const valid_names = all_names.filter((name) => name !== 'invalid');
const greatest_seed = 2 ** 31 - 1;
const whole_size = 50;  // from this size on, the whole distribution of a family is drawn
const most_simpler = 1000;

/** Draws collisions of one of the families, and shrinks them within their family and domain. */
class Collisions extends fc.Arbitrary {
  constructor(names, within) {
    super();
    Object.assign(this, { names, within: domain_text(within) });
  }

  generate(random, bias) {
    const family = this.names[random.nextInt(0, this.names.length - 1)];
    const is_simple = bias !== undefined && random.nextInt(1, bias) === 1;
    const size = is_simple ? random.nextInt(0, whole_size - 1) : whole_size;
    const seed = String(random.nextInt(0, greatest_seed));
    return this.value_of({ ...judge({ cmd: 'chosen', family, within: this.within, seed, size }), place: 0 }, family);
  }

  value_of({ collision: json, choices, place }, family) {
    return new fc.Value(read_collision(json), { family, choices, place });
  }

  canShrinkWithoutContext() {
    return false;
  }

  /** Begins at the change that succeeded last, because the changes before it failed. */
  shrink(_, { family, choices, place }) {
    const request = { cmd: 'simpler', family, within: this.within, choices, first: place, most: most_simpler };
    return new fc.Stream(judge(request).cases[Symbol.iterator]()).map((one) => this.value_of(one, family));
  }
}

/** Collisions of the family with this name. */
export function family(name, { within } = {}) {
  if (!all_names.includes(name)) {
    throw new UsageError(`there is no family '${name}'${did_you_mean(name, all_names)}`);
  }
  return new Collisions([name], within);
}

/** Valid collisions of all families, or of those with these names. */
export function collision({ families: names = valid_names, within } = {}) {
  names.forEach((name) => family(name));
  return new Collisions(names, within);
}

/** An arbitrary for each family: `families.head_on()`. */
export const families = Object.fromEntries(all_names.map((name) => [name, (options) => family(name, options)]));

/** The arbitraries whose collisions lie in the domain. */
export function within(domain) {
  return {
    collision: (options) => collision({ ...options, within: domain }),
    family: (name) => family(name, { within: domain }),
    families: Object.fromEntries(all_names.map((name) => [name, () => family(name, { within: domain })])),
  };
}

function normal_velocity({ a, b, point, normal }) {
  const velocity_at_point = ({ position, velocity, angular_velocity: w }) => {
    const r = point.map((x, i) => x - position[i]);
    return velocity.map((x, i) => x + w[(i + 1) % 3] * r[(i + 2) % 3] - w[(i + 2) % 3] * r[(i + 1) % 3]);
  };
  const of_b = velocity_at_point(b);
  return velocity_at_point(a).reduce((sum, x, i) => sum + normal[i] * (x - of_b[i]), 0);
}

function reversed(collision) {
  const back = (body) => ({
    ...body,
    velocity: body.velocity.map((x) => -x),
    angular_velocity: body.angular_velocity.map((x) => -x),
  });
  return { ...collision, a: back(collision.a), b: back(collision.b) };
}

/** The collisions of an arbitrary with approaching bodies. All velocities are reversed if the bodies separate. */
export function approaching(collisions) {
  return collisions.map((one) => (normal_velocity(one) > 0 ? reversed(one) : one))
    .filter((one) => normal_velocity(one) < 0);
}

function relative_to_point({ a, point }) {
  return { ...a, position: a.position.map((x, i) => x - point[i]) };
}

/** Movable bodies, at positions relative to the contact point. */
export const body = () => family('generic').map(relative_to_point);

/** Immovable bodies at rest, at positions relative to the contact point. */
export const wall = () => family('generic').map((one) => ({
  immovable: true, position: relative_to_point(one).position, velocity: [0, 0, 0], angular_velocity: [0, 0, 0],
}));

/** The collisions of an arbitrary with other bodies. */
export function withBodies(collisions, a, b) {
  return fc.tuple(collisions, a, b).map(([one, ...bodies]) => {
    const [at_a, at_b] = bodies.map((made) => ({ ...made, position: made.position.map((x, i) => x + one.point[i]) }));
    return { ...one, a: at_a, b: at_b };
  });
}

/**
 * A predicate for `fc.property`: whether a solver keeps all invariants that it claims on a collision. If it does not,
 * the predicate throws an error with the violated invariants.
 */
export function holds(solve, options = {}) {
  const { request, claimed } = sorted_options(options, judge_options);
  const { introduction } = introduce({ ...claimed, solve }, solve.name || 'solve');
  const session = local_session(solve, introduction);
  return (one) => {
    Object.assign(judge, { session, progress: undefined });
    const asked = { subject: introduction, options: request, collision: one };
    if (judge({ cmd: 'judge', ...asked }).violated) {
      const { text } = judge({ cmd: 'replay', place: 'collision', ...asked });
      throw new AssertionError({ message: text, stackStartFn: holds });
    }
    return true;
  };
}
