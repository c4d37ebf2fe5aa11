// SPDX-License-Identifier: BSL-1.0
import { by_id, element } from './elements.mjs';
import { make_editor } from './editor.mjs';
import { contents_of, link_of } from './link.mjs';
import { bytes_of, unpacked } from './packed.mjs';
import { Remote } from './remote.mjs';
import { judge_solver } from './run.mjs';
import { offer, settings_shown, show_ranges, show_settings } from './settings.mjs';
import { make_view, more_cases } from './view.mjs';

const examples = JSON.parse(by_id('examples').textContent);
const editor = by_id('text');
let remote;
let view;
let is_judging = false;
let is_changed = false;  // since the last run began
let own = '';            // the text that the reader typed
let linked = '';         // the text of the link

function set_judging(value) {
  is_judging = value;
  by_id('judge').disabled = by_id('more').disabled = value;
  by_id('stop').disabled = by_id('progress').hidden = !value;
  by_id('results').setAttribute('aria-busy', value);
}

async function judge(more = {}) {
  if (is_judging || !remote || !by_id('form').reportValidity()) {
    return;
  }
  set_judging(true);
  is_changed = false;
  view.start();
  by_id('results').scrollIntoView({ block: 'nearest' });
  const settings = { ...settings_shown(), ...more };
  try {
    await view.show(await judge_solver(remote, editor.value, settings, view), settings);
    by_id('verdict').scrollIntoView({ block: 'nearest' });
  } catch (error) {
    view.fail(error);
  } finally {
    set_judging(false);
    if (is_changed) {
      view.is_old();
    }
  }
}

function changed() {
  is_changed = true;
  by_id('copied').textContent = '';
  if (!is_judging) {
    view.is_old();
  }
}

function stop() {
  if (!by_id('stop').disabled) {
    remote.stop();
  }
}

function show_example() {
  const { value } = by_id('example');
  editor.value = { own, linked }[value] ?? examples[Number(value)].text;
}

/** Keeps the reader's text, so that it can be chosen after an example, or after the page is loaded again. */
function keep_own() {
  own = editor.value;
  by_id('own').hidden = false;
  by_id('example').value = 'own';
  try {
    sessionStorage.setItem('carom', own);
  } catch {
    // The browser keeps nothing for this page.
  }
}

function recall_own() {
  try {
    own = sessionStorage.getItem('carom') ?? '';
  } catch {
    own = '';
  }
  by_id('own').hidden = own === '';
}

/** Whether the address names a part of the page, as the link to the editor does. */
const names_a_part = () => by_id(location.hash.slice(1)) !== null;

/** Shows the contents of the link, or the first example. It runs nothing. */
async function show_link() {
  stop();
  is_changed = true;
  try {
    const contents = await contents_of(names_a_part() ? '' : location.hash);
    linked = contents?.text ?? '';
    by_id('linked').hidden = !contents;
    by_id('example').value = contents ? 'linked' : '0';
    show_example();
    show_settings(contents);
    view.idle(contents ? 'The link holds this solver. It runs if you press Judge.' : 'Press Judge, or Ctrl and Enter.');
  } catch (error) {
    by_id('example').value = '0';
    show_example();
    show_settings();
    view.idle(error.message);
  }
}

async function copy_link() {
  const link = await link_of({ text: editor.value, ...settings_shown() });
  if (link === undefined) {
    by_id('copied').textContent = 'The solver is too long for a link.';
    return;
  }
  history.replaceState(null, '', link);
  const copied = await navigator.clipboard?.writeText(location.href).then(() => true, () => false);
  by_id('copied').textContent = copied ? 'The link is copied.' : 'The address bar holds the link.';
}

function link_docs() {
  const { docs } = by_id('docs').dataset;
  for (const link of by_id('docs').querySelectorAll('[data-page]')) {
    link.href = docs + link.dataset.page;
  }
  by_id('docs').hidden = docs === '';
}

function listen() {
  by_id('form').addEventListener('submit', (event) => {
    event.preventDefault();
    judge();
  });
  by_id('stop').addEventListener('click', stop);
  by_id('more').addEventListener('click', () => judge({ cases: String(more_cases) }));
  by_id('copy').addEventListener('click', copy_link);
  by_id('example').addEventListener('change', () => {
    show_example();
    show_settings({ ...settings_shown(), law: '', precision: '', domain: '' });
  });
  by_id('domain').addEventListener('change', show_ranges);
  editor.addEventListener('input', keep_own);
  by_id('form').addEventListener('input', changed);
  document.addEventListener('keydown', (event) => {
    if (event.key === 'Escape') {
      stop();
    } else if (event.key === 'Enter' && (event.ctrlKey || event.metaKey)) {
      event.preventDefault();
      judge();
    }
  });
  addEventListener('hashchange', () => {
    if (!names_a_part()) {
      show_link();
    }
  });
}

/** Starts a judge without a solver, so that the first verdict comes sooner. */
async function open_judge() {
  const code = new TextDecoder().decode(await unpacked(bytes_of(by_id('worker').textContent)));
  const opened = new Remote(by_id('frame'), { code, wasm: bytes_of(by_id('wasm').textContent) });
  await opened.open();
  const lists = {};
  for (const what of ['domains', 'invariants']) {
    lists[what] = await opened.ask({ cmd: 'list', what });
  }
  const { version } = await opened.ask({ cmd: 'version' });
  by_id('version').textContent = `This is version ${version}.`;
  offer(lists);
  view = make_view(opened, lists);
  remote = opened;
}

async function begin() {
  by_id('example').append(...examples.map(({ title }, i) => element('option', { value: String(i) }, title)),
    element('option', { id: 'linked', value: 'linked', hidden: true }, 'from the link'),
    element('option', { id: 'own', value: 'own', hidden: true }, 'your own'));
  recall_own();
  link_docs();
  make_editor(editor);
  show_example();
  by_id('example').value = '0';
  try {
    await open_judge();
  } catch (error) {
    by_id('state').textContent = `The judge does not run in this browser: ${error.message ?? error}`;
    return;
  }
  listen();
  await show_link();
  set_judging(false);
  remote.warm();
  document.body.dataset.ready = 'true';
}

begin();
