// SPDX-License-Identifier: BSL-1.0
import { InvalidAnswer, is_promise, message_of, write_refusal, write_result } from './answer.mjs';
import { answer_size, collision_at, collision_size } from './doubles.mjs';

const no_promise = 'give the path of its module in place of the function';

/**
 * The session of a function in the same thread, for the judge. A hang of the function hangs the thread. `promise` is
 * the advice if the function returns a promise.
 */
export function local_session(solve, { matrix = false, promise = no_promise } = {}) {
  const texts = new Map();
  function answer(collisions, answers, i) {
    let result;
    let promises = false;
    try {
      result = solve(collision_at(collisions, i * collision_size));
      promises = is_promise(result);
    } catch (thrown) {
      return write_refusal(answers, i * answer_size, thrown);
    }
    if (promises) {
      result.then(undefined, () => {});
      throw new InvalidAnswer(`returned a promise; ${promise}`);
    }
    return write_result(answers, i * answer_size, result, matrix);
  }
  return {
    open: () => '',
    solve(collisions, count, answers) {
      texts.clear();
      for (let i = 0; i < count; ++i) {
        try {
          texts.set(i, answer(collisions, answers, i));
        } catch (error) {
          return { answered: i, failure: message_of(error) };
        }
      }
      return undefined;
    },
    text: (i) => texts.get(i) ?? '',
    close: () => '',
  };
}
