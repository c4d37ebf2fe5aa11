// SPDX-License-Identifier: BSL-1.0
import { AssertionError } from 'node:assert';

import { gate } from './gate.mjs';

const default_cases = 100;  // of each family, so that a test takes some seconds
const first_cases = 4;  // of each family; they find most defects, and a wrong solver takes long to judge

/** The part of a report's text that is about the subject. Its first line is the name. */
function words_about(name, text) {
  const first = `${name}\n`;
  const paragraph = text.split('\n\n').find((one) => one.startsWith(first));
  return paragraph?.slice(first.length) ?? text;
}

function message_of({ report, text }) {
  const [{ name, violations = [], error }] = report.subjects;
  const names = violations.map(({ invariant }) => invariant).join(', ');
  const what = names !== '' ? `violates ${names}` : `gets no verdict${error ? `: ${error}` : ''}`;
  return `${name} ${what}\n${words_about(name, text)}`;
}

/**
 * Judges a solver as `gate` does, and throws an AssertionError if it is not sound. The message holds the violated
 * invariants and a witness. The error's property `report` is the report.
 */
export async function assertSound(solver, { cases = default_cases, ...options } = {}) {
  let result;
  for (const count of cases > first_cases ? [first_cases, cases] : [cases]) {
    result = await gate(solver, { ...options, cases: count });
    if (result.status !== 0) {
      const error = new AssertionError({ message: message_of(result), stackStartFn: assertSound });
      throw Object.assign(error, { report: result.report });
    }
  }
  return result;
}
