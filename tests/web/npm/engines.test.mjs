// SPDX-License-Identifier: BSL-1.0
// Engines are judged by the package as by the native program, if CAROM_PROGRAM names it.
import assert from 'node:assert';
import { existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';

import { carom, gated, has_copied, installed, run, violated } from './installed.mjs';

const program = process.env.CAROM_PROGRAM;
const folder = installed();
const options = ['--cases', '4', '--relations-every', '1', '--families', 'generic,needle_tip,driven_wall,invalid'];

test('an absent engine is told', async () => {
  const { status, stderr } = await carom(folder, 'gate', 'oimo');
  assert.strictEqual(status, 2);
  assert.match(stderr, /oimophysics is not installed: npm install oimophysics/);
});

/** What two reports must agree on. The native program numbers a program that has the name of one of its subjects. */
function findings({ version, model, precision, families, violations = [] }) {
  return {
    version, model, precision,
    families: families.map(({ family, cases, invariants }) => ({ family, cases, invariants })),
    violations: violations.map(({ invariant, family, case: number }) => ({ invariant, family, case: number })),
  };
}

/**
 * The drawn collisions of the witnesses in a folder, with the answers, and the shrunk ones if `ends_fast`. On a busy
 * machine, an engine's program may take too long to end. The native program then stops shrinking.
 */
function witnesses(out, ends_fast) {
  const names = existsSync(out) ? readdirSync(out).sort() : [];
  return names.map((name) => {
    const { collision, outcome, drawn, drawn_outcome } = JSON.parse(readFileSync(join(out, name), 'utf8'));
    return { invariant: name.split('.').at(-2), drawn, drawn_outcome, ...(ends_fast ? { collision, outcome } : {}) };
  });
}

async function compare_with_native(solver, command, ends_fast) {
  const { subject } = await gated(folder, solver, ...options, '--out', 'package');
  const native = await run(
    folder, program, 'gate', `exec:${command}`, '--format', 'json', ...options, '--out', 'native');
  assert.notStrictEqual(native.stdout, '', native.stderr);
  assert.deepStrictEqual(findings(subject), findings(JSON.parse(native.stdout).subjects[0]));
  const [found, expected] = ['package', 'native'].map((out) => witnesses(join(folder, out, 'witnesses'), ends_fast));
  assert.deepStrictEqual(found, expected);
  return subject;
}

for (const [engine, name] of [['cannon', 'cannon-es'], ['rapier', '@dimforge/rapier3d-compat']]) {
  test(`${engine} is judged as by the native program`, async (t) => {
    if (!has_copied(folder, name)) {
      t.skip(`${name} is not installed`);
      return;
    }
    if (program === undefined) {
      const { status, subject } = await gated(folder, engine, ...options);
      assert.deepStrictEqual([status, subject.name], [1, engine]);
      return;
    }
    const adapter = join(folder, `node_modules/carom/engines/${engine}.mjs`);
    assert.ok(violated(await compare_with_native(engine, `node '${adapter}'`, false)).length > 0);
  });
}

test('a wrong solver is judged as by the native program', { skip: program === undefined }, async () => {
  writeFileSync(join(folder, 'served.mjs'), `import { createInterface } from 'node:readline';
    import { read_collision } from './node_modules/carom/engines/line_protocol.mjs';
    import solve, { law, name, version } from './wrong.mjs';
    for await (const line of createInterface({ input: process.stdin })) {
      const { cmd, id, collision } = JSON.parse(line);
      if (cmd === 'stop') break;
      let reply = { protocol: 1, name, version, precision: 'binary64', model: law };
      if (cmd === 'solve') {
        try {
          const { a, b } = solve(read_collision(collision));
          reply = { id, a, b };
        } catch (error) {
          reply = { id, error: error.message };
        }
      }
      const text = JSON.stringify(reply, (_, x) => (Object.is(x, -0) ? 'minus zero' : x));
      process.stdout.write(text.replaceAll('"minus zero"', '-0.0') + '\\n');
    }`);
  const subject = await compare_with_native('./wrong.mjs', 'node served.mjs', true);
  assert.ok(violated(subject).includes('restitution'));
});
