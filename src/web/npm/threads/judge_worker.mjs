// SPDX-License-Identifier: BSL-1.0
// A judge that answers the requests of the main thread, and asks a solver in another thread.
import { parentPort, workerData } from 'node:worker_threads';

import { UsageError } from '../solver/judge.mjs';
import { load_judge } from './node_judge.mjs';
import { remote_session } from './remote_session.mjs';

const judge = await load_judge();
const session = remote_session(workerData.source, workerData.timeout, workerData.introduction);
judge.session = session;
judge.progress = (done, all) => parentPort.postMessage({ done, all });
parentPort.on('message', (request) => {
  session.continues = request.cmd === 'part';  // loading a module takes longer than many cases
  try {
    parentPort.postMessage({ reply: judge(request) });
  } catch (error) {
    parentPort.postMessage({ failure: { message: error.message, is_usage: error instanceof UsageError } });
  }
});
