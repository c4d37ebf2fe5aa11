// SPDX-License-Identifier: BSL-1.0
import { Worker } from 'node:worker_threads';

import { UsageError } from '../solver/judge.mjs';

/** A judge in a thread of its own. It takes one request at a time. */
export class JudgeThread {
  #worker;
  #waiting;
  #end;  // why the thread ended

  constructor(source, timeout, introduction) {
    this.#worker = new Worker(new URL('./judge_worker.mjs', import.meta.url), {
      workerData: { source, timeout, introduction },
    });
    this.#worker.on('message', ({ reply, failure, done, all }) => {
      if (reply !== undefined) {
        this.#settle('resolve', reply);
      } else if (failure !== undefined) {
        this.#settle('reject', new (failure.is_usage ? UsageError : Error)(failure.message));
      } else {
        this.#waiting?.progress?.(done, all);
      }
    });
    const end_by = (error) => {
      this.#end ??= error;
      this.#settle('reject', this.#end);
    };
    this.#worker.on('error', end_by);
    this.#worker.on('exit', () => end_by(new Error('a thread of the judge ended')));
  }

  /** The judge's reply. `progress` is called with the numbers of done and of all cases. */
  ask(request, progress) {
    return new Promise((resolve, reject) => {
      this.#waiting = { resolve, reject, progress };
      if (this.#end === undefined) {
        this.#worker.postMessage(request);
      } else {
        reject(this.#end);
      }
    });
  }

  end() {
    return this.#worker.terminate();
  }

  #settle(how, value) {
    const waiting = this.#waiting;
    this.#waiting = undefined;
    waiting?.[how](value);
  }
}
