// SPDX-License-Identifier: BSL-1.0
// Sentences of the page.

/** The sentence for an error that ended a run, and the line of the solver's text if it is known. */
export function error_in_words({ action, kind, message, line }) {
  if (/^within: /.test(message)) {
    return { text: `The domain is wrong: ${message.slice('within: '.length)}` };
  }
  if (action !== 'load') {
    return { text: `The judge cannot judge this solver: ${message}` };
  }
  if (/dynamically imported module|importing a module|module specifier/i.test(message)) {
    return { text: 'The solver does not load. A solver on this page cannot import other modules.' };
  }
  if (kind === 'SyntaxError') {
    return { text: `The solver is not valid JavaScript: ${message}.`, line };
  }
  return { text: `The solver does not load: ${message}`, line };
}

/** The sentence for a hang. */
export function hang_in_words({ collision, seconds }) {
  return collision
    ? `solve did not return within ${seconds} s, so the page ended it. The collision stands below.`
    : `The solver's text did not finish within ${seconds} s, so the page ended it.`;
}

/** The command of the npm package that judges the same. */
export function command_of({ options }, { law, precision }) {
  const quoted = (text) => (/^[\w=:.,+-]+$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`);
  const within = options.within ? ` --within ${quoted(options.within)}` : '';
  const claims = [law && `law = '${law}'`, precision && `precision = '${precision}'`].filter(Boolean);
  const first = claims.length > 0 ? `# solver.mjs states ${claims.join(' and ')}\n` : '';
  return `${first}npx carom gate ./solver.mjs --cases ${options.cases} --seed ${options.seed}${within}`;
}
