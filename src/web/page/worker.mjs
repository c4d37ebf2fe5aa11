// SPDX-License-Identifier: BSL-1.0
// The worker: the judge, and the solver that it asks. `createCaromJudge` comes before this script.
import { introduce } from '../npm/solver/introduction.mjs';
import { make_judge } from '../npm/solver/judge.mjs';
import { local_session } from '../npm/solver/local_session.mjs';
import { lock_down } from './lock_down.mjs';

let port;  // to the frame, and the only way to it: nothing that the solver can reach holds it
let judge;
let address; // of the solver's text
let told = 0; // when progress was last told, in milliseconds
let thrown;  // the first defect of the solver's code that it threw

const post = (message) => port.postMessage(message);

function line_of(error) {
  const [, line] = String(error?.stack).split(address)[1]?.match(/^:(\d+)/) ?? [];
  return line && Number(line);
}

/** What an error tells. It may be any value of the solver, with getters that throw. */
function words_of(error) {
  try {
    return { error: String(error?.message ?? error), kind: String(error?.name), line: line_of(error) };
  } catch {
    return { error: 'it threw an error that cannot be read' };
  }
}

function noted(error) {
  const is_defect = [TypeError, ReferenceError, RangeError].some((type) => error instanceof type);
  if (is_defect) {
    thrown ??= { message: `${error.name}: ${error.message}`, line: line_of(error) };
  }
  return error;
}

/**
 * A session that tells the frame before it asks the solver: it posts the collisions of a call, then the index of each
 * collision, and at last null.
 */
function told_session(solve, { matrix }) {
  let next = 0;
  const ask = (collision) => {
    post(next++);
    try {
      return solve(collision);
    } catch (error) {
      throw noted(error);
    }
  };
  const session = local_session(ask, { matrix, promise: 'on the page, solve must return the outcome itself' });
  return {
    ...session,
    solve(collisions, count, answers) {
      next = 0;
      post(collisions.slice());
      const failure = session.solve(collisions, count, answers);
      post(null);
      return failure;
    },
  };
}

function tell_progress(done, all) {
  const now = performance.now();
  if (now - told > 100) {
    told = now;
    post({ progress: done / all });
  }
}

const actions = {
  __proto__: null,

  /** Makes the judge. No code of a solver has run yet, and none that runs later can change what the judge uses. */
  async open({ module }) {
    const instantiateWasm = (imports, done) => {
      const instance = new WebAssembly.Instance(module, imports);
      done(instance, module);
      return instance.exports;
    };
    judge = await make_judge(createCaromJudge, { instantiateWasm });
    judge.progress = tell_progress;
    // A solver cannot end the worker. It has nobody to post to, either.
    delete self.close;
    delete self.postMessage;
    lock_down();
  },

  /** Judges a little, so that the browser has compiled the judge before the reader waits for it. */
  warm() {
    const subject = { protocol: 1, name: 'warm', version: '', precision: 'binary64', model: 'frictionless' };
    const asked = { subject, options: { cases: 1 } };
    const before = judge.session;
    judge.session = local_session(({ a, b }) => ({ a, b }));
    const { report } = judge({ cmd: 'part', ...asked, part: 1, of: 1 });
    judge({ cmd: 'finish', ...asked, reports: [report] });
    judge.session = before;
  },

  /** Runs the solver's text, and returns what it claims. */
  async load({ text }) {
    address = URL.createObjectURL(new Blob([text], { type: 'text/javascript' }));
    post(0);
    try {
      const { solve, introduction } = introduce(await import(address), 'solver');
      judge.session = told_session(solve, introduction);
      return introduction;
    } finally {
      post(null);
    }
  },

  ask: ({ request }) => judge(request),
};

async function hear({ id, action, ...details }) {
  try {
    post({ id, reply: await actions[action](details), thrown });
  } catch (error) {
    post({ id, action, ...words_of(error) });
  }
}

self.addEventListener('message', ({ data, ports }) => {
  [port] = ports;
  port.onmessage = ({ data: asked }) => hear(asked);
  hear({ ...data, action: 'open' });
}, { once: true });
