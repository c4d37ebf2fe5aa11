// SPDX-License-Identifier: BSL-1.0
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { PageInBrowser, page } from './page_in_browser.mjs';

let browser;
before(async () => { browser = await PageInBrowser.make(); });
after(() => browser.stop());

const at_start = 'refuseInvalid(collision);';  // of solve in the sound example

test('an endless loop is ended, and the page says on which collision', async () => {
  await browser.open(page);
  const said = await browser.judge_text((await browser.sound()).replace(at_start, `${at_start} for (;;) ;`));
  assert.match(said, /^solve did not return within 5 s/);
  assert.equal(await browser.text('#statement'), 'solve did not return on this collision.');
  assert.match(await browser.text('#steps'), /mass/);
});

test('a loop that begins late keeps the findings of the parts before', async () => {
  await browser.open(page);
  await browser.set('cases', '40');
  const text = (await browser.sound()).replace(at_start, `${at_start} while (++calls > 20000) ;`);
  const said = await browser.judge_text(`let calls = 0;\n${text}`);
  assert.match(said, /^solve did not return within 5 s[^]*So far: /);
  assert.ok(await browser.call(() => document.querySelectorAll('.invariants tbody tr').length) > 10);
  assert.equal(await browser.text('#statement'), 'solve did not return on this collision.');
});

test('an endless loop outside of solve is ended', async () => {
  await browser.open(page);
  assert.match(await browser.judge_text('for (;;) ;'), /The solver's text did not finish within 5 s/);
});

test('Escape ends a loop, and another Judge works', async () => {
  await browser.open(page);
  const text = await browser.sound();
  await browser.set('text', text.replace(at_start, 'for (;;) ;'));
  await browser.click('judge');
  await browser.until('document.getElementById("state").textContent.startsWith("Judging")');
  await browser.key('Escape');
  await browser.idle();
  assert.equal(await browser.text('#state'), 'Stopped before anything was judged.');
  assert.match(await browser.judge_text(text), /^Sound\. /);
});

test('Stop keeps the findings of the finished parts', async () => {
  await browser.open(page);
  await browser.set('cases', '1000');
  await browser.click('judge');
  await browser.until('document.getElementById("verdict").textContent.startsWith("So far")');
  await browser.click('stop');
  await browser.idle();
  assert.match(await browser.text('#verdict'), /^So far: /);
  await new Promise((go) => setTimeout(go, 300));  // what the ended worker told arrives
  assert.equal(await browser.text('#state'), '');
});

test('an error of the solver is told first, with its line', async () => {
  await browser.open(page);
  const said = await browser.judge_text('export function solve({ a, b }) {\n  return { a: dott(a), b };\n}');
  assert.match(said, /^solve threw an error: ReferenceError: dott is not defined\. Show line 2/);
});

test('a solver without a law is told what is not judged', async () => {
  await browser.open(page);
  assert.match(await browser.judge_text('export const solve = ({ a, b }) => ({ a, b });'), /Without a law/);
});

test('a wrong domain is told as such', async () => {
  await browser.open(page);
  await browser.set('domain', 'ranges');
  await browser.set('ranges', 'weight=1:2');
  await browser.judge();
  assert.match(await browser.text('#verdict'), /^The domain is wrong: 'weight=1:2' names no quantity/);
});

test('a solver that returns strings is told so', async () => {
  await browser.open(page);
  const answer = '{ a: { velocity: "fast", angular_velocity: [0, 0, 0] }, b }';
  assert.match(await browser.judge_text(`export function solve({ a, b }) { return ${answer}; }`),
    /\/a\/velocity: expected an array of 3 numbers, found "fast"/);
});

test('a solver that returns a promise is told so', async () => {
  await browser.open(page);
  const text = 'export async function solve({ a, b }) { return { a, b }; }';
  assert.match(await browser.judge_text(text), /returned a promise/);
});

test('a syntax error is told with its line', async () => {
  await browser.open(page);
  const said = await browser.judge_text('const one = 1;\nconst two = ;\nexport function solve() {}');
  assert.match(said, /not valid JavaScript: [^]*Show line 2/);
  await browser.call(() => document.querySelector('#verdict button').click());
  const selected = await browser.call(() => {
    const { value, selectionStart, selectionEnd } = document.activeElement;
    return value.slice(selectionStart, selectionEnd);
  });
  assert.equal(selected, 'const two = ;');
});

for (const [text, expected] of [
  ['\n\nunknown();\nexport function solve() {}', /unknown is not defined[^]*Show line 3/],
  ['\nexport function solve() { return unknown; }', /unknown is not defined[^]*Show line 2/],
  ['export const law = "rough";', /solve: expected a function/],
  ['import "https://example.com/x.mjs";\nexport function solve() {}', /cannot import/],
]) {
  test(`an error of the text is told: ${expected}`, async () => {
    await browser.open(page);
    assert.match(await browser.judge_text(text), expected);
  });
}

test('a mistake in the settings is told', async () => {
  await browser.open(page);
  await browser.set('domain', 'ranges');
  await browser.set('ranges', 'nonsense');
  await browser.judge();
  assert.match(await browser.text('#verdict'), /nonsense/);
});
