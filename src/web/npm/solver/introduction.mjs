// SPDX-License-Identifier: BSL-1.0
import { shown } from './answer.mjs';
import { edits_between } from './nearest_name.mjs';

/** What a solver may claim: the exports of a module besides `solve`. */
export const claim_names = ['law', 'precision', 'name', 'version', 'domain', 'claims', 'matrix', 'deviates'];

/** The text "size=0.1:10,plane=xy" of a domain such as { size: [0.1, 10], plane: 'xy' }. */
export function domain_text(domain, place = 'domain') {
  if (typeof domain !== 'object' || domain === null) {
    return domain;
  }
  return Object.entries(domain).map(([quantity, range]) => {
    if (typeof range === 'string' && /^[A-Za-z_]+$/.test(range)) {
      return `${quantity}=${range}`;
    }
    const is_range = Array.isArray(range) && range.length === 2 &&
      range.every((end) => end === null || typeof end === 'number');
    if (!is_range) {
      throw new Error(`${place}: ${quantity}: expected the least and the greatest value, null for no limit, ` +
        'or the text of a kind');
    }
    return `${quantity}=${range.map((end) => end ?? '').join(':')}`;
  }).join(',');
}

/** Whether the name can hardly be meant otherwise: it differs in case, or in one letter of a long claim. */
function is_misspelling(name, claim) {
  const least_letters = 6;
  return name.toLowerCase() === claim || (claim.length >= least_letters && edits_between(name, claim) === 1);
}

/** Throws an Error if a field is a misspelt claim. A function is no claim. */
function refuse_misspelt(fields) {
  for (const [name, value] of Object.entries(fields)) {
    const meant = claim_names.find((claim) => is_misspelling(name, claim));
    if (!claim_names.includes(name) && typeof value !== 'function' && meant !== undefined) {
      throw new Error(`there is no claim '${name}'; did you mean '${meant}'?`);
    }
  }
}

/**
 * The function that solves, and what it claims, as the reply to `start` of the protocol. `exported` holds the exports
 * of a solver's module, or the same fields. Throws an Error that names the field.
 */
export function introduce(exported, default_name) {
  const { default: main, ...named } = exported;
  const fields = typeof main === 'object' && main !== null ? { ...main, ...named } : named;
  const solve = typeof main === 'function' ? main : fields.solve;
  if (typeof solve !== 'function') {
    throw new Error(`solve: expected a function, found ${shown(solve)}; ` +
      'write `export function solve(collision) { … }`');
  }
  refuse_misspelt(fields);
  const { law = 'any', precision = 'binary64', name = default_name, version = '' } = fields;
  const { domain, claims, deviates, matrix } = fields;
  const introduction = {
    protocol: 1, name, version, precision, model: law, deviates, matrix, domain: domain_text(domain), claims,
  };
  return { solve, introduction: JSON.parse(JSON.stringify(introduction)) };  // without the fields that are undefined
}
