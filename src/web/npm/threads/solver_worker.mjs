// SPDX-License-Identifier: BSL-1.0
// Runs a solver's module, and answers batches of collisions in the shared memory.
import { writeSync } from 'node:fs';
import { workerData } from 'node:worker_threads';

import { InvalidAnswer, is_promise, message_of, write_refusal, write_result } from '../solver/answer.mjs';
import { answer_size, collision_at, collision_size } from '../solver/doubles.mjs';
import { flag, set_state, state, views_of } from './channel.mjs';
import { load_solver } from './load_solver.mjs';

const { source, buffer, port } = workerData;
const { flags, collisions, answers } = views_of(buffer);

/** The solver may print. Standard output belongs to the report, and the streams of a thread wait for other threads. */
function print_at_once() {
  for (const stream of [process.stdout, process.stderr]) {
    stream.write = (chunk, encoding, callback) => {
      try {
        writeSync(2, chunk);
      } catch {
        // Standard error is closed or full. The solver must not fail by that.
      }
      (typeof encoding === 'function' ? encoding : callback)?.();
      return true;
    };
  }
}

function end_with(failure, end) {
  port.postMessage({ failure });
  set_state(flags, end);
}

async function awaited(promise, has_matrix, at) {
  let result;
  try {
    result = await promise;
  } catch (thrown) {
    return write_refusal(answers, at, thrown);
  }
  return write_result(answers, at, result, has_matrix);
}

/** The text of the answer, or a promise of it. An async function would take longer for a solver that does not wait. */
function answer(solve, has_matrix, i) {
  const at = i * answer_size;
  let result;
  try {
    result = solve(collision_at(collisions, i * collision_size));
    if (is_promise(result)) {
      return awaited(result, has_matrix, at);
    }
  } catch (thrown) {
    return write_refusal(answers, at, thrown);
  }
  return write_result(answers, at, result, has_matrix);
}

async function answer_batch(solve, has_matrix) {
  const count = Atomics.load(flags, flag.count);
  for (let i = 0; i < count; ++i) {
    const text = await answer(solve, has_matrix, i);  // what the solver leaves to be done belongs to its collision
    if (text !== '') {
      port.postMessage({ i, text });
    }
    Atomics.store(flags, flag.done, i + 1);
  }
}

async function serve({ solve, introduction }) {
  port.postMessage({ introduction });
  for (;;) {
    set_state(flags, state.idle);
    while (Atomics.load(flags, flag.state) === state.idle) {
      Atomics.wait(flags, flag.state, state.idle);
    }
    try {
      await answer_batch(solve, introduction.matrix === true);
    } catch (error) {
      const why = error instanceof InvalidAnswer ? error.message : message_of(error);
      end_with(why, state.failed);
      return;
    }
  }
}

print_at_once();
process.on('uncaughtExceptionMonitor', (error) => port.postMessage({
  failure: `was ended by an error outside of solve: ${message_of(error)}` }));
process.on('exit', (code) => end_with(`ended with status ${code}`, state.ended));
const alive = setInterval(() => {}, 1e6);  // a promise that nothing settles is a hang, not the end of the thread
try {
  await serve(await load_solver(source));
} catch (error) {
  end_with(message_of(error), state.failed);
}
clearInterval(alive);
