// SPDX-License-Identifier: BSL-1.0
import assert from 'node:assert';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { pathToFileURL } from 'node:url';

import { has_installed, imported, installed, run, violated } from './installed.mjs';

const folder = installed();
const carom = await imported(folder, 'index.mjs');
const { solve: sound } = await import(pathToFileURL(join(folder, 'sound.mjs')).href);
const { default: wrong } = await import(pathToFileURL(join(folder, 'wrong.mjs')).href);
const law = 'frictionless';

test('a function is judged as its module is', async () => {
  const options = { cases: 4, seed: 3n, families: ['generic', 'invalid'] };
  const { status, report } = await carom.gate(wrong, { law, ...options });
  const of_module = await carom.gate(join(folder, 'wrong.mjs'), options);
  assert.deepStrictEqual([status, of_module.status], [1, 1]);
  const compared = ({ subjects: [{ violations, families }] }) => ({
    invariants: violations.map(({ invariant }) => invariant), families,
  });
  assert.deepStrictEqual(compared(report), compared(of_module.report));
});

test('options replace the claims of a module', async () => {
  const { report } = await carom.gate(join(folder, 'sound.mjs'), { law: 'any', name: 'renamed', cases: 5 });
  assert.deepStrictEqual([report.subjects[0].name, report.subjects[0].model], ['renamed', 'any']);
});

test('a function that returns a promise is told what to do', async () => {
  const { status, report, files } = await carom.gate(async (c) => sound(c), { law, cases: 5, families: ['generic'] });
  assert.notStrictEqual(status, 0);
  assert.match(JSON.stringify([report, files]), /returned a promise; give the path of its module/);
});

test('assertSound', async () => {
  await carom.assertSound(sound, { law });
  await assert.rejects(carom.assertSound(wrong, { law, cases: 4, families: 'generic' }), (error) => {
    assert.strictEqual(error.name, 'AssertionError');
    assert.match(error.message, /^solve violates [a-z_, ]*restitution/);
    assert.match(error.message, /contact at \(.*\), normal \(.*\), restitution/);
    assert.match(error.message, /N·V⁺ and −ε N·V⁻/);
    assert.ok(violated(error.report.subjects[0]).includes('restitution'));
    return true;
  });
});

test('mistakes are told', async () => {
  await assert.rejects(carom.gate(sound, { law, case: 5 }), /there is no option 'case'; did you mean 'cases'\?/);
  await assert.rejects(carom.gate(sound, { law: 'frictionles' }), /frictionles/);
  await assert.rejects(carom.gate(sound, { law, cases: 0.5 }), /cases: expected an integer/);
  await assert.rejects(carom.gate(sound, { law, families: ['generics'] }), { name: 'UsageError' });
});

for (const [mistake, message] of [
  [() => carom.gate(undefined), /expected a function, .* of a module, or the name of an engine, found undefined/],
  [() => carom.gate(new URL('https://example.org/solver.mjs')), /found https:\/\/example\.org\/solver\.mjs/],
  [() => carom.gate(sound, { law, families: [] }), /families: expected at least one name/],
  [() => carom.gate(sound, { law, exact: 'toString' }), /exact: expected true or false/],
  [() => carom.gate(sound, { law, within: { size: [1] } }), /^within: size: expected the least/],
  [() => carom.gate(sound, { law, within: { plane: 'xz' } }), /^within: plane: expected one of xy, yz, zx/],
  [() => carom.gate(sound, { law, within: 'mass=1:1,mass_ratio=2:3' }), /^within: no case of generic lies/],
  [() => carom.gate('./a\0b'), /there is no such file/],
  [() => carom.gate(`./${'x'.repeat(5000)}`), /there is no such file/],
  [() => carom.gate(sound, { law, exact: 'yes' }), /exact: expected true or false, found yes/],
  [() => carom.gate(sound, { law, signal: 5 }), /signal: expected an AbortSignal, found 5/],
  [() => carom.gate(sound, { law, progress: 'line' }), /progress: expected a function, found "line"/],
  [() => carom.gate(sound, { law, domain: 'gamess' }), /^domain: .*games.*; did you mean 'games'\?/],
  [() => carom.gate(sound, { law, within: '0x1=2' }), /^within: .*names no quantity/],
  [() => carom.gate(sound, { law, within: 'size=0x1p-2:1' }), /^within: .*0x1p-2/],
  [() => carom.judge(sound, undefined, { law }), /the collision: expected an object, found undefined/],
  [() => carom.judge(sound, {}, { law, cases: 5 }), /there is no option 'cases'/],
  [() => carom.replay('{'), /the record: /],
  [() => carom.draw({ family: 5 }), /family: there is no family '5'/],
  [() => carom.draw({ count: -1 }), /count: expected an integer from 1/],
  [() => carom.draw({ famly: 'generic' }), /there is no option 'famly'; did you mean 'family'\?/],
]) {
  test(`a mistake is told: ${message}`, () => assert.rejects(mistake, (error) => {
    assert.strictEqual(error.name, 'UsageError');
    assert.match(error.message, message);
    return true;
  }));
}

test('an option that is undefined or null counts as absent', async () => {
  assert.strictEqual((await carom.draw({ family: undefined, count: undefined })).length, 1);
  const { status } = await carom.gate(sound, { law, cases: 4, families: undefined, signal: null, progress: null });
  assert.strictEqual(status, 0);
});

test('vectors may be typed arrays', async () => {
  const [collision] = await carom.draw();
  assert.deepStrictEqual(carom.validate({ ...collision, normal: Float64Array.from(collision.normal) }), []);
});

test('what is no collision has defects', () => {
  for (const value of [undefined, null, 5, {}, { a: null, b: 5 }, { a: { velocity: 'fast' } }]) {
    assert.ok(carom.validate(value).includes('restitution: expected a finite number from 0 to 1'));
  }
});

test('an error of progress ends the run, and belongs to the caller', async () => {
  for (const solver of [sound, join(folder, 'sound.mjs')]) {
    let calls = 0;
    const controller = new AbortController();
    const progress = () => {
      ++calls;
      controller.abort();
      throw new RangeError('planted');
    };
    const { signal } = controller;
    await assert.rejects(carom.gate(solver, { law, progress, signal, cases: 20 }), { message: 'planted' });
    assert.strictEqual(calls, 1);
  }
});

test('one collision is judged within a domain that no family fits', async () => {
  const [collision] = await carom.draw();
  const { violated: is_violated } = await carom.judge(sound, collision, { law, domain: 'mass=1:1,mass_ratio=2:3' });
  assert.strictEqual(is_violated, false);
});

test('collisions are drawn into a kind', async () => {
  for (const { point, a, b } of await carom.draw({ family: 'structured', count: 20, within: { plane: 'xy' } })) {
    assert.deepStrictEqual([point[2], a.velocity[2], b.velocity[2]].map(Math.abs), [0, 0, 0]);
  }
});

test('names that are near to a claim are not refused', async () => {
  for (const name of ['low', 'raw', 'laws', 'names', 'same', 'clamps']) {
    const text = `export { solve } from './sound.mjs'; export const law = 'frictionless', ${name} = [];`;
    writeFileSync(join(folder, `${name}.mjs`), text);
    assert.strictEqual((await carom.gate(join(folder, `${name}.mjs`), { cases: 4 })).status, 0);
  }
});

test('a half of a letter in a name or a reason is replaced', async () => {
  const refusing = () => { throw new Error('half \ud800 a letter'); };
  const { report, files } = await carom.gate(refusing, { law, name: 'half \udc00', cases: 2, families: 'generic' });
  assert.strictEqual(report.subjects[0].name, 'half \ufffd');
  assert.match(JSON.stringify(files), /half \ufffd a letter/);
});

test('a signal ends a run', async () => {
  const signal = AbortSignal.abort();
  const { status, report } = await carom.gate(sound, { law, signal });
  assert.deepStrictEqual([status, report.interrupted], [2, true]);
});

test('the cases are drawn as the gate draws them', async () => {
  const [first, second] = await carom.draw({ family: 'elastic', seed: 5, count: 2 });
  assert.strictEqual(first.restitution, 1);
  assert.deepStrictEqual(await carom.draw({ family: 'elastic', seed: 5, first: 1 }), [second]);
  const invalid = await carom.draw({ family: 'invalid', count: 50 });
  assert.ok(invalid.every((collision) => carom.validate(collision).length > 0));
  assert.ok(invalid.some((collision) => JSON.stringify(collision).includes('null')));  // NaN or an infinity
});

test('one collision is judged, and worked step by step', async () => {
  const [collision] = await carom.draw({ family: 'elastic', seed: 5 });
  collision.restitution = 0.5;
  const { violated: is_violated, verdicts } = await carom.judge(wrong, collision, { law });
  assert.ok(is_violated);
  assert.strictEqual(verdicts.restitution.status, 'violated');
  assert.strictEqual((await carom.judge(sound, collision, { law })).violated, false);
  const { text, drawing } = await carom.replay(collision, { solver: sound, law });
  assert.match(text, /frictionless, exactly/);
  assert.match(drawing, /<svg/);
});

test('−0 keeps its sign on the way to the judge', async () => {
  const [collision] = await carom.draw({ family: 'generic' });
  collision.a.velocity = [-0, 1, 2];
  let seen;
  await carom.judge((c) => { seen ??= c; return sound(c); }, collision, { law });
  assert.ok(Object.is(seen.a.velocity[0], -0));
});

test('the examples pass', async () => {
  const examples = join(folder, 'node_modules/carom/examples');
  const { status, stdout } = await run(folder, process.execPath, '--test', join(examples, 'solver.test.mjs'));
  assert.strictEqual(status, 0, stdout);
  assert.match(stdout, /pass 3/);
});

test('the types fit', async (t) => {
  if (!has_installed(folder, 'typescript', 'fast-check')) {
    t.skip('typescript cannot be installed');
    return;
  }
  const { status, stdout } = await run(folder, process.execPath, 'node_modules/typescript/bin/tsc', '--strict',
    '--noEmit', '--module', 'nodenext', '--target', 'es2022', 'types.mts');
  assert.strictEqual(status, 0, stdout);
});
