// SPDX-License-Identifier: BSL-1.0
import { count, described, element, plural } from './elements.mjs';

const signs = { violated: '✗', holds: '✓', nothing: '○' };

/** The counts of each claimed invariant over all families. */
function counts_of(subject, invariants) {
  const rows = invariants.map(({ name, statement }) => {
    const counts = subject.families.map((family) => family.invariants[name]).filter(Boolean);
    const sum = (field) => counts.reduce((total, one) => total + one[field], 0);
    return { name, statement, is_claimed: counts.length > 0, holds: sum('holds'), violated: sum('violated') };
  });
  return rows.filter(({ is_claimed }) => is_claimed);
}

const kind_of = ({ violated, holds }) => (violated > 0 ? 'violated' : holds > 0 ? 'holds' : 'nothing');

/** One sentence for each status of a subject. */
function verdict_of(subject, rows) {
  const broken = rows.filter(({ violated }) => violated > 0).length;
  const cases = plural(subject.cases, 'case');
  switch (subject.status) {
    case 'sound':
      return `Sound. Each of ${plural(rows.length, 'claimed invariant')} holds in ${cases}.`;
    case 'violated':
      return `Violated. Of ${plural(rows.length, 'claimed invariant')}, ${broken} ${broken === 1 ? 'fails' : 'fail'} `
        + `in ${cases}.`;
    default:
      return `Not judged. ${subject.error || 'The judge could not judge this solver to the end.'}`;
  }
}

/** The table of invariants: the violated ones come first. */
function table_of(rows) {
  const order = ['violated', 'holds', 'nothing'];
  const sorted = [...rows].sort((one, two) => order.indexOf(kind_of(one)) - order.indexOf(kind_of(two)));
  const head = element('tr', {}, element('th', { scope: 'col' }, 'invariant'),
    ...['holds', 'violated'].map((title) => element('th', { scope: 'col', class: 'number' }, title)));
  const lines = sorted.map((row) => element('tr', { class: kind_of(row) },
    element('th', { scope: 'row' }, element('span', { class: 'sign', 'aria-hidden': 'true' }, signs[kind_of(row)]),
      element('code', {}, row.name), element('small', {}, row.statement)),
    element('td', { class: 'number' }, count(row.holds)),
    element('td', { class: 'number' }, count(row.violated))));
  return element('table', { class: 'invariants' },
    element('caption', { class: 'spoken' }, 'Claimed invariants, and in how many cases each holds or is violated'),
    element('thead', {}, head), element('tbody', {}, ...lines));
}

function diagnosis_of({ diagnosis }) {
  return (diagnosis?.faults ?? []).map(({ what, where, look_at }) => element('article', { class: 'diagnosis' },
    described({ 'what is wrong': what, where, 'look at': look_at })));
}

function unclaimed(subject, invariants, rows) {
  const names = invariants.map(({ name }) => name).filter((name) => !rows.some((row) => row.name === name));
  const text = `Not claimed by a solver of the law ${subject.model}, or not shown by this one: ${names.join(', ')}.`;
  return names.length === 0 ? [] : [element('p', { class: 'faint' }, text)];
}

/** The subject of a run as the subjects of its parts show it. */
export function sum_of(subjects) {
  const is_violated = subjects.some(({ status }) => status === 'violated');
  return {
    ...subjects[0],
    status: is_violated ? 'violated' : subjects.find(({ status }) => status !== 'sound')?.status ?? 'sound',
    cases: subjects.reduce((sum, { cases }) => sum + cases, 0),
    families: subjects.flatMap(({ families }) => families),
  };
}

const without_law = ({ model }) => (model === 'any'
  ? ' Without a law, Carom judges only what holds under every law. Choose a law, or export it.' : '');

/** The parts of a result: the verdict in one sentence, its look, what is wrong, and the invariants. */
export function result_of(subject, invariants) {
  const rows = counts_of(subject, invariants);
  return {
    subject,
    verdict: verdict_of(subject, rows),
    facts: `${subject.name}: law ${subject.model}, precision ${subject.precision}.${without_law(subject)}`,
    class: { sound: 'exit-0', violated: 'exit-1' }[subject.status] ?? 'exit-2',
    wrong: diagnosis_of(subject),
    table: [table_of(rows), ...unclaimed(subject, invariants, rows)],
  };
}
