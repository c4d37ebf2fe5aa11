// SPDX-License-Identifier: BSL-1.0
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { PageInBrowser, page } from './page_in_browser.mjs';

let browser;
before(async () => { browser = await PageInBrowser.make(); });
after(() => browser.stop());

// The examples, and some of the invariants that each violates.
const verdicts = {
  'Sound': [],
  "The note's method": ['reflection_plane', 'restitution', 'continuous'],
  'Restitution threshold': ['restitution', 'backward_error'],
  'Inertia in world axes': ['angular_momentum'],
  'Friction against the wrong slip': ['slip_opposed'],
};

test('the examples are those with known verdicts', async () => {
  await browser.open(page);
  assert.deepEqual(await browser.examples(), Object.keys(verdicts));
});

for (const [title, expected] of Object.entries(verdicts)) {
  test(`example: ${title}`, async () => {
    await browser.open(page);
    await browser.choose(title);
    await browser.judge();
    assert.match(await browser.text('#verdict'), expected.length > 0 ? /^Violated\. / : /^Sound\. /);
    const violated = await browser.violated();
    assert.deepEqual(expected.filter((name) => !violated.includes(name)), []);
    assert.equal(violated.length > 0, expected.length > 0);
    assert.equal(await browser.hidden('witness'), expected.length === 0);
    if (expected.length > 0) {
      assert.match(await browser.text('#wrong'), /look at/);
      assert.match(await browser.text('#steps'), /N·V⁻ = /, 'the witness is worked step by step');
      const drawn = await browser.call(() => document.querySelectorAll('#drawing svg').length);
      assert.equal(drawn, 2, 'the bodies, and the relative velocity');
    }
    assert.deepEqual(browser.errors, []);
  });
}

test('a witness of each violated invariant can be chosen', async () => {
  await browser.open(page);
  await browser.choose('Restitution threshold');
  await browser.judge();
  const titles = await browser.call(() => [...document.querySelectorAll('#which option')].map(({ text }) => text));
  assert.deepEqual([...titles].sort(), (await browser.violated()).sort());
  await browser.set('which', String(titles.indexOf('unit_scaling')));
  await browser.until('document.getElementById("statement").textContent.includes("units")');
});

test('a declared restitution threshold is sound within a domain of fast contacts', async () => {
  await browser.open(page);
  await browser.choose('Restitution threshold');
  const text = await browser.field('text');
  const declared = text.replace('// export const claims', 'export const claims');
  const domain = 'approach=0.5:'; // the verdict names it
  assert.match(await browser.judge_text(declared), new RegExp(`^Not judged\\. [^]*--within ${domain}`));
  await browser.set('domain', 'ranges');
  await browser.set('ranges', domain);
  assert.match(await browser.judge_text(declared), /^Sound\. /);
});

test('the law of the form comes before the law of the solver', async () => {
  await browser.open(page);
  await browser.set('law', 'reflection');
  await browser.judge();
  assert.match(await browser.text('#verdict'), /^Violated\. [^]*law reflection/);
  assert.match(await browser.text('#shell'), /law = 'reflection'/);
});

const some_ranges = 'size=0.1:10,speed=:5';
for (const [domain, ranges, within] of [['games', '', 'games'], ['ranges', some_ranges, some_ranges]]) {
  test(`the solver is judged within the domain ${within}`, async () => {
    await browser.open(page);
    await browser.set('domain', domain);
    await browser.set('ranges', ranges);
    await browser.judge();
    assert.match(await browser.text('#verdict'), /^Sound\. /);
    assert.ok((await browser.text('#shell')).endsWith(` --within ${within}`));
  });
}

test('more cases are judged on request', async () => {
  await browser.open(page);
  await browser.set('cases', '1');
  await browser.judge();
  assert.equal(await browser.hidden('more'), false);
  await browser.click('more');
  await browser.until('document.getElementById("state").textContent.startsWith("Judging")');
  assert.equal(await browser.field('cases'), '1');
  await browser.click('stop');
  await browser.idle();
});
