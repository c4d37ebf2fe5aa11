// SPDX-License-Identifier: BSL-1.0
import { save, without_scripts } from './download.mjs';
import { show_line } from './editor.mjs';
import { by_id, element } from './elements.mjs';
import { Hang, Stopped } from './remote.mjs';
import { result_of, sum_of } from './result.mjs';
import { hanging, make_witness_panel, violating } from './witness_panel.mjs';
import { command_of, error_in_words, hang_in_words } from './words.mjs';

/** A box with a sentence, and a button that shows a line of the solver. */
function box(look, text, line) {
  const made = element('p', { class: `result ${look}` }, text);
  if (line) {
    const button = element('button', { type: 'button' }, `Show line ${line}`);
    button.addEventListener('click', () => show_line(by_id('text'), line));
    made.append(' ', button);
  }
  return made;
}

/** The invariant that a solver violates if it throws an error on a valid collision. */
const refuses_no_valid_collision = 'finite';

/** The cases of each family that the button `more` asks for. They suffice for most diagnoses. */
export const more_cases = 100;

const say = (text) => { by_id('state').textContent = text; };

/** The view of what the judge finds. */
export function make_view(remote, { invariants }) {
  const panel = make_witness_panel(remote);
  let html = '';

  by_id('save-report').addEventListener('click', () => save('report.html', 'text/html', without_scripts(html)));

  function clear() {
    by_id('results').classList.remove('old');
    by_id('verdict').replaceChildren();
    by_id('details').hidden = true;
    panel.hide();
  }

  function show_boxes({ result, ended_by, thrown }, verdict) {
    const boxes = [];
    const error = thrown && verdict?.subject.status !== 'sound'
      ? [box('exit-2', `solve threw an error: ${thrown.message.replace(/\.$/, '')}.`, thrown.line)] : [];
    const is_cause = verdict?.subject.violations?.some(({ invariant }) => invariant === refuses_no_valid_collision);
    if (ended_by instanceof Hang) {
      boxes.push(box('exit-1', hang_in_words(ended_by)));
    }
    if (verdict) {
      boxes.push(box(verdict.class, `${ended_by ? 'So far: ' : ''}${verdict.verdict}`));
    }
    if (verdict?.subject.error && verdict.subject.status === 'violated') {
      boxes.push(box('exit-2', `${verdict.subject.error.replace(/^it /, 'The solver ')}.`));
    }
    if (verdict) {
      boxes.push(element('p', { class: 'faint' }, verdict.facts));
    }
    by_id('verdict').replaceChildren(...(is_cause ? [...error, ...boxes] : [...boxes, ...error]));
    say(ended_by instanceof Stopped && !result ? 'Stopped before anything was judged.' : '');
  }

  function show_result({ asked, result }, verdict, settings) {
    html = result.files.find(({ file }) => file === 'report.html').text;
    by_id('wrong').hidden = verdict.wrong.length === 0;
    by_id('wrong').lastElementChild.replaceChildren(...verdict.wrong);
    by_id('invariants').lastElementChild.replaceChildren(...verdict.table);
    by_id('shell').textContent = command_of(asked, settings);
    by_id('more').hidden = asked.options.cases >= more_cases;
  }

  return {
    idle(text) {
      clear();
      say(text);
    },

    start() {
      clear();
      by_id('help').open = false;
      say('The solver is loading.');
      by_id('progress').value = 0;
    },

    progress(part) {
      by_id('progress').value = part;
      say(part < 1 ? `Judging: ${Math.round(100 * part)} %` : 'Looking for simple witnesses');
    },

    /** The run ended early, and the finished parts are summed up. */
    sums_up() {
      by_id('stop').disabled = true;
      say('Summing up what was judged');
    },

    /** Marks what is shown as older than the solver's text or the settings. */
    is_old() {
      if (by_id('verdict').hasChildNodes()) {
        by_id('results').classList.add('old');
        say('The solver or a setting has changed since this verdict. Press Judge.');
      }
    },

    /** Shows what the finished parts found. */
    found(subjects) {
      const verdict = result_of(sum_of(subjects), invariants);
      const so_far = verdict.subject.status === 'violated' ? '' : 'So far: ';
      by_id('verdict').replaceChildren(box(verdict.class, so_far + verdict.verdict));
      by_id('invariants').lastElementChild.replaceChildren(...verdict.table);
      by_id('details').hidden = by_id('invariants').hidden = false;
      by_id('next').hidden = by_id('same').hidden = by_id('wrong').hidden = true;
    },

    /** Shows a run that ended, perhaps early. */
    async show(run, settings) {
      const verdict = run.result && result_of(run.result.report.subjects[0], invariants);
      show_boxes(run, verdict);
      const hang = run.ended_by instanceof Hang && run.ended_by.collision ? [hanging(run.ended_by)] : [];
      const entries = [...hang, ...violating(run.result?.files ?? [])];
      by_id('details').hidden = !verdict && entries.length === 0;
      for (const id of ['next', 'invariants', 'same']) {
        by_id(id).hidden = !verdict;
      }
      by_id('wrong').hidden = true;
      if (verdict) {
        show_result(run, verdict, settings);
      }
      await panel.show(entries, hang[0]?.title ?? verdict?.subject.diagnosis?.telling, run.asked);
    },

    /** Shows why there is nothing to show. */
    fail(error) {
      clear();
      if (error instanceof Stopped) {
        say('Stopped before anything was judged.');
        return;
      }
      const { text, line } = error instanceof Hang ? { text: hang_in_words(error) } : error_in_words(error);
      say('');
      by_id('verdict').replaceChildren(box('exit-2', text, line));
    },
  };
}
