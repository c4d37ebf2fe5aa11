// SPDX-License-Identifier: BSL-1.0
import { exact_json } from '../solver/exact_json.mjs';
import { this_judge } from '../threads/node_judge.mjs';
import { help_on, one_of, read_command_line } from './command_line.mjs';

const options = { format: one_of(['text', 'json'], 'Format of the output') };

function in_text(entries) {
  return entries.map(({ name, summary, statement }) => `${name}\n    ${summary ?? statement}\n`).join('');
}

/** The command that lists these things. */
export function list_command(what) {
  const summary = `List the ${what}`;
  return {
    summary,
    async run(words) {
      const { options: { format = 'text', help } } = read_command_line(words, options);
      if (help) {
        return { text: `${summary}\nUsage: carom ${what} [OPTIONS]\n\n${help_on(options)}`, status: 0 };
      }
      const entries = (await this_judge())({ cmd: 'list', what });
      return { text: format === 'json' ? `${exact_json(entries)}\n` : in_text(entries), status: 0 };
    },
  };
}
