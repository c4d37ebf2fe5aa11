// SPDX-License-Identifier: BSL-1.0
import { asker_of } from './gate.mjs';
import { judge_options, sorted_options } from './options.mjs';
import { shown } from './solver/answer.mjs';
import { exact_json } from './solver/exact_json.mjs';
import { domain_text } from './solver/introduction.mjs';
import { UsageError } from './solver/judge.mjs';
import { this_judge } from './threads/node_judge.mjs';

/** Runs `action` with an asker of the solver, and ends the asker. Without a solver, the asker only knows the truth. */
async function with_asker(solver, { claimed, timeout }, action) {
  if (solver === undefined) {
    const judge = await this_judge();
    return action({ ask: judge });
  }
  const asker = await asker_of(solver, claimed, timeout);
  try {
    return await action(asker);
  } finally {
    await asker.end();
  }
}

/** The law that a witness names. Throws UsageError if the text is no JSON. */
function law_in(text) {
  try {
    return JSON.parse(text)?.subject?.model;
  } catch (error) {
    throw new UsageError(`the record: ${error.message}`);
  }
}

/**
 * Works a witness or a collision step by step in exact numbers. With a solver, also judges it on the collision.
 * `record` may be text in JSON. `place` names it in the text. Related collisions lie in the domain `within`.
 */
export async function replay(record, { solver, all_laws = false, drawn = false, place, within, ...options } = {}) {
  const sorted = sorted_options(options, judge_options);
  const text = typeof record === 'string' ? record : exact_json(record);
  const law = sorted.claimed.law ?? law_in(text);
  const asked = { ...sorted.request, ...(within !== undefined && { within: domain_text(within, 'within') }) };
  return with_asker(solver, sorted, async ({ ask, subject }) => {
    const reply = await ask({ cmd: 'replay', text, place, law, subject, options: asked, all_laws, drawn });
    return { ...reply, record: JSON.parse(reply.record_text) };
  });
}

/** Judges a solver on one collision, with all relations. */
export async function judge(solver, collision, options = {}) {
  if (typeof collision !== 'object' || collision === null) {
    throw new UsageError(`the collision: expected an object, found ${shown(collision)}`);
  }
  const sorted = sorted_options(options, judge_options);
  return with_asker(solver, sorted, ({ ask, subject }) =>
    ask({ cmd: 'judge', subject, options: sorted.request, collision }));
}
