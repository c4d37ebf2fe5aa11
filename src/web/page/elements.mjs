// SPDX-License-Identifier: BSL-1.0

export const by_id = (id) => document.getElementById(id);

/** A new element. Its children are elements or texts. A text is never read as HTML. */
export function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value !== undefined && value !== false) {
      made.setAttribute(name, value === true ? '' : value);
    }
  }
  made.append(...children);
  return made;
}

/** A list of terms and their texts, without those that have no text. */
export function described(terms) {
  const rows = Object.entries(terms).filter(([, text]) => text);
  return element('dl', {}, ...rows.map(([term, text]) =>
    element('div', {}, element('dt', {}, term), element('dd', {}, text))));
}

export const count = (number) => Number(number).toLocaleString('en');

export const plural = (number, one, many = `${one}s`) => `${count(number)} ${number === 1 ? one : many}`;
