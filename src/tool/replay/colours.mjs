// SPDX-License-Identifier: BSL-1.0

/** A hue for each body, by the golden angle, at about equal brightness: linear red, green, blue in [0, 1]. */
export function hue_of(index) {
  const angle = (0.62 + index * 0.3819660112501051) * 2 * Math.PI;
  return from_oklch(0.62 + 0.07 * ((index * 0.7548776662466927) % 1 - 0.5), 0.15, angle);
}

function from_oklch(lightness, chroma, angle) {
  const a = chroma * Math.cos(angle);
  const b = chroma * Math.sin(angle);
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
  const linear = [4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s];
  return linear.map((x) => Math.min(Math.max(x, 0), 1));
}
