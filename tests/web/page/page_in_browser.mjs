// SPDX-License-Identifier: BSL-1.0
// Opens the page of the folder CAROM_PAGE in Chromium, and operates it.
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

import { Browser } from '../../tool/scene/browser.mjs';

const folder = process.env.CAROM_PAGE;
if (!folder) {
  throw new Error('CAROM_PAGE: expected the folder of the page');
}

export const page = pathToFileURL(join(folder, 'index.html')).href;
export const index_html = join(folder, 'index.html');

const is_idle = 'document.getElementById("stop").disabled && !document.getElementById("judge").disabled';

export class PageInBrowser extends Browser {
  static async make(width = 1280, height = 900) {
    const profile = mkdtempSync(join(tmpdir(), 'carom-page-'));
    const made = new PageInBrowser(process.env.CHROMIUM ?? 'chromium', profile, ['--js-flags=--liftoff-only']);
    made.profile = profile;
    await made.start(width, height);
    return made;
  }

  async stop() {
    await super.stop();
    rmSync(this.profile, { recursive: true, force: true });
  }

  /** Calls a function of the page with arguments that JSON can hold. */
  call(run, ...values) {
    return this.value(`(${run})(...${JSON.stringify(values)})`);
  }

  text(selector) {
    return this.call((of) => document.querySelector(of).innerText, selector);
  }

  set(id, value) {
    return this.call((of, to) => {
      const field = document.getElementById(of);
      field.value = to;
      for (const kind of field.tagName === 'SELECT' ? ['input', 'change'] : ['input']) {
        field.dispatchEvent(new Event(kind, { bubbles: true }));
      }
    }, id, value);
  }

  click(id) {
    return this.call((of) => document.getElementById(of).click(), id);
  }

  /** Presses a key with its code, so that its default action takes place. */
  async press(key, code, modifiers = 0) {
    for (const type of ['keyDown', 'keyUp']) {
      await this.ask('Input.dispatchKeyEvent', { type, key, code: key, windowsVirtualKeyCode: code, modifiers });
    }
  }

  idle() {
    return this.until(is_idle);
  }

  async judge() {
    await this.click('judge');
    await this.idle();
  }

  /** Judges a solver's text. Returns what the page says first. */
  async judge_text(text) {
    await this.set('text', text);
    await this.judge();
    return this.text('#verdict');
  }

  violated() {
    return this.call(() => [...document.querySelectorAll('.invariants .violated code')].map((node) => node.innerText));
  }

  hidden(id) {
    return this.call((of) => document.getElementById(of).hidden, id);
  }

  field(id) {
    return this.call((of) => document.getElementById(of).value, id);
  }

  examples() {
    return this.call(() => [...document.querySelectorAll('#example option:not([hidden])')].map(({ text }) => text));
  }

  async choose(title) {
    const value = await this.call((wanted) => [...document.querySelectorAll('#example option:not([hidden])')]
      .find(({ text }) => text === wanted)?.value, title);
    if (value === undefined) {
      throw new Error(`the page offers no example ${title}`);
    }
    await this.set('example', value);
  }

  /** The text of the sound example. */
  async sound() {
    await this.choose('Sound');
    return this.field('text');
  }
}
