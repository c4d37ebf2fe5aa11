#!/usr/bin/env node
// SPDX-License-Identifier: BSL-1.0
import * as gate from './commands/gate_command.mjs';
import { list_command } from './commands/list_command.mjs';
import * as replay from './commands/replay_command.mjs';
import { UsageError } from './solver/judge.mjs';
import { did_you_mean } from './solver/nearest_name.mjs';
import { this_judge } from './threads/node_judge.mjs';

const usage = 2;  // exit status
const commands = { gate, replay };
for (const what of ['families', 'invariants', 'features', 'domains']) {
  commands[what] = list_command(what);
}

const help = () => `Carom checks rigid-body collision impulses against exact arithmetic.
Usage: carom [--help] [--version] COMMAND

${Object.entries(commands).map(([name, { summary }]) => `  ${name.padEnd(12)}${summary}\n`).join('')}`;

async function run([command, ...words]) {
  if (command === '--help' || command === '-h') {
    return { text: help(), status: 0 };
  }
  if (command === '--version') {
    return { text: `${(await this_judge())({ cmd: 'version' }).version}\n`, status: 0 };
  }
  if (command === undefined) {
    throw new UsageError(`no command is given; expected one of the commands below\n${help()}`);
  }
  if (!Object.hasOwn(commands, command)) {
    throw new UsageError(`there is no command '${command}'${did_you_mean(command, Object.keys(commands))}`);
  }
  return commands[command].run(words);
}

/** Text of others, without control characters that a terminal would obey. */
function printable(text) {
  return text.replace(/[\0-\x08\x0b-\x1f\x7f-\x9f]/g, '?');
}

process.stdout.on('error', (error) => process.exit(error.code === 'EPIPE' ? process.exitCode : usage));
try {
  const { text, status } = await run(process.argv.slice(2));
  process.exitCode = status;
  process.stdout.write(text);
} catch (error) {
  process.exitCode = usage;
  process.stderr.write(`carom: ${printable(error instanceof UsageError ? error.message : error.stack)}\n`);
}
