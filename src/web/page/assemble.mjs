// SPDX-License-Identifier: BSL-1.0
// node assemble.mjs OUTPUT CAROM_JUDGE_JS CAROM_JUDGE_WASM [DOCS] writes OUTPUT/index.html, the page in one file.
// DOCS is the address of the folder docs/, with a slash at its end. Without it, the page has no links to the docs.
import { createHash } from 'node:crypto';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

import { buildSync } from 'esbuild';

const examples = ['sound', 'note', 'restitution_threshold', 'world_axes', 'wrong_slip'];
const [output, judge, wasm, docs = ''] = process.argv.slice(2);
if (!wasm) {
  console.error('usage: node assemble.mjs OUTPUT CAROM_JUDGE_JS CAROM_JUDGE_WASM [DOCS]');
  process.exit(2);
}

const here = (name) => fileURLToPath(new URL(name, import.meta.url));
const read = (name) => readFileSync(here(name), 'utf8');

function bundled(entry) {
  const { outputFiles } = buildSync({
    entryPoints: [here(entry)], bundle: true, minify: true, charset: 'utf8', target: ['es2022'], format: 'iife',
    legalComments: 'none', write: false,
  });
  return outputFiles[0].text.trim();
}

/** The style of Carom's reports, and what the page adds. */
function style() {
  return read('../../report/pages/report.css') + read('page.css');
}

function example(name) {
  const text = read(`examples/${name}.mjs`).replace(/^\/\/ SPDX.*\n/, '');
  const [, , title] = text.match(/^export const name = (['"])(.*?)\1/m);
  return { title: title[0].toUpperCase() + title.slice(1), text };
}

const digest = (text) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;
const escaped = (text) => text.replaceAll('&', '&amp;').replaceAll('"', '&quot;').replaceAll('<', '&lt;');
const packed = (bytes) => gzipSync(bytes, { level: 9 }).toString('base64');

/** Replaces a mark by a text. Throws an Error if the mark does not occur exactly once. */
function filled(page, mark, text) {
  const parts = page.split(`{{${mark}}}`);
  if (parts.length !== 2) {
    throw new Error(`{{${mark}}} occurs ${parts.length - 1} times in the page, expected once`);
  }
  return parts.join(text);
}

const script = bundled('page.mjs');
const framed = bundled('frame.mjs');
const css = style();
for (const [text, end] of [[script, /<\/script|<!--/i], [framed, /<\/script|<!--/i], [css, /<\/style/i]]) {
  if (end.test(text)) {
    throw new Error('the code contains the end tag of its element');
  }
}

// The frame has the policy of the page too. Its worker and the solver come from blobs.
const within = `script-src ${digest(framed)} blob: 'wasm-unsafe-eval'; worker-src blob:`;
const closed = "default-src 'none'; base-uri 'none'; form-action 'none'; require-trusted-types-for 'script'; "
  + 'trusted-types carom';
const frame = '<!DOCTYPE html><meta charset="utf-8">'
  + `<meta http-equiv="Content-Security-Policy" content="${closed}; ${within}"><script>${framed}</script>`;
// The worker's code is strict, so a function of the solver cannot ask for its caller.
const worker = `'use strict';\n${readFileSync(judge, 'utf8')}\n${bundled('worker.mjs')}`;
const contents = {
  policy: `${closed}; ${within.replace('script-src', `script-src ${digest(script)}`)}; style-src ${digest(css)}`,
  style: css,
  docs: escaped(docs),
  frame: escaped(frame),
  examples: JSON.stringify(examples.map(example)).replaceAll('<', '\\u003c'),
  worker: packed(worker),
  wasm: packed(readFileSync(wasm)),
  script,
};
const page = Object.entries(contents).reduce((made, [mark, text]) => filled(made, mark, text), read('index.html'));
mkdirSync(output, { recursive: true });
writeFileSync(join(output, 'index.html'), page);
console.log(`${join(output, 'index.html')}: ${page.length} bytes, ${gzipSync(page).length} as transferred with gzip`);
