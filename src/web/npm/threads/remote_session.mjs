// SPDX-License-Identifier: BSL-1.0
import { SolverThread } from './solver_thread.mjs';

/**
 * The sessions of a solver's module in a thread of its own, for the judge. Each session loads the module anew. But if
 * `session.continues` is true and the solver has not failed, a session continues the one before it.
 */
export function remote_session(source, timeout, introduction) {
  const expected = JSON.stringify(introduction);
  let thread;
  let texts = new Map();
  const end = () => {
    thread?.end();
    thread = undefined;
  };
  const session = {
    continues: false,
    open() {
      if (session.continues && thread !== undefined) {
        return '';
      }
      end();
      try {
        thread = new SolverThread(source, timeout);
      } catch (error) {
        return error.message;
      }
      if (JSON.stringify(thread.introduction) !== expected) {
        end();
        return 'the module makes other claims when it is loaded again; it must always make the same claims';
      }
      return '';
    },
    solve(collisions, count, answers) {
      const { answered, failure, texts: told } = thread.solve(collisions, count, answers);
      texts = told;
      if (failure === undefined) {
        return undefined;
      }
      end();
      return { answered: Math.min(answered, count - 1), failure };  // the last one may fail after its answer
    },
    text: (i) => texts.get(i) ?? '',
    close: () => '',
  };
  return session;
}
