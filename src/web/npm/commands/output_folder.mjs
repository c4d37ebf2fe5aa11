// SPDX-License-Identifier: BSL-1.0
import { randomBytes } from 'node:crypto';
import { lstatSync, mkdirSync, readFileSync, renameSync, rmSync, unlinkSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';

import { UsageError } from '../solver/judge.mjs';

const last = 'report.json';  // it lists the witnesses

function at_path(path, action) {
  try {
    return action(path);
  } catch (error) {
    throw new UsageError(`--out: ${path}: ${error.message}; choose another directory`);
  }
}

/** Makes the folders of the reports. Throws UsageError. */
export function make_output_folder(folder) {
  at_path(join(folder, 'witnesses'), (path) => mkdirSync(path, { recursive: true }));
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
 * Puts the files in place: writes all of them beside their places, renames them, and removes the witnesses that only an
 * earlier report lists. `files` has the members `file` and `text`. Throws UsageError.
 */
export function write_output(folder, files, invariants) {
  const old = is_regular(join(folder, last)) ? listed_witnesses(folder) : [];
  const stage = join(folder, `.carom-stage-npm-${randomBytes(8).toString('hex')}`);
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
