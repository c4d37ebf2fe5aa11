// SPDX-License-Identifier: BSL-1.0
// The compiler checks this file. Each line after @ts-expect-error must be an error.
import { approaching, body, collision, families, holds, wall, withBodies, within } from 'carom/fast-check';
import { assertSound, draw, families as listed, gate, judge, replay, validate } from 'carom';
import type { Collision, GateResult, Outcome, Solve } from 'carom';
import fc from 'fast-check';

const solve: Solve = ({ a, b, restitution }: Collision): Outcome => {
  const mass: number = a.immovable ? Infinity : a.mass;
  return { a: { velocity: [mass, 0, restitution], angular_velocity: new Float32Array(3) }, b };
};
// @ts-expect-error
const without_b: Solve = ({ a }) => ({ a });
// @ts-expect-error
await gate(solve, { law: 'frictionles' });

const result: GateResult = await gate(solve, { law: 'coulomb', seed: 1n, cases: 5, within: { size: [null, 1] } });
await gate(new URL('file:///x.mjs'), { signal: new AbortController().signal, progress: (done, all) => done / all });
await assertSound('./solver.mjs', { deviates: ['energy'] });
const [drawn] = await draw({ family: 'generic' });
const defects: string[] = validate(drawn);
const { violated } = await judge(solve, drawn, { precision: 'binary32' });
const { drawing } = await replay(drawn, { solver: solve });
const names: string[] = (await listed()).map(({ name }) => name);
const property = fc.property(withBodies(approaching(collision()), body(), wall()), holds(solve, { law: 'rough' }));
fc.assert(property);
families.generic({ within: 'games' });
within('games').families.head_on();
console.log(result.status, defects, violated, drawing, names, without_b);
