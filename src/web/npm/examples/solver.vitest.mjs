// SPDX-License-Identifier: BSL-1.0
// Run it by `npx vitest run`.
import { expect, test } from 'vitest';

import { assertSound, gate } from 'carom';

import { solve } from './solver.mjs';

test('the solver keeps all invariants of its law', async () => {
  await assertSound(solve, { law: 'frictionless' });
}, 60_000);

test('it is sound for games to three digits', async () => {
  const { status } = await gate(solve, { law: 'frictionless', within: 'games', digits: 3, cases: 100 });
  expect(status).toBe(0);
}, 60_000);
