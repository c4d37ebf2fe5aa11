// SPDX-License-Identifier: BSL-1.0
import type { Arbitrary } from 'fast-check';

import type { Body, Collision, Domain, ImmovableBody, JudgeOptions, MovableBody, Solve } from './index.mjs';

export interface Drawn {
  /** The domain in which all collisions lie. */
  within?: Domain;
}

/** Valid collisions of all families, or of those with these names. */
export function collision(options?: Drawn & { families?: readonly string[] }): Arbitrary<Collision>;

/** Collisions of the family with this name. */
export function family(name: string, options?: Drawn): Arbitrary<Collision>;

/** An arbitrary for each family: `families.head_on()`. */
export const families: Record<string, (options?: Drawn) => Arbitrary<Collision>>;

/** The arbitraries whose collisions lie in the domain. */
export function within(domain: Domain): {
  collision(options?: { families?: readonly string[] }): Arbitrary<Collision>;
  family(name: string): Arbitrary<Collision>;
  families: Record<string, () => Arbitrary<Collision>>;
};

/** The collisions of an arbitrary with approaching bodies. All velocities are reversed if the bodies separate. */
export function approaching(collisions: Arbitrary<Collision>): Arbitrary<Collision>;

/** Movable bodies, at positions relative to the contact point. */
export function body(): Arbitrary<MovableBody>;

/** Immovable bodies at rest, at positions relative to the contact point. */
export function wall(): Arbitrary<ImmovableBody>;

/** The collisions of an arbitrary with other bodies. */
export function withBodies(
  collisions: Arbitrary<Collision>, a: Arbitrary<Body>, b: Arbitrary<Body>): Arbitrary<Collision>;

/** A predicate for `fc.property`: whether a solver keeps all invariants that it claims on a collision. */
export function holds(solve: Solve, options?: JudgeOptions): (collision: Collision) => true;
