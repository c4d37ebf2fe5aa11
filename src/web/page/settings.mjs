// SPDX-License-Identifier: BSL-1.0
import { by_id, element } from './elements.mjs';

const own_ranges = 'ranges';
const specification = './solver.mjs';  // the file that the report's commands name
const names = ['law', 'precision', 'domain', 'ranges', 'cases', 'seed'];

function fill(select, entries) {
  select.append(...entries.map(({ name, summary }) =>
    element('option', { value: name }, summary ? `${name}: ${summary}` : name)));
}

/** Fills the choices with what the judge knows. The laws are those that claim an invariant. */
export function offer({ invariants, domains }) {
  fill(by_id('law'), [...new Set(invariants.flatMap(({ models }) => models))].map((name) => ({ name })));
  fill(by_id('domain'), domains);
  by_id('domain').append(element('option', { value: own_ranges }, 'other ranges'));
}

/** Shows the field for ranges only if it counts. */
export function show_ranges() {
  by_id('ranges-row').hidden = by_id('domain').value !== own_ranges;
}

/** The settings as the form shows them: texts. An empty text means that the solver's text decides. */
export function settings_shown() {
  return Object.fromEntries(names.map((name) => [name, by_id(name).value.trim()]));
}

/** Shows settings. Those that are absent or no choice get their default. */
export function show_settings(settings = {}) {
  for (const name of names) {
    const field = by_id(name);
    const value = typeof settings[name] === 'string' ? settings[name] : undefined;
    if (field.tagName === 'SELECT') {
      field.value = value ?? '';
      if (field.selectedIndex < 0) {
        field.selectedIndex = 0;
      }
    } else {
      field.value = value ?? field.defaultValue;
    }
  }
  show_ranges();
}

/** The subject and the options of a request: the solver's claims, as the settings change them. */
export function asked_by({ law, precision, domain, ranges, cases, seed }, introduction, environment) {
  const within = domain === own_ranges ? ranges : domain;
  return {
    subject: { ...introduction, ...(law && { model: law }), ...(precision && { precision }), specification },
    options: { cases: Number(cases), seed: seed || '1', ...(within && { within }), environment },
  };
}
