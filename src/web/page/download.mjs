// SPDX-License-Identifier: BSL-1.0

// The solver shares a worker with the judge. So this policy comes first in the report: no script in it can run.
const policy = '<!DOCTYPE html><meta charset="utf-8"><meta http-equiv="Content-Security-Policy" '
  + 'content="default-src \'none\'; style-src \'unsafe-inline\'; base-uri \'none\'; form-action \'none\'">';

export const without_scripts = (html) => policy + html.replace(/^\s*<!DOCTYPE html>/i, '');

/** Lets the reader save a text as a file. */
export function save(name, type, text) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([text], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}
