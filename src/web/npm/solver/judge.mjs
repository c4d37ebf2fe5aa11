// SPDX-License-Identifier: BSL-1.0
import { answer_size, collision_size } from './doubles.mjs';
import { exact_json } from './exact_json.mjs';

/** A mistake in an option, a claim or a file. */
export class UsageError extends Error {
  name = 'UsageError';
}

const no_session = { open: () => 'no solver is given' };

/**
 * The judge: a function that takes a request and returns the reply. `create` is the function that carom_judge.js
 * defines, and `settings` go to it. The property `session` of the judge is what it asks: open(), solve(collisions,
 * count, answers), text(i), close().
 */
export async function make_judge(create, settings) {
  let module = undefined;
  const doubles = (pointer, size) => module.HEAPF64.subarray(pointer / 8, pointer / 8 + size);
  module = await create({
    ...settings,
    caromOpen: () => judge.session.open(),
    caromSolve(collisions, count, answers) {
      const failure = judge.session.solve(
        doubles(collisions, count * collision_size), count, doubles(answers, count * answer_size));
      return failure === undefined ? '' : JSON.stringify(failure);
    },
    caromText: (i) => judge.session.text(i),
    caromClose: () => judge.session.close(),
    caromProgress: (done, all) => judge.progress?.(done, all),
  });
  function judge(request) {
    const reply = JSON.parse(module.caromCall(exact_json(request)));
    if (typeof reply.error === 'string') {
      throw new UsageError(reply.error.replace(/^\/model\b/, 'law').replace(/^(\/|--)/, ''));
    }
    return reply;
  }
  judge.session = no_session;
  return judge;
}
