// SPDX-License-Identifier: BSL-1.0
// A directory of reports has one writer at a time: this package or the native program, if CAROM_PROGRAM names it. These
// tests read the sources, and need no tarball.
import assert from 'node:assert';
import { spawn, spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test from 'node:test';
import { setTimeout as pause } from 'node:timers/promises';

import { make_output_folder } from '../../../src/web/npm/commands/output_folder.mjs';

const program = process.env.CAROM_PROGRAM;
const source = new URL('../../../src/web/npm/commands/output_folder.mjs', import.meta.url).href;
const refused = /^--out: another run writes to the directory /;

function new_folder(context) {
  const folder = mkdtempSync(join(tmpdir(), 'carom-folder-'));
  context.after(() => rmSync(folder, { recursive: true, force: true }));
  return folder;
}

/** The message of a process of its own that makes the folder; empty if it succeeds. */
function error_of(folder) {
  const script = `import { make_output_folder } from ${JSON.stringify(source)};
    try { make_output_folder(process.argv[1]); } catch (error) { console.log(error.message); }`;
  return spawnSync(process.execPath, ['--input-type=module', '-e', script, folder], { encoding: 'utf8' }).stdout;
}

const locks = (folder) => readdirSync(folder).filter((name) => name.startsWith('.')).sort();

test('the lock of a native run is respected', (context) => {
  const folder = new_folder(context);
  const lock = join(folder, '.carom-lock');
  writeFileSync(lock, '');
  const error = error_of(folder);
  assert.match(error, refused);
  assert.ok(error.includes(`If there is no such run, remove ${lock}\n`), error);
  assert.deepStrictEqual(locks(folder), ['.carom-lock']);
});

test('the native program and this package exclude each other', { skip: program === undefined }, async (context) => {
  const folder = new_folder(context);
  const words = ['gate', 'frictionless-double', '--families', 'generic', '--out', folder, '--cases'];
  const native = spawn(program, [...words, '1000000000'], { stdio: 'ignore' });
  const ended = new Promise((resolve) => native.on('close', resolve));
  const lock = join(folder, '.carom-lock');
  for (let tries = 0; tries < 1000 && !existsSync(lock); ++tries) {
    await pause(10);
  }
  assert.match(error_of(folder), refused);
  native.kill('SIGKILL');
  await ended;
  rmSync(lock);  // as the message advises
  assert.strictEqual(error_of(folder), '');

  make_output_folder(folder);  // until this process ends
  const { status, stderr } = spawnSync(program, [...words, '5'], { encoding: 'utf8' });
  assert.strictEqual(status, 2);
  assert.match(stderr, /^carom: --out: another run writes to the directory /);
  assert.ok(!existsSync(join(folder, 'report.json')));
});
