// SPDX-License-Identifier: BSL-1.0
import { gate } from '../gate.mjs';
import { gate_options } from '../options.mjs';
import { this_judge } from '../threads/node_judge.mjs';
import { help_on, one_of, read_command_line } from './command_line.mjs';
import { domain_argument } from './domain_argument.mjs';
import { signal_of_interrupt } from './interrupt.mjs';
import { make_output_folder, write_output } from './output_folder.mjs';
import { progress_line } from './progress.mjs';

const options = {
  ...gate_options,
  format: one_of(['text', 'json'], 'Format of the output'),
};

export const summary = 'Judge a solver: exit status 0 all invariants hold, 1 an invariant is violated, 2 an error';

const help = () => `${summary}
Usage: carom gate SOLVER [OPTIONS]

SOLVER is the path of a module that exports solve(collision), or the name of an engine such as cannon.

${help_on(options)}`;

export async function run(words) {
  const { options: { format, help: is_help, ...given }, words: [solver] } =
    read_command_line(words, options, { positional: 'SOLVER', least: 1, most: 1 });
  if (is_help) {
    return { text: help(), status: 0 };
  }
  const { out } = given;
  if (out !== undefined) {
    make_output_folder(out);
  }
  const of_gate = Object.fromEntries(Object.entries(given).map(([name, value]) => [name.replaceAll('-', '_'), value]));
  const result = await gate(solver, {
    ...of_gate, within: domain_argument(of_gate.within), signal: signal_of_interrupt(), progress: progress_line(),
  });
  if (out !== undefined) {
    const invariants = (await this_judge())({ cmd: 'list', what: 'invariants' }).map(({ name }) => name);
    write_output(out, result.files, invariants);
  }
  const report = result.files.find(({ file }) => file === 'report.json');
  return { text: format === 'json' ? report.text : result.text, status: result.status };
}
