// SPDX-License-Identifier: BSL-1.0
// A link keeps the solver's text and the settings behind its #: JSON, compressed, in base64url.
import { bytes_of, packed, unpacked } from './packed.mjs';

const longest = 200_000;  // bytes of a link's contents, so that a small link cannot fill the memory
const form = '1.';        // the version of this form

/** The link, or undefined if the contents are too long for one. */
export async function link_of(contents) {
  const text = new TextEncoder().encode(JSON.stringify(contents));
  if (text.length > longest) {
    return undefined;
  }
  const bytes = await packed(text);
  const base64 = btoa(String.fromCharCode(...bytes));
  return `#${form}${base64.replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '')}`;
}

/** The contents of a link, or undefined if there are none. Throws an Error if the link is damaged. */
export async function contents_of(hash) {
  if (hash.length < 2) {
    return undefined;
  }
  try {
    if (!hash.startsWith(`#${form}`)) {
      throw new Error('unknown form');
    }
    const base64 = hash.slice(1 + form.length).replaceAll('-', '+').replaceAll('_', '/');
    const contents = JSON.parse(new TextDecoder().decode(await unpacked(bytes_of(base64), longest)));
    if (typeof contents?.text !== 'string') {
      throw new Error('no text');
    }
    return contents;
  } catch {
    throw new Error('This link is damaged, so the page shows an example in place of its solver.');
  }
}
