// SPDX-License-Identifier: BSL-1.0
import { by_id, element } from './elements.mjs';
import { make_editor } from './editor.mjs';
import { contents_of, link_of } from './link.mjs';
import { bytes_of, unpacked } from './packed.mjs';
import { Remote } from './remote.mjs';
import { judge_solver } from './run.mjs';
import { offer, settings_shown, show_ranges, show_settings } from './settings.mjs';
import { make_view } from './view.mjs';

const examples = JSON.parse(by_id('examples').textContent);
const editor = by_id('text');
let remote;
let view;
let is_judging = false;

function set_judging(value) {
  is_judging = value;
  by_id('judge').disabled = by_id('more').disabled = value;
  by_id('stop').disabled = by_id('progress').hidden = !value;
  by_id('results').setAttribute('aria-busy', value);
}

async function judge() {
  if (is_judging || !remote || !by_id('form').reportValidity()) {
    return;
  }
  set_judging(true);
  view.start();
  by_id('results').scrollIntoView({ block: 'nearest' });
  const settings = settings_shown();
  try {
    await view.show(await judge_solver(remote, editor.value, settings, view), settings);
    by_id('verdict').scrollIntoView({ block: 'nearest' });
  } catch (error) {
    view.fail(error);
  } finally {
    set_judging(false);
  }
}

function stop() {
  if (is_judging) {
    remote.stop();
  }
}

function show_example() {
  const { text } = examples[Number(by_id('example').value)] ?? examples[0];
  editor.value = text;
}

/** Whether the address names a part of the page, as the link to the editor does. */
const names_a_part = () => by_id(location.hash.slice(1)) !== null;

/** Shows the contents of the link, or the first example. It runs nothing. */
async function show_link() {
  stop();
  try {
    const contents = await contents_of(names_a_part() ? '' : location.hash);
    by_id('example').value = contents ? '' : '0';
    contents ? (editor.value = contents.text) : show_example();
    show_settings(contents);
    view.idle(contents ? 'The link holds this solver. It runs if you press Judge.' : 'Press Judge, or Ctrl and Enter.');
  } catch (error) {
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
  by_id('more').addEventListener('click', () => {
    by_id('cases').value = '1000';
    judge();
  });
  by_id('copy').addEventListener('click', copy_link);
  by_id('example').addEventListener('change', () => {
    show_example();
    show_settings({ ...settings_shown(), law: '', precision: '', domain: '' });
  });
  by_id('domain').addEventListener('change', show_ranges);
  editor.addEventListener('input', () => { by_id('example').value = ''; });
  by_id('form').addEventListener('input', () => { by_id('copied').textContent = ''; });
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
  by_id('example').append(element('option', { value: '', hidden: true }, 'your own'),
    ...examples.map(({ title }, i) => element('option', { value: String(i) }, title)));
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
