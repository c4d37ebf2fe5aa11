// SPDX-License-Identifier: BSL-1.0
// Solvers that fail at the first collision with a friction above 1/2.
import assert from 'node:assert';
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';

import { gated, installed, violated } from './installed.mjs';

const folder = installed();
const options = ['--cases', '10', '--families', 'generic,head_on', '--timeout', '0.3', '--jobs', '1', '--deviates',
  'invalid_refused,separating_untouched,immovable_untouched,collinear_spin'];

async function judged(word) {
  writeFileSync(join(folder, `${word}.mjs`),
    `import { failing } from './failing.mjs'; export const law = 'frictionless', solve = failing('${word}');`);
  const result = await gated(folder, `./${word}.mjs`, ...options, '--out', word);
  const names = readdirSync(join(folder, word, 'witnesses'));
  const witnesses = names.map((name) => JSON.parse(readFileSync(join(folder, word, 'witnesses', name), 'utf8')));
  const texts = witnesses.flatMap(({ outcome, drawn_outcome }) => [outcome, drawn_outcome]).map((one) =>
    one.failed ?? one.refused ?? one.error ?? JSON.stringify(one));
  return { ...result, witnesses, texts };
}

for (const [word, message] of [
  ['hang', /did not return within 0\.3 s/],
  ['promise', /did not return within 0\.3 s/],
  ['exit', /ended with status 3/],
  ['exit_later', /ended with status 4/],
  ['late', /was ended by an error outside of solve: TypeError: planted/],
  ['strings', /returned an invalid answer: \/a\/velocity\/0: expected a number, found "0"/],
  ['short', /returned an invalid answer: \/a\/velocity: expected an array of 3 numbers, found an array of 2/],
  ['nothing', /returned an invalid answer: expected an object \{ a, b \}, found undefined/],
]) {
  test(`a failure belongs to its collision: ${word}`, async () => {
    const { status, stdout, witnesses, texts } = await judged(word);
    assert.strictEqual(status, 1);
    assert.ok(texts.length > 0);
    texts.forEach((text) => assert.match(text, message));
    assert.doesNotMatch(stdout, /standard error/);
    for (const { drawn, collision } of witnesses) {
      assert.ok((drawn.friction ?? 0) > 0.5 && (collision.friction ?? 0) > 0.5);
    }
  });
}

test('throwing refuses a collision, which is wrong for a valid one', async () => {
  const { status, texts, subject } = await judged('refuse');
  assert.strictEqual(status, 1);
  assert.ok(violated(subject).length > 0);
  assert.match(texts[0], /not today/);
});

test('a skip is counted, and is no violation', async () => {
  const { subject } = await judged('skip');
  assert.deepStrictEqual(violated(subject), []);
  assert.ok(subject.families.some(({ skipped }) => skipped > 0));
});

test('a solver may wait and print', async () => {
  writeFileSync(join(folder, 'waiting.mjs'), `import { solve as sound } from './sound.mjs';
    export const law = 'frictionless';
    export async function solve(collision) {
      console.log('printed by the solver');
      await undefined;
      return sound(collision);
    }`);
  const { status, stderr } = await gated(folder, './waiting.mjs', ...options);
  assert.strictEqual(status, 0);
  assert.match(stderr, /printed by the solver/);
});
