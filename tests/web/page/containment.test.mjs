// SPDX-License-Identifier: BSL-1.0
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';

import { PageInBrowser, index_html, page } from './page_in_browser.mjs';

let browser;
before(async () => { browser = await PageInBrowser.make(); });
after(() => browser.stop());

/** A solver whose name tells which attempts succeeded. */
const intruder = (origin) => `
const got = [];
let tried = 0;
const attempt = async (name, run) => {
  ++tried;
  try { await run(); got.push(name); } catch {}
};
await attempt('fetch', () => fetch('${origin}/leak'));
await attempt('xhr', () => new Promise((go, fail) => {
  const request = new XMLHttpRequest();
  request.onload = go; request.onerror = fail; request.open('GET', '${origin}/leak'); request.send();
}));
await attempt('socket', () => new Promise((go, fail) => {
  const socket = new WebSocket('${origin.replace('http', 'ws')}/leak'); socket.onopen = go; socket.onerror = fail;
}));
await attempt('script', () => importScripts('${origin}/leak'));
await attempt('module', () => import('${origin}/leak'));
await attempt('parent', () => parent.document.title);
await attempt('localStorage', () => localStorage.length);
await attempt('indexedDB', () => indexedDB.open('x'));
await attempt('caches', () => caches.open('x'));
await attempt('eval', () => (0, eval)('1'));
await attempt('postMessage', () => postMessage({}));
export const name = JSON.stringify({ origin: self.origin, tried, got });
export const law = 'frictionless';
export function solve({ a, b }) { return { a, b }; }
`;

test('a solver has no network, no storage and an opaque origin, and the page asks for one file only', async () => {
  const asked = [];
  const server = createServer(({ url }, reply) => {
    asked.push(url);
    reply.setHeader('Access-Control-Allow-Origin', '*');
    reply.setHeader('Content-Type', url === '/' ? 'text/html' : 'text/javascript');
    reply.end(url === '/' ? readFileSync(index_html) : 'export const x = 1;');
  });
  await new Promise((go) => server.listen(0, '127.0.0.1', go));
  try {
    const origin = `http://127.0.0.1:${server.address().port}`;
    await browser.open(`${origin}/`);
    await browser.judge_text(intruder(origin));
    const [, said] = (await browser.text('#verdict')).match(/(\{.*\}): law/);
    assert.deepEqual(JSON.parse(said), { origin: 'null', tried: 11, got: [] });
    assert.deepEqual(asked, ['/']);
  } finally {
    server.closeAllConnections();
    server.close();
  }
});

test('the words of a solver are shown as text', async () => {
  await browser.open(page);
  const markup = JSON.stringify('<img src="x" onerror="hacked = 1"><script>hacked = 1</script>');
  const text = (await browser.sound()).replace("name = 'sound'", `name = ${markup}`)
    .replace('refuseInvalid(collision);', `throw new Error(${markup});`);
  assert.match(await browser.judge_text(text), /<img src="x"/);
  const found = await browser.call(() => document.images.length + document.querySelectorAll('main script').length);
  assert.equal(found, 0);
});

test('a saved report runs no script, and a witness can be saved', async () => {
  const folder = mkdtempSync(join(tmpdir(), 'carom-page-saved-'));
  try {
    await browser.ask('Browser.setDownloadBehavior', { behavior: 'allow', downloadPath: folder }, undefined);
    await browser.open(page);
    await browser.choose('Restitution threshold');
    await browser.judge();
    await browser.click('save-report');
    await browser.click('save-witness');
    const saved = () => readdirSync(folder).filter((name) => !name.endsWith('.crdownload'));
    for (let tries = 0; tries < 100 && saved().length < 2; ++tries) {
      await new Promise((go) => setTimeout(go, 50));
    }
    const witness = saved().find((name) => name.endsWith('.json'));
    assert.equal(JSON.parse(readFileSync(join(folder, witness), 'utf8')).invariant, 'restitution');
    const report = readFileSync(join(folder, 'report.html'), 'utf8');
    const [policy] = report.split('<html');
    assert.match(policy, /^<!DOCTYPE html><meta charset="utf-8"><meta http-equiv="Content-Security-Policy"/);
    assert.match(policy, /default-src 'none'; style-src 'unsafe-inline'/);
    assert.match(report, /Witnesses/);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
});
