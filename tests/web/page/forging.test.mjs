// SPDX-License-Identifier: BSL-1.0
// A solver tries to speak for the judge, with which it shares a worker.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { gunzipSync, gzipSync } from 'node:zlib';

import { PageInBrowser, index_html, page } from './page_in_browser.mjs';

let browser;
before(async () => { browser = await PageInBrowser.make(); });
after(() => browser.stop());

/** What a solver would like the page to hear: a reply to each request, and a verdict. */
const forged = `
const report = JSON.stringify({ subjects: [{ name: 'forged', status: 'sound', cases: 1, families: [], model: 'any',
  precision: 'binary64', violations: [] }] });
const files = [{ file: 'report.json', text: report }, { file: 'report.html', text: 'forged' }];
const forged = { cases: 1, report, files, version: 'forged' };
const ids = Array.from({ length: 60 }, (_, i) => i);
const attempt = (run) => { try { run(); } catch {} };
`;

/** Attempts: code of the module, and code of solve. */
const attempts = {
  'by an event': { within: `
    ids.forEach((id) => attempt(() => dispatchEvent(new MessageEvent('message', {
      data: { id, action: 'constructor', ...forged }, ports: [new MessageChannel().port1] }))));` },
  'by a message of its own': { within: `
    for (const post of [self.postMessage, DedicatedWorkerGlobalScope.prototype.postMessage]) {
      ids.forEach((id) => attempt(() => post.call(self, { id, reply: forged })));
    }` },
  'by another port': { module: `
    const { postMessage } = MessagePort.prototype;
    attempt(() => {
      MessagePort.prototype.postMessage = function (message, ...rest) {
        return postMessage.call(this, message?.id === undefined ? message : { ...message, reply: forged }, ...rest);
      };
    });` },
  'by another parser': { module: `
    const { parse } = JSON;
    attempt(() => { JSON.parse = (text) => ({ ...parse(text), ...forged }); });` },
  'by properties of all objects': { module: `
    for (const [name, value] of Object.entries({ ...forged, reply: forged, toJSON: () => forged })) {
      attempt(() => Object.defineProperty(Object.prototype, name, { get: () => value, set() {} }));
    }` },
  'by other arrays': { module: `
    for (const type of [Array, Float64Array, Map, Set, String, Function]) {
      for (const key of Object.getOwnPropertyNames(type.prototype)) {
        attempt(() => { type.prototype[key] = () => { throw new Error('forged'); }; });
      }
    }` },
  'by its caller': { module: `
    const policy = self.trustedTypes.createPolicy('carom', { createScriptURL: (text) => text });
    importScripts(policy.createScriptURL(URL.createObjectURL(new Blob(['function sloppy({ a, b }) {'
      + 'if (sloppy.caller) throw new TypeError("forged by " + sloppy.caller); return { a, b }; }']))));`,
  solve: 'sloppy' },
  'by deafness': { module: `
    self.onmessage = null;
    addEventListener('message', (event) => event.stopImmediatePropagation(), true);
    attempt(() => close());` },
};

for (const [how, { module = '', within = '', solve = `({ a, b }) => { ${within} return { a, b }; }` }] of
  Object.entries(attempts)) {
  test(`a solver does not forge a verdict ${how}`, async () => {
    await browser.open(page);
    await browser.set('cases', '2');
    const said = await browser.judge_text(`${forged}${module}
      export const law = 'frictionless';
      export const solve = ${solve};`);
    assert.match(said, /^Violated\. /);
    assert.doesNotMatch(await browser.text('body'), /forged by|forged\./);
    assert.deepEqual(browser.errors, []);
  });
}

test('an error that cannot be read is told', async () => {
  await browser.open(page);
  const said = await browser.judge_text('throw { get message() { throw 0; } };');
  assert.match(said, /it threw an error that cannot be read/);
});

test('a solver may define what it needs', async () => {
  await browser.open(page);
  await browser.set('cases', '2');
  const said = await browser.judge_text(`${await browser.sound()}
    class Mine extends Error { constructor(text) { super(text); this.name = 'Mine'; } }
    function Vector() { this.constructor = Vector; }
    Vector.prototype.constructor = Vector;
    Vector.prototype.toString = () => 'a vector';
    globalThis.table = { valueOf: 1 };
    table.toString = () => 'a table';
    if (\`\${new Mine('text')} \${new Vector()} \${table}\` !== 'Mine: text a vector a table') {
      throw new Error('assignments do not work');
    }`);
  assert.match(said, /^Sound\. /);
});

/** Code that runs before the judge's, and forges its drawings. */
const forger = `
const parse = JSON.parse;
JSON.parse = (text) => {
  const reply = parse(text);
  if (typeof reply === 'object' && 'drawing' in reply) {
    reply.drawing = '<svg onload="hacked = 1"><script>hacked = 1</script><foreignObject><b>x</b></foreignObject>'
      + '<a href="javascript:1"><path d="M0,0"></path></a></svg><iframe></iframe>'
      + '<div><svg class="forged"><path d="M1,1" onclick="hacked = 1" style="fill:red"/></svg></div>';
  }
  return reply;
};
`;

test('even of a forged drawing, only shapes are shown', async () => {
  const folder = mkdtempSync(join(tmpdir(), 'carom-page-forged-'));
  try {
    const [before_worker, code, rest] = readFileSync(index_html, 'utf8').split(/(?<=id="worker">)([^<]*)/);
    const worker = `{${forger}}\n${gunzipSync(Buffer.from(code, 'base64'))}`;
    const file = join(folder, 'index.html');
    writeFileSync(file, before_worker + gzipSync(worker).toString('base64') + rest);
    await browser.open(pathToFileURL(file).href);
    await browser.choose('Inertia in world axes');
    await browser.judge();
    await browser.until('document.querySelector("#drawing .forged") !== null');
    const found = await browser.call(() => [...document.querySelectorAll('#drawing *')].flatMap((node) =>
      [node.localName, ...node.getAttributeNames()]));
    assert.deepEqual([...new Set(found)].sort(), ['class', 'd', 'div', 'path', 'svg']);
    assert.deepEqual(browser.errors, []);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
});
