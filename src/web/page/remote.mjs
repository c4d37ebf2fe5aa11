// SPDX-License-Identifier: BSL-1.0
import { trusted } from './trusted.mjs';

/** The reader stopped the judge. */
export class Stopped extends Error {}

/** The solver did not return. `collision` holds the 45 doubles of its collision, or is null if the text is loading. */
export class Hang extends Error {
  constructor({ hang, seconds }) {
    super(`solve did not return within ${seconds} s`);
    this.collision = hang;
    this.seconds = seconds;
  }
}

/** An error in the solver's text, or a usage error that the judge tells. */
export class Told extends Error {
  constructor({ error, action, kind, line }) {
    super(error);
    this.action = action;
    this.kind = kind;
    this.line = line;
  }
}

/** Asks the worker in the sandboxed frame, whose contents the attribute `data-contents` of its element holds. */
export class Remote {
  constructor(frame, { code, wasm }) {
    this.contents = { code, wasm };
    this.latest = 0;
    this.waiting = new Map();
    const { port1, port2 } = new MessageChannel();
    this.port = port1;
    this.port.onmessage = ({ data }) => this.hear(data);
    frame.onload = () => frame.contentWindow.postMessage(null, '*', [port2]);
    frame.srcdoc = trusted.createHTML(frame.dataset.contents);
  }

  hear(data) {
    if ('hang' in data) {
      this.forget();
      this.reject_all(new Hang(data));
      return;
    }
    if ('progress' in data) {
      this.progress?.(data.progress);
      return;
    }
    const { resolve, reject } = this.waiting.get(data.id) ?? {};
    this.waiting.delete(data.id);
    if ('error' in data) {
      reject?.(new Told(data));
    } else {
      this.thrown = data.thrown;
      resolve?.(data.reply);
    }
  }

  /** The worker is gone. What it told of its progress may still arrive. */
  forget() {
    this.opened = this.progress = undefined;
    this.is_used = this.has_solver = false;
  }

  reject_all(error) {
    this.waiting.forEach(({ reject }) => reject(error));
    this.waiting.clear();
  }

  send(action, details) {
    const id = ++this.latest;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject });
      this.port.postMessage({ id, action, ...details });
    });
  }

  /** Starts a worker without a solver, unless there is one. */
  async open() {
    this.opened ??= this.send('open', this.contents);
    await this.opened;
  }

  /** Lets the worker judge a little in advance. It is no matter if this ends early. */
  warm() {
    this.is_used = true;
    this.send('warm').then(() => { this.is_used = false; }, () => {});
  }

  /** Starts a worker that no solver has used. */
  async fresh() {
    if (this.is_used) {
      this.stop();
    }
    await this.open();
  }

  /** Runs the text of a solver in the worker. Returns what the solver claims. */
  async load(text) {
    this.has_solver = this.is_used = true;
    try {
      return await this.send('load', { text });
    } catch (error) {
      if (error.kind === 'SyntaxError') {
        error.line ??= await this.send('locate', { text });
      }
      throw error;
    }
  }

  /** The reply to a request of the judge. */
  ask(request) {
    return this.send('ask', { request });
  }

  /** Ends the worker. */
  stop() {
    this.port.postMessage({ action: 'end' });
    this.forget();
    this.reject_all(new Stopped());
  }
}
