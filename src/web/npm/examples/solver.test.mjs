// SPDX-License-Identifier: BSL-1.0
// Run it by `node --test`.
import assert from 'node:assert';
import test from 'node:test';

import { assertSound, draw } from 'carom';

import { solve } from './solver.mjs';

test('the solver keeps all invariants of its law', async () => {
  await assertSound(solve, { law: 'frictionless' });
});

test('the module keeps them too, and every call ends in time', async () => {
  await assertSound(new URL('./solver.mjs', import.meta.url), { timeout: 1 });
});

test('bodies that separate keep their velocities', async () => {
  for (const collision of await draw({ family: 'separating', count: 100 })) {
    assert.deepStrictEqual(solve(collision).a.velocity, collision.a.velocity);
  }
});
