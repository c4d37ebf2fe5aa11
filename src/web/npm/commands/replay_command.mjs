// SPDX-License-Identifier: BSL-1.0
import { readFileSync } from 'node:fs';

import { draw } from '../draw.mjs';
import { case_options, judge_options } from '../options.mjs';
import { replay } from '../replay.mjs';
import { exact_json } from '../solver/exact_json.mjs';
import { UsageError } from '../solver/judge.mjs';
import { flag, help_on, one_of, read_command_line } from './command_line.mjs';

const options = {
  subject: { value: 'SOLVER', read: (text) => text, what: 'Solver to judge: a module, or the name of an engine' },
  drawn: flag('Use the collision of a witness as it was drawn, before shrinking'),
  'all-laws': flag('Show the outcome of every law, not only of the law that the solver claims'),
  ...case_options,
  ...judge_options,
  format: one_of(['text', 'json'], 'Format of the output'),
};

export const summary = 'Show each step of the exact outcome of collisions, and judge a solver on them';

const help = () => `${summary}
Usage: carom replay FILE [OPTIONS]
       carom replay --family FAMILY --case N [OPTIONS]

FILE holds witnesses or collisions: JSON Lines, one object or an array.

${help_on(options)}`;

function parsed(text, place) {
  try {
    return JSON.parse(text);
  } catch (error) {
    throw new UsageError(`${place}: ${error.message}`);
  }
}

function is_json(text) {
  try {
    JSON.parse(text);
    return true;
  } catch {
    return false;
  }
}

/** The objects in a file: one, an array of them, or one a line. Each has its text and its place. */
function records_in(file) {
  let text;
  try {
    text = readFileSync(file, 'utf8');
  } catch (error) {
    throw new UsageError(`${file}: ${error.message}`);
  }
  const lines = text.split('\n').map((line, i) => ({ text: line, place: `${file}:${i + 1}` }));
  const filled = lines.filter((line) => line.text.trim() !== '');
  if (!is_json(text) && filled.length > 1 && is_json(filled[0].text)) {
    filled.forEach((line) => parsed(line.text, line.place));
    return filled;
  }
  const whole = parsed(text, file);
  const records = Array.isArray(whole)
    ? whole.map((one, i) => ({ text: exact_json(one), place: `${file}[${i}]` }))
    : [{ text, place: file }];
  if (records.length === 0) {
    throw new UsageError(`${file}: expected a witness or a collision, found none`);
  }
  return records;
}

/** The case that the gate draws from the family with this seed and number. */
async function numbered_case(family, number, seed = '1', within) {
  const [one] = await draw({ family, seed, first: number, within });
  return { text: exact_json(one), place: `${family} #${number} of seed ${seed}` };
}

export async function run(words) {
  const { options: { format = 'text', help: is_help, ...given }, words: [file] } =
    read_command_line(words, options, { positional: 'FILE', most: 1 });
  if (is_help) {
    return { text: help(), status: 0 };
  }
  const { subject, drawn, 'all-laws': all_laws, 'limit-ulps': limit_ulps, family, case: number, seed, within,
    ...judged } = given;
  if ((file === undefined) === (family === undefined) || (family === undefined) !== (number === undefined)) {
    throw new UsageError('expected FILE, or --family and --case; --help lists what is expected');
  }
  const records = file === undefined ? [await numbered_case(family, number, seed, within)] : records_in(file);
  let text = '';
  let status = 0;
  for (const { text: record, place } of records) {
    const shown = await replay(record, { solver: subject, place, drawn, all_laws, limit_ulps, within, ...judged });
    text += format === 'json' ? `${shown.record_text}\n` : `${shown.text}\n`;
    status = shown.violated ? 1 : status;
  }
  return { text, status };
}
