// SPDX-License-Identifier: BSL-1.0
import { existsSync, statSync } from 'node:fs';
import { basename, extname, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

import { shown } from './solver/answer.mjs';
import { UsageError } from './solver/judge.mjs';
import { did_you_mean } from './solver/nearest_name.mjs';
import { engine_subjects } from './threads/engine_solver.mjs';
import { SolverThread } from './threads/solver_thread.mjs';

const prefix = 'engine:';

const is_file = (path) => existsSync(path) && statSync(path).isFile();

function module_source(path, specification) {
  if (!is_file(path)) {
    throw new UsageError(`${specification}: there is no such file`);
  }
  return { url: pathToFileURL(path).href, name: basename(path, extname(path)), specification };
}

/**
 * The source of a solver: the URL or the path of its module, or the name of an engine's subject. `claimed` replaces
 * exports of the module. Throws UsageError.
 */
export function source_of(solver, claimed = {}) {
  if (solver instanceof URL && solver.protocol === 'file:') {
    return { ...module_source(fileURLToPath(solver), solver.href), claimed };
  }
  if (typeof solver !== 'string') {
    throw new UsageError('expected a function, the path or the file URL of a module, or the name of an engine, '
      + `found ${solver instanceof URL ? solver.href : shown(solver)}`);
  }
  const name = solver.startsWith(prefix) ? solver.slice(prefix.length) : solver;
  const engine = engine_subjects.get(name);
  if (engine !== undefined && !(name === solver && is_file(solver))) {
    return { engine, name, specification: name, claimed };
  }
  const is_path = name === solver && (/[/\\.]/.test(solver) || is_file(solver));
  if (!is_path) {
    throw new UsageError(`there is no engine '${name}'${did_you_mean(name, engine_subjects.keys()) || '.'}` +
      ` The engines are ${[...engine_subjects.keys()].join(', ')}. A module is a path such as ./solver.mjs`);
  }
  return { ...module_source(resolve(solver), solver), claimed };
}

/** Loads the solver once, in a thread of its own, and returns what it claims. Throws UsageError. */
export async function introduction_of(source, timeout) {
  try {
    const thread = new SolverThread(source, timeout);
    await thread.end();
    return thread.introduction;
  } catch (error) {
    throw new UsageError(`${source.specification}: ${error.message}`);
  }
}
