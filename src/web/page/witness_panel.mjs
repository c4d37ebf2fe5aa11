// SPDX-License-Identifier: BSL-1.0
import { collision_at } from '../npm/solver/doubles.mjs';
import { exact_json } from '../npm/solver/exact_json.mjs';
import { save } from './download.mjs';
import { drawn } from './drawing.mjs';
import { by_id, element } from './elements.mjs';
import { replayed } from './run.mjs';

const folder = 'witnesses/';
const features = /^ *features: .*\n/m;  // a long line that no reader needs here

/** An entry for each witness among the files of a report. */
export function violating(files) {
  return files.filter(({ file }) => file.startsWith(folder)).map(({ file, text }) => {
    const { invariant, statement } = JSON.parse(text);
    return { title: invariant, statement, file: file.slice(folder.length), text };
  });
}

/** The entry of the collision on which a solver did not return. */
export const hanging = ({ collision }) => ({
  title: 'none: solve did not return', statement: 'solve did not return on this collision.', file: 'collision.json',
  text: `${exact_json(collision_at(collision, 0))}\n`,
});

/** The part of the page that draws collisions and works them step by step. */
export function make_witness_panel(remote) {
  const which = by_id('which');
  let entries = [];
  let asked;

  const chosen = () => entries[Number(which.value)];

  async function draw() {
    const { statement } = chosen();
    by_id('statement').textContent = statement;
    let reply;
    try {
      reply = await replayed(remote, asked, chosen());
    } catch (error) {
      reply = { text: error.message };
    }
    by_id('steps').textContent = reply.text.replace(features, '');
    by_id('drawing').replaceChildren(...drawn(reply.drawing ?? ''));
  }

  which.addEventListener('change', draw);
  by_id('save-witness').addEventListener('click', () => {
    save(chosen().file, 'application/json', chosen().text);
  });

  return {
    hide() {
      by_id('witness').hidden = true;
    },

    /** Shows entries, the one with this title first. */
    async show(new_entries, title, new_asked) {
      entries = new_entries;
      asked = new_asked;
      by_id('witness').hidden = entries.length === 0;
      which.replaceChildren(...entries.map((entry, i) => element('option', { value: String(i) }, entry.title)));
      if (entries.length > 0) {
        which.value = String(Math.max(0, entries.findIndex((entry) => entry.title === title)));
        await draw();
      }
    },
  };
}
