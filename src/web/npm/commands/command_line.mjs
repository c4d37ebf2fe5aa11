// SPDX-License-Identifier: BSL-1.0
import { parseArgs } from 'node:util';

import { read_option } from '../options.mjs';
import { UsageError } from '../solver/judge.mjs';
import { did_you_mean } from '../solver/nearest_name.mjs';

/** An option without a value. */
export const flag = (what) => ({ read: (text) => text === 'true', what });

const help = { help: flag('Print this help') };

/** An option with a choice of words. */
export function one_of(words, what) {
  const read = (text) => (words.includes(text) ? text : new Error(`expected ${words.join(' or ')}`));
  return { value: words.join('|'), read, what: `${what} (default: ${words[0]})` };
}

function parsed(words, options) {
  const specification = Object.fromEntries(Object.entries(options).map(([name, { value }]) =>
    [name, { type: value === undefined ? 'boolean' : 'string' }]));
  specification.help.short = 'h';
  try {
    return parseArgs({ args: words, options: specification, allowPositionals: true });
  } catch (error) {
    const name = /'-*([^'\s=]*)/.exec(error.message)?.[1] ?? '';
    if (error.code !== 'ERR_PARSE_ARGS_UNKNOWN_OPTION') {
      throw new UsageError(options[name]?.value === undefined
        ? error.message.split('\n')[0]
        : `--${name}: a value is missing; write --${name}=VALUE if it begins with -`);
    }
    const known = Object.keys(options).map((option) => `--${option}`);
    throw new UsageError(`there is no option '--${name}'${did_you_mean(`--${name}`, known)}`);
  }
}

/**
 * The options and the other words of a command line. `positional` names the other words, of which there are from
 * `least` to `most`. Throws UsageError.
 */
export function read_command_line(words, own_options, { positional = '', least = 0, most = 0 } = {}) {
  const options = { ...own_options, ...help };
  const { values, positionals } = parsed(words, options);
  const is_empty = (text) => text === '';
  const empty = Object.keys(values).find((name) => is_empty(values[name]));
  if (empty !== undefined || positionals.some(is_empty)) {
    throw new UsageError(`${empty === undefined ? positional || 'argument' : `--${empty}`}: expected a value, found an `
      + 'empty text; is a variable not set?');
  }
  const read = Object.fromEntries(Object.entries(values).map(([name, value]) =>
    [name, read_option(options[name], `--${name}`, value)]));
  if (read.help) {
    return { options: read, words: positionals };
  }
  if (positionals.length < least) {
    throw new UsageError(`${positional} is missing; --help lists what is expected`);
  }
  if (positionals.length > most) {
    throw new UsageError(`expected ${most === 0 ? 'no' : 'one'} ${positional || 'argument'}, ` +
      `found ${positionals.join(' ')}`);
  }
  return { options: read, words: positionals };
}

/** The lines of help about the options. */
export function help_on(options) {
  const entries = Object.entries({ ...options, ...help }).map(([name, { value, what }]) =>
    [`  --${name}${value === undefined ? '' : ` ${value}`}`, what]);
  return entries.map(([name, what]) => `${name}\n${wrapped(what)}\n`).join('');
}

function wrapped(text) {
  const lines = [''];
  for (const word of text.split(' ')) {
    if (lines.at(-1).length + word.length > 90) {
      lines.push('');
    }
    lines.push(`${lines.pop()} ${word}`);
  }
  return lines.map((line) => `     ${line}`).join('\n');
}
