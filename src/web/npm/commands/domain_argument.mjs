// SPDX-License-Identifier: BSL-1.0
import { readFileSync } from 'node:fs';

import { domain_text } from '../solver/introduction.mjs';
import { UsageError } from '../solver/judge.mjs';

/** The domain of `--within`: its text, or the text of the ranges in a JSON file. Throws UsageError. */
export function domain_argument(text) {
  if (!text?.endsWith('.json')) {
    return text;
  }
  try {
    return domain_text(JSON.parse(readFileSync(text, 'utf8')));
  } catch (error) {
    throw new UsageError(`--within: ${text}: ${error.message}`);
  }
}
