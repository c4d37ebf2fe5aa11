// SPDX-License-Identifier: BSL-1.0

/** Round numbers from `least` to `greatest`. There are about `about` of them. */
export function ticks(least, greatest, about) {
  const span = greatest - least;
  if (!(span > 0)) {
    return [least];
  }
  const power = 10 ** Math.floor(Math.log10(span / about));
  const step = [1, 2, 5, 10].map((x) => x * power).find((x) => span / x <= about) ?? 10 * power;
  const all = [];
  for (let k = Math.ceil(least / step - 1e-9); k * step <= greatest + step * 1e-9; ++k) {
    all.push(k * step + 0); // no −0
  }
  return all;
}

/**
 * The path of a series. If several points are in one column of the screen, the path has only the first, the
 * least, the greatest and the last of them. The picture is the same.
 */
export function path_of(t, y, x_of, y_of) {
  const points = [];
  let column = [];
  const flush = () => {
    const values = column.map((i) => y[i]);
    const least = column[values.indexOf(Math.min(...values))];
    const greatest = column[values.indexOf(Math.max(...values))];
    points.push(...new Set([column[0], ...[least, greatest].sort((a, b) => a - b), column.at(-1)]));
    column = [];
  };
  for (let i = 0; i < t.length; ++i) {
    if (Number.isFinite(y[i])) {
      if (column.length > 0 && (Math.floor(x_of(t[column[0]])) !== Math.floor(x_of(t[i])) || column.length > 5000)) {
        flush();
      }
      column.push(i);
    }
  }
  if (column.length > 0) {
    flush();
  }
  return points.map((i, n) => `${n ? "L" : "M"}${x_of(t[i]).toFixed(2)} ${y_of(y[i]).toFixed(2)}`).join("");
}

/** The value of a series at a time, interpolated linearly. If two points have one time, the later one counts. */
export function value_at(t, y, time) {
  let low = 0;
  let high = t.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (t[middle] <= time) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  if (low === 0 || low === t.length) {
    return y[low === 0 ? 0 : t.length - 1];
  }
  const share = (time - t[low - 1]) / (t[low] - t[low - 1]);
  return y[low - 1] + (y[low] - y[low - 1]) * share;
}

/** The heights, moved at least `gap` apart in their order, and if there is room between `least` and `greatest`. */
export function spread(heights, gap, least, greatest) {
  const order = heights.map((_, i) => i).sort((a, b) => heights[a] - heights[b]);
  const moved = [];
  order.forEach((i, n) => { moved[i] = Math.max(heights[i], n ? moved[order[n - 1]] + gap : least); });
  order.reverse().forEach((i, n) => { moved[i] = Math.min(moved[i], n ? moved[order[n - 1]] - gap : greatest); });
  return moved;
}
