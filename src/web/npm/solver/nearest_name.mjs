// SPDX-License-Identifier: BSL-1.0

/** The number of letters to add, to remove, to change, or to swap with a neighbour. */
export function edits_between(x, y) {
  const edits = Array.from({ length: x.length + 1 }, (_, i) => [i]);
  for (let j = 1; j <= y.length; ++j) {
    edits[0][j] = j;
  }
  for (let i = 1; i <= x.length; ++i) {
    for (let j = 1; j <= y.length; ++j) {
      const changed = edits[i - 1][j - 1] + (x[i - 1] === y[j - 1] ? 0 : 1);
      const is_swap = i > 1 && j > 1 && x[i - 1] === y[j - 2] && x[i - 2] === y[j - 1];
      edits[i][j] = Math.min(edits[i - 1][j] + 1, edits[i][j - 1] + 1, changed,
        is_swap ? edits[i - 2][j - 2] + 1 : Infinity);
    }
  }
  return edits[x.length][y.length];
}

/** "; did you mean 'NAME'?", to end an error message. Empty if no name is near, as in the native program. */
export function did_you_mean(word, names) {
  const most = Math.min(2, Math.floor(word.length / 3));
  const distances = [...names].map((name) => ({ name, edits: edits_between(word, name) }));
  const nearest = distances.reduce((best, one) => (one.edits < best.edits ? one : best), { edits: most + 1 });
  return nearest.name === undefined ? '' : `; did you mean '${nearest.name}'?`;
}
