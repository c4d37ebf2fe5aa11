// SPDX-License-Identifier: BSL-1.0
import { shown } from './solver/answer.mjs';
import { claim_names, domain_text } from './solver/introduction.mjs';
import { UsageError } from './solver/judge.mjs';
import { did_you_mean } from './solver/nearest_name.mjs';

function integer(least, most) {
  return (text) => {
    const is_in_range = /^\d+$/.test(text) && BigInt(text) >= least && BigInt(text) <= most;
    return is_in_range ? Number(text) : new Error(`expected an integer from ${least} to ${most}`);
  };
}

function number(least, most) {
  return (text) => {
    const value = text.trim() === '' ? NaN : Number(text);
    return value >= least && value <= most ? value : new Error(`expected a number from ${least} to ${most}`);
  };
}

function seed(text) {
  const value = integer(0n, 2n ** 64n - 1n)(text);
  return value instanceof Error ? new Error('expected an integer from 0 to 2^64 - 1') : text;
}

const names = (text) => text.split(',').filter((name) => name !== '');
const some_names = (text) => (names(text).length > 0 ? names(text) : new Error('expected at least one name'));
const text = (value) => value;
const truths = new Map([['true', true], ['false', false]]);
const flag = (text) => truths.get(text) ?? new Error('expected true or false');

export const judge_options = {
  'limit-ulps': {
    value: 'X', read: number(1e-3, 1e15), what: 'Largest permitted backward error, in ulps (default: 32)',
  },
  digits: { value: 'N', read: integer(1, 18), what: 'N permits a relative error of 10^-N, in place of --limit-ulps' },
  exact: { read: flag, what: 'Judge only in exact arithmetic, without the faster filters. The verdicts are the same' },
  timeout: {
    value: 'S', read: number(1e-3, 86400), what: 'Time limit of each call of solve, in seconds (default: 5)',
  },
};

/** The options of one case of a family. */
export const case_options = {
  family: { value: 'FAMILY', read: text, what: 'The family of a case, in place of FILE' },
  case: { value: 'N', read: integer(0, 2 ** 53), what: 'The number of the case, from 0; needs --family' },
  seed: { value: 'N', read: seed, what: 'The seed of the case (default: 1); needs --family' },
  within: { value: 'DOMAIN', read: text, what: 'The domain of the case and of related collisions (default: everything)' },
};

/** The options of a gate, for the command line and for the API, which writes _ in place of -. */
export const gate_options = {
  seed: { value: 'N', read: seed, what: 'Seed of the cases; the same seed gives the same cases (default: 1)' },
  cases: {
    value: 'N', read: integer(1, 1e9),
    what: 'Number of cases of each family; the weight of a family multiplies it (default: 1000)',
  },
  families: { value: 'NAMES', read: some_names, what: 'Families of cases, separated by commas (default: all)' },
  within: {
    value: 'DOMAIN', read: text,
    what: 'Draw every case into this domain: a name that `carom domains` lists, a JSON file of ranges, or ranges ' +
      'and kinds such as size=0.1:10,bodies=spheres,movable=both,walls=resting,plane=xy ' +
      '(default: the domain that the solver declares, otherwise everything)',
  },
  ...judge_options,
  'relations-every': {
    value: 'N', read: integer(1, 1e9),
    what: 'Judge each invariant that relates two collisions on every Nth case only (default: 1)',
  },
  deviates: {
    value: 'NAMES', read: names,
    what: 'Invariants that are not judged, separated by commas: INVARIANT, or INVARIANT@FAMILY for one family',
  },
  out: {
    value: 'DIR', read: (text) => (text === '' ? new Error('expected a directory') : text),
    what: 'Directory for the reports and for witnesses/; the files of an earlier report there are replaced',
  },
  jobs: { value: 'N', read: integer(1, 1024), what: 'Number of threads that judge (default: the number of cores)' },
};

/** The options of `draw`. */
export const draw_options = {
  ...case_options,
  first: { read: integer(0, 2 ** 53) },
  count: { read: integer(1, 1e6) },
};
delete draw_options.case;

/** What a solver claims. A function has no exports, so the API takes these as options. */
const claims = claim_names.filter((name) => name !== 'deviates');

const hooks = {
  signal: (value) => typeof value.addEventListener === 'function' || 'expected an AbortSignal',
  progress: (value) => typeof value === 'function' || 'expected a function',
};

function read_hook(name, value) {
  const reason = value === null || hooks[name](value);
  if (reason !== true) {
    throw new UsageError(`${name}: ${reason}, found ${shown(value)}`);
  }
  return value ?? undefined;
}

function read_domain(name, value) {
  try {
    return domain_text(value, name);
  } catch (error) {
    throw new UsageError(error.message);
  }
}

/** The value of an option. Throws UsageError. `shown_name` is the option as the user wrote it. */
export function read_option(option, shown_name, value) {
  const given = String(value);
  const result = option.read(given);
  if (result instanceof Error) {
    throw new UsageError(`${shown_name}: ${result.message}, found ${given === '' ? 'nothing' : given}`);
  }
  return result;
}

/**
 * Sorts the options of the API: those of the request, what the solver claims, and the rest. Throws UsageError if an
 * option is unknown or has a wrong value.
 */
export function sorted_options(given, options = gate_options) {
  const sorted = { request: {}, claimed: {}, jobs: undefined, timeout: 5 };
  const own = Object.keys(options).map((name) => name.replaceAll('-', '_'));
  const of_solver = options === draw_options ? [] : claims;
  const of_run = options === gate_options ? Object.keys(hooks) : [];
  const known = [...own, ...of_solver, ...of_run];
  for (const [name, value] of Object.entries(given).filter(([, value]) => value !== undefined)) {
    const option = options[name.replaceAll('_', '-')];
    if (of_solver.includes(name)) {
      sorted.claimed[name] = value;
    } else if (of_run.includes(name)) {
      sorted[name] = read_hook(name, value);
    } else if (option === undefined || !known.includes(name)) {
      throw new UsageError(`there is no option '${name}'${did_you_mean(name, known)}`);
    } else {
      const target = ['jobs', 'timeout'].includes(name) ? sorted : sorted.request;
      target[name] = read_option(option, name, name === 'within' ? read_domain(name, value) : value);
    }
  }
  if (sorted.request.digits !== undefined && sorted.request.limit_ulps !== undefined) {
    throw new UsageError('digits excludes limit_ulps; use one of them');
  }
  return sorted;
}
