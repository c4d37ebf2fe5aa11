// SPDX-License-Identifier: BSL-1.0
// A directory of reports has one writer at a time: this package or the native program, if CAROM_PROGRAM names it. These
// tests read the sources, and need no tarball.
import assert from 'node:assert';
import { spawn, spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { hostname, tmpdir } from 'node:os';
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
const text_of_lock = (pid) => `${pid} native ${hostname()}\n`;
const dead = () => spawnSync(process.execPath, ['-e', '']).pid;

test('the lock of a living native run is respected', (context) => {
  const folder = new_folder(context);
  const lock = join(folder, '.carom-lock');
  for (const text of [text_of_lock(process.pid), `${dead()} native another-machine\n`, '', 'mine']) {
    writeFileSync(lock, text);
    const error = error_of(folder);
    assert.match(error, refused);
    assert.ok(error.includes(`If there is no such run, remove ${lock}\n`), error);
    assert.deepStrictEqual([readFileSync(lock, 'utf8'), locks(folder)], [text, ['.carom-lock']]);
  }
});

test('the lock of a killed native run locks nothing', (context) => {
  const folder = new_folder(context);
  writeFileSync(join(folder, '.carom-lock'), text_of_lock(dead()));
  assert.strictEqual(error_of(folder), '');
  assert.deepStrictEqual(locks(folder), ['.carom-lock']);
});

test('the native program and this package exclude each other', { skip: program === undefined }, async (context) => {
  const folder = new_folder(context);
  const words = ['gate', 'frictionless-double', '--families', 'generic', '--out', folder, '--cases'];
  const native = spawn(program, [...words, '1000000000'], { stdio: 'ignore' });
  const ended = new Promise((resolve) => native.on('close', resolve));
  const lock = join(folder, '.carom-lock');
  for (let tries = 0; tries < 1000 && !(existsSync(lock) && statSync(lock).size > 0); ++tries) {
    await pause(10);
  }
  assert.strictEqual(readFileSync(lock, 'utf8'), text_of_lock(native.pid));
  assert.match(error_of(folder), refused);
  native.kill('SIGKILL');
  await ended;
  assert.strictEqual(error_of(folder), '', 'a killed run locks nothing');

  make_output_folder(folder);  // until this process ends
  const { status, stderr } = spawnSync(program, [...words, '5'], { encoding: 'utf8' });
  assert.strictEqual(status, 2);
  assert.match(stderr, /^carom: --out: another run writes to the directory /);
  assert.ok(!existsSync(join(folder, 'report.json')));
});
