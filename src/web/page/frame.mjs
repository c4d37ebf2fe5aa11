// SPDX-License-Identifier: BSL-1.0
// The script of the sandboxed frame. It starts and ends the worker, and passes messages between the worker and the
// page. It also ends the worker if the solver does not return.
import { collision_size } from '../npm/solver/doubles.mjs';
import { unpacked } from './packed.mjs';
import { trusted } from './trusted.mjs';

const limit = 5000;  // milliseconds for one call of solve
const period = 100;  // milliseconds between two looks at the clock

let port;
let compiled;  // the judge, as a promise
let worker;
let channel;  // the frame's end of the channel to the worker
let batch;  // the collisions that the judge asks about
let index;  // of the collision that the solver works on, or null
let since;

function end() {
  worker?.terminate();
  if (channel) {
    channel.onmessage = null;  // what the ended worker told may still arrive
    channel.close();
  }
  worker = channel = undefined;
  batch = undefined;
  index = null;
}

function heard({ data }) {
  if (data instanceof Float64Array) {
    batch = data;
  } else if (data === null || typeof data === 'number') {
    index = data;
    since = performance.now();
  } else {
    port.postMessage(data);
  }
}

function address_of(code) {
  return trusted.createScriptURL(URL.createObjectURL(new Blob([code], { type: 'text/javascript' })));
}

/** Starts a worker. Returns the worker and its end of the channel. */
function start(code) {
  end();
  worker = new Worker(address_of(code));
  worker.onerror = (event) => event.preventDefault();  // a solver's timers may throw
  const { port1, port2 } = new MessageChannel();
  channel = port1;
  channel.onmessage = heard;
  return { started: worker, its_end: port2 };
}

/** Starts a worker with the judge. The frame keeps the compiled judge, so that the next worker starts faster. */
async function open({ id, code, wasm }) {
  const { started, its_end } = start(code);
  try {
    compiled ??= unpacked(wasm).then((bytes) => WebAssembly.compile(bytes));
    started.postMessage({ id, module: await compiled }, [its_end]);
  } catch (error) {
    port.postMessage({ id, action: 'open', error: error.message });
  }
}

function watch() {
  if (worker && index !== null && performance.now() - since > limit) {
    const numbers = batch?.slice(index * collision_size, (index + 1) * collision_size);
    end();
    port.postMessage({ hang: numbers ?? null, seconds: limit / 1000 });
  }
}

/** Finds the line of a syntax error. An import does not tell the line, but a script element does. Nothing runs. */
function locate({ id, text }) {
  const script = document.createElement('script');
  const done = (line) => {
    script.remove();
    removeEventListener('error', found);
    port.postMessage({ id, reply: line });
  };
  const found = (event) => {
    event.preventDefault();
    done(event.error instanceof SyntaxError ? event.lineno : undefined);
  };
  addEventListener('error', found);
  script.type = 'module';
  script.onload = () => done();
  script.onerror = () => done();
  script.src = address_of(`throw 0;${text}`);
  document.head.append(script);
}

function asked({ data: { action, ...message } }) {
  if (action === 'end') {
    end();
  } else if (action === 'open') {
    open(message);
  } else if (action === 'locate') {
    locate(message);
  } else {
    channel?.postMessage({ action, ...message });
  }
}

addEventListener('message', ({ source, ports }) => {
  if (source === parent && !port) {
    [port] = ports;
    port.onmessage = asked;
    setInterval(watch, period);
  }
});
