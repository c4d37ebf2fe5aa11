// SPDX-License-Identifier: BSL-1.0
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { gzipSync } from 'node:zlib';

import { PageInBrowser, page } from './page_in_browser.mjs';

let browser;
before(async () => { browser = await PageInBrowser.make(); });
after(() => browser.stop());

async function link_of(settings) {
  await browser.open(page);
  for (const [name, value] of Object.entries(settings)) {
    await browser.set(name, value);
  }
  await browser.click('copy');
  await browser.until('location.hash.length > 10');
  return browser.value('location.href');
}

test('a link restores the solver and the settings', async () => {
  const settings = {
    text: "// a ü\nexport function solve() {}\n", law: 'rough', precision: 'binary32', domain: 'games', cases: '7',
    seed: '18446744073709551615',
  };
  await browser.open(await link_of(settings));
  for (const [name, value] of Object.entries(settings)) {
    assert.equal(await browser.field(name), value, name);
  }
  assert.match(await browser.text('#state'), /It runs if you press Judge/);
});

test('a link runs nothing before Judge', async () => {
  await browser.open(await link_of({ text: 'for (;;) ;' }));
  await new Promise((go) => setTimeout(go, 5500));
  assert.equal(await browser.text('#verdict'), '', 'the page tells of an endless loop after 5 s');
  await browser.judge();
  assert.match(await browser.text('#verdict'), /did not finish/);
});

for (const fragment of ['#1.abc', '#2.abc', '#nonsense']) {
  test(`a damaged link is told: ${fragment}`, async () => {
    await browser.open(page + fragment);
    assert.match(await browser.text('#state'), /damaged/);
    assert.match(await browser.field('text'), /export function solve/);
  });
}

test('a solver that is too long for a link is told so', async () => {
  await browser.open(page);
  await browser.set('text', `// ${'x'.repeat(200_000)}`);
  await browser.click('copy');
  await browser.until('document.getElementById("copied").innerText !== ""');
  assert.match(await browser.text('#copied'), /too long for a link/);
  assert.equal(await browser.value('location.hash'), '');
});

test('the link to the editor changes nothing', async () => {
  await browser.open(page);
  await browser.set('text', 'mine');
  await browser.call(() => document.querySelector('.skip').click());
  await browser.until('location.hash === "#text"');
  await browser.frame();
  assert.equal(await browser.field('text'), 'mine');
  await browser.open(`${page}#text`);
  assert.match(await browser.text('#state'), /Press Judge/);
});

test('an example does not lose the text of the reader', async () => {
  await browser.open(page);
  await browser.set('text', 'mine');
  await browser.choose('Sound');
  assert.match(await browser.field('text'), /export function solve/);
  await browser.choose('your own');
  assert.equal(await browser.field('text'), 'mine');
  await browser.open(await link_of({ text: 'linked' }));
  assert.equal(await browser.field('text'), 'linked');
  await browser.set('text', 'mine again');
  await browser.open(await browser.value('location.href'));
  await browser.choose('your own');
  assert.equal(await browser.field('text'), 'mine again');
  await browser.choose('from the link');
  assert.equal(await browser.field('text'), 'linked');
});

test('another link on the open page is shown', async () => {
  const link = await link_of({ text: 'other' });
  await browser.open(page);
  await browser.go(new URL(link).hash);
  await browser.until('document.getElementById("text").value === "other"');
});

test('a link that unpacks to very much is damaged', async () => {
  const packed = (length) => gzipSync(JSON.stringify({ text: ' '.repeat(length) })).toString('base64url');
  const link_to = (length) => `${page}#1.${packed(length)}`;
  await browser.open(link_to(1000));
  assert.match(await browser.text('#state'), /It runs if you press Judge/);
  await browser.open(link_to(250_000));
  assert.match(await browser.text('#state'), /damaged/);
});
