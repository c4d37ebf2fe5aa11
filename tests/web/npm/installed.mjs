// SPDX-License-Identifier: BSL-1.0
// The package, installed from its tarball in an empty folder.
import { execFileSync, spawn } from 'node:child_process';
import { cpSync, existsSync, mkdtempSync, realpathSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { after } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';

const tarball = process.env.CAROM_NPM_TARBALL;
if (tarball === undefined) {
  throw new Error('CAROM_NPM_TARBALL is not set; it names the tarball of the package');
}
const here = dirname(fileURLToPath(import.meta.url));
const npm_engines = join(here, '../../../src/subjects/engines/npm/node_modules');

function npm(folder, ...words) {
  execFileSync('npm', ['install', '--no-audit', '--no-fund', '--loglevel=error', ...words], {
    cwd: folder, stdio: ['ignore', 'ignore', 'inherit'], shell: process.platform === 'win32',
  });
}

/** A new folder with the package and the solvers of these tests. It is removed after the tests of the file. */
export function installed() {
  const folder = realpathSync(mkdtempSync(join(tmpdir(), 'carom-npm-')));
  after(() => rmSync(folder, { recursive: true, force: true }));
  writeFileSync(join(folder, 'package.json'), '{ "private": true }\n');
  npm(folder, '--offline', tarball);
  cpSync(join(here, 'solvers'), folder, { recursive: true });
  cpSync(join(folder, 'node_modules/carom/examples/solver.mjs'), join(folder, 'sound.mjs'));
  return folder;
}

/** Installs packages from the registry. Returns whether that succeeds; without a network it does not. */
export function has_installed(folder, ...packages) {
  try {
    npm(folder, '--prefer-offline', '--no-save', tarball, ...packages);
    return true;
  } catch {
    return false;
  }
}

/**
 * Copies an engine's package that the project has installed. Returns whether there is one. A link would let npm remove
 * the project's files.
 */
export function has_copied(folder, name) {
  const from = join(npm_engines, name);
  if (existsSync(from)) {
    cpSync(from, join(folder, 'node_modules', name), { recursive: true });
  }
  return existsSync(from);
}

/** The module of this name that the folder's code would import. */
export function imported(folder, file) {
  return import(pathToFileURL(join(folder, 'node_modules/carom', file)).href);
}

/** Runs a program, and returns its exit status, standard output and standard error. */
export function run(folder, program, ...words) {
  return new Promise((resolve) => {
    const { NODE_TEST_CONTEXT, ...env } = process.env;  // with it, a runner of tests in a test runs nothing
    const child = spawn(program, words, { cwd: folder, env });
    const output = { stdout: '', stderr: '' };
    for (const stream of ['stdout', 'stderr']) {
      child[stream].setEncoding('utf8').on('data', (text) => { output[stream] += text; });
    }
    child.on('close', (status, signal) => resolve({ status, signal, ...output }));
  });
}

/** Runs the program of the package, without optimising the judge's code: the runs are short. */
export function carom(folder, ...words) {
  return run(folder, process.execPath, '--liftoff-only', join(folder, 'node_modules/carom/carom.mjs'), ...words);
}

/** The subject in the report that `carom gate` prints with these options, and the exit status. */
export async function gated(folder, solver, ...words) {
  const result = await carom(folder, 'gate', solver, '--format', 'json', ...words);
  if (result.stdout === '') {
    throw new Error(`no report: ${result.stderr}`);
  }
  return { ...result, subject: JSON.parse(result.stdout).subjects[0] };
}

/** The names of the invariants that the subject violates. */
export function violated(subject) {
  return (subject.violations ?? []).map(({ invariant }) => invariant).sort();
}
