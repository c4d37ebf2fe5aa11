// SPDX-License-Identifier: BSL-1.0

/** The text with U+FFFD in place of each surrogate that has no partner. Others cannot read such a text. */
export const well_formed = (text) => text.replace(/\p{Surrogate}/gu, '\ufffd');

function number_text(x) {
  if (Number.isFinite(x)) {
    return Object.is(x, -0) ? '-0.0' : String(x);
  }
  return Number.isNaN(x) ? '"nan"' : x > 0 ? '"inf"' : '"-inf"';
}

/** JSON that keeps −0, NaN and infinities, as the subject protocol writes them. `JSON.stringify` does not. */
export function exact_json(value) {
  if (typeof value === 'number') {
    return number_text(value);
  }
  if (Array.isArray(value) || ArrayBuffer.isView(value)) {
    return `[${Array.from(value, exact_json).join(',')}]`;
  }
  if (typeof value === 'object' && value !== null) {
    const members = Object.entries(value).filter(([, member]) => member !== undefined);
    return `{${members.map(([name, member]) => `${exact_json(name)}:${exact_json(member)}`).join(',')}}`;
  }
  return JSON.stringify(typeof value === 'string' ? well_formed(value) : value) ?? 'null';
}
