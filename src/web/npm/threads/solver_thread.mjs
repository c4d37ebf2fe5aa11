// SPDX-License-Identifier: BSL-1.0
import { MessageChannel, receiveMessageOnPort, Worker } from 'node:worker_threads';

import { answer_size, collision_size } from '../solver/doubles.mjs';
import { capacity, flag, new_buffer, set_state, state, views_of } from './channel.mjs';

const shortest_start = 10;  // [s]; a busy machine needs a second or two to load an engine

/** A solver's module in a thread of its own, which is asked without the event loop of this thread. */
export class SolverThread {
  #views;
  #worker;
  #port;
  #timeout;

  /** Throws an Error with the reason if the module cannot be loaded. `timeout` is the limit of a call of solve [s]. */
  constructor(source, timeout) {
    this.#timeout = timeout;
    const buffer = new_buffer();
    this.#views = views_of(buffer);
    const { port1, port2 } = new MessageChannel();
    this.#port = port1;
    port1.unref();
    set_state(this.#views.flags, state.asked);
    this.#worker = new Worker(new URL('./solver_worker.mjs', import.meta.url), {
      workerData: { source, buffer, port: port2 },
      transferList: [port2],
    });
    this.#worker.on('error', () => {});  // the flags tell
    this.#worker.unref();
    const start = Math.max(timeout, shortest_start);
    const { failure, messages } = this.#wait(`loading the module did not end within ${start} s`, start);
    if (failure !== undefined) {
      this.end();
      throw new Error(failure);
    }
    this.introduction = messages[0].introduction;
  }

  /**
   * Asks the solver. Returns its texts by the number of the collision, and how many collisions it answered. If it
   * failed, `failure` says why.
   */
  solve(collisions, count, answers) {
    const texts = new Map();
    for (let first = 0; first < count; first += capacity) {
      const size = Math.min(capacity, count - first);
      const { answered, failure } = this.#solve_batch(collisions, first, size, texts);
      answers.set(this.#views.answers.subarray(0, answered * answer_size), first * answer_size);
      if (failure !== undefined) {
        return { texts, answered: first + answered, failure };
      }
    }
    return { texts, answered: count };
  }

  end() {
    this.#port.close();
    return this.#worker.terminate();
  }

  #solve_batch(collisions, first, size, texts) {
    const { flags } = this.#views;
    this.#views.collisions.set(collisions.subarray(first * collision_size, (first + size) * collision_size));
    Atomics.store(flags, flag.count, size);
    Atomics.store(flags, flag.done, 0);
    set_state(flags, state.asked);
    const { failure, messages, done: answered } = this.#wait(`did not return within ${this.#timeout} s`, this.#timeout);
    for (const { i, text } of messages) {
      if (i < answered) {
        texts.set(first + i, text);
      }
    }
    return { answered, failure };
  }

  /**
   * Waits until the solver has done what it was asked. Returns its messages, how many collisions it had done at the end
   * of the wait, and why it failed, if it did.
   */
  #wait(too_late, timeout) {
    const { in_time, done } = this.#waits_in_time(timeout);
    const messages = [];
    for (let next = receiveMessageOnPort(this.#port); next; next = receiveMessageOnPort(this.#port)) {
      messages.push(next.message);
    }
    if (!in_time) {
      return { messages, done, failure: too_late };
    }
    const is_idle = Atomics.load(this.#views.flags, flag.state) === state.idle;
    const told = messages.find((message) => message.failure !== undefined)?.failure ?? 'ended its thread';
    return { messages, done, failure: is_idle ? undefined : told };
  }

  /** Whether the solver does what it was asked, and no collision takes longer than the timeout. */
  #waits_in_time(timeout) {
    const { flags } = this.#views;
    let done = 0;
    let since = performance.now();
    // A notification can come late, and then ends the wait of the next batch. So the state alone tells.
    while (Atomics.load(flags, flag.state) === state.asked) {
      if (Atomics.wait(flags, flag.state, state.asked, Math.min(50, 125 * timeout)) !== 'timed-out') {
        continue;
      }
      const now = performance.now();
      const done_now = Atomics.load(flags, flag.done);
      if (done_now !== done) {
        [done, since] = [done_now, now];
      } else if (now - since >= 1000 * timeout) {
        return { in_time: false, done };
      }
    }
    return { in_time: true, done: Atomics.load(flags, flag.done) };
  }
}
