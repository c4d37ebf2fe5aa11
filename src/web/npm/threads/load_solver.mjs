// SPDX-License-Identifier: BSL-1.0
import { introduce } from '../solver/introduction.mjs';
import { engine_exports } from './engine_solver.mjs';

/** The function that solves, and the introduction, of a module or an engine. */
export async function load_solver({ url, name, engine, claimed }) {
  const exported = engine === undefined ? await import(url) : await engine_exports(engine);
  return introduce({ ...exported, ...claimed }, name);
}
