// SPDX-License-Identifier: BSL-1.0
const prefixes = [["p", 1e-12], ["n", 1e-9], ["µ", 1e-6], ["m", 1e-3], ["", 1], ["k", 1e3], ["M", 1e6], ["G", 1e9]];

/** The SI prefix, as [letter, factor], with which a number of this size is written as a number from 1 to 1000. */
export function prefix_of(size) {
  const fitting = prefixes.filter(([, factor]) => Math.abs(size) >= factor * 0.9995);
  return size === 0 ? ["", 1] : fitting.at(-1) ?? prefixes[0];
}

/** Writes 2e+2 as 200. */
function plain(text) {
  return text.includes("e") ? String(Number(text)) : text;
}

/** A number with its unit, to `digits` significant digits. */
export function quantity(value, unit, digits = 4) {
  if (!Number.isFinite(value)) {
    return "–";
  }
  const [letter, factor] = prefix_of(value);
  const text = value === 0 ? "0" : plain((value / factor).toPrecision(digits));
  return `${text.replace("-", "−")} ${letter}${unit}`;
}
