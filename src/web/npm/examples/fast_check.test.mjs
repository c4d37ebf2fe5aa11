// SPDX-License-Identifier: BSL-1.0
// Run it by `node --test`, with fast-check installed.
import test from 'node:test';

import { approaching, body, collision, families, holds, wall, withBodies } from 'carom/fast-check';
import fc from 'fast-check';

import { solve } from './solver.mjs';

test('the solver keeps all invariants on collisions of every family', () => {
  fc.assert(fc.property(collision(), holds(solve, { law: 'frictionless' })));
});

test('a wall keeps its velocity', () => {
  fc.assert(fc.property(withBodies(approaching(families.generic()), body(), wall()), (c) => {
    const { b } = solve(c);
    return b.velocity.every((v, i) => v === c.b.velocity[i]);
  }));
});
