// SPDX-License-Identifier: BSL-1.0
import { randomUUID } from 'node:crypto';
import { existsSync, lstatSync, mkdirSync, readFileSync, renameSync, rmSync, unlinkSync, writeFileSync } from 'node:fs';
import { hostname } from 'node:os';
import { dirname, join } from 'node:path';

import { UsageError } from '../solver/judge.mjs';

const last = 'report.json';  // it lists the witnesses
const lock_name = '.carom-lock-npm';
const native_lock_name = '.carom-lock';
const stage_name = '.carom-stage-npm';

function at_path(path, action) {
  try {
    return action(path);
  } catch (error) {
    throw new UsageError(`--out: ${path}: ${error.message}; choose another directory`);
  }
}

/** Writes a file that must not exist. Returns whether it did not. */
function is_first(path, text) {
  try {
    writeFileSync(path, text, { flag: 'wx' });
    return true;
  } catch (error) {
    if (error.code === 'EEXIST') {
      return false;
    }
    throw error;
  }
}

function text_of(path) {
  try {
    return readFileSync(path, 'utf8');
  } catch {
    return undefined;
  }
}

/** Whether the run that wrote the lock was killed. The answer is no if it ran on another machine. */
function is_dead(text) {
  const [, pid, host] = /^(\d+) \S+ (.*)\n$/.exec(text) ?? [];
  try {
    return host === hostname() && !process.kill(Number(pid), 0);
  } catch (error) {
    return error.code === 'ESRCH';
  }
}

/** Removes the lock of a killed run. Of several runs that try this at once, one removes it. */
function bury(lock, text) {
  const mark = `${lock}-${text.split(' ')[1]}`;
  if (is_first(mark, '')) {
    if (text_of(lock) === text) {
      unlinkSync(lock);
    }
    unlinkSync(mark);
  }
}

function refusal(folder, lock) {
  return new UsageError(`--out: another run writes to the directory ${folder}; wait until it ends, or choose another `
    + `directory. If there is no such run, remove ${lock}`);
}

/**
 * Keeps other runs of this program and of the native program out of the folder until this process ends. Node has no
 * locks that the system releases, so the lock is a file that names its process. Each program makes its own lock before
 * it looks for the other's, so one of two runs at once sees the other. Throws UsageError if another run has the folder.
 */
function lock_folder(folder) {
  const lock = join(folder, lock_name);
  const own = `${process.pid} ${randomUUID()} ${hostname()}\n`;
  for (let tries = 0; tries < 3; ++tries) {
    if (at_path(lock, (path) => is_first(path, own))) {
      process.once('exit', () => {
        if (text_of(lock) === own) {
          unlinkSync(lock);
        }
      });
      const native_lock = join(folder, native_lock_name);
      if (existsSync(native_lock)) {  // a run of the native program
        throw refusal(folder, native_lock);
      }
      return;
    }
    const found = text_of(lock);
    if (found !== undefined && !is_dead(found)) {
      break;
    }
    if (found !== undefined) {
      at_path(lock, () => bury(lock, found));
    }
  }
  throw refusal(folder, lock);
}

/** Makes the folders of the reports, and locks them until this process ends. Throws UsageError. */
export function make_output_folder(folder) {
  at_path(join(folder, 'witnesses'), (path) => mkdirSync(path, { recursive: true }));
  lock_folder(folder);
}

function is_regular(path) {
  try {
    return lstatSync(path).isFile();
  } catch {
    return false;
  }
}

/** The witnesses that the report in the folder lists; none if the file is not a report of Carom. */
function listed_witnesses(folder) {
  try {
    const report = JSON.parse(readFileSync(join(folder, last), 'utf8'));
    const violations = report.carom ? report.subjects.flatMap((subject) => subject.violations ?? []) : [];
    return violations.map(({ witness }) => String(witness));
  } catch {
    return [];
  }
}

/** Whether the path is "witnesses/SUBJECT.INVARIANT.json". Another path could lead to any file. */
function is_witness_path(path, invariants) {
  const invariant = /^witnesses\/[^/\\]*\.([^./\\]+)\.json$/.exec(path)?.[1];
  return invariant !== undefined && invariants.includes(invariant);
}

/**
 * Puts the files in place, in a folder of make_output_folder: writes all of them beside their places, renames them, and
 * removes the witnesses that only an earlier report lists. `files` has the members `file` and `text`. Throws UsageError.
 */
export function write_output(folder, files, invariants) {
  const old = is_regular(join(folder, last)) ? listed_witnesses(folder) : [];
  const stage = join(folder, stage_name);
  at_path(stage, (path) => rmSync(path, { recursive: true, force: true }));  // that of a killed run
  const ordered = [...files].sort((x, y) => (x.file === last) - (y.file === last));
  try {
    for (const { file, text } of ordered) {
      at_path(dirname(join(stage, file)), (path) => mkdirSync(path, { recursive: true }));
      at_path(join(stage, file), (path) => writeFileSync(path, text, { flush: true }));
    }
    for (const { file } of ordered) {
      at_path(join(folder, file), (path) => renameSync(join(stage, file), path));
    }
  } finally {
    rmSync(stage, { recursive: true, force: true });
  }
  const current = files.map(({ file }) => file);
  for (const path of old) {
    if (!current.includes(path) && is_witness_path(path, invariants) && is_regular(join(folder, path))) {
      at_path(join(folder, path), unlinkSync);
    }
  }
}
