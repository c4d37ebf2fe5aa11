// SPDX-License-Identifier: BSL-1.0
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';

import { make_judge } from '../solver/judge.mjs';

/** A new judge in this thread. */
export function load_judge() {
  const create = createRequire(import.meta.url)('../carom_judge.cjs');
  return make_judge(create, { wasmBinary: readFileSync(new URL('../carom_judge.wasm', import.meta.url)) });
}

let shared;

/** The judge of this thread. Its callers take turns, so each sets the session before it asks. */
export function this_judge() {
  shared ??= load_judge();
  return shared;
}
