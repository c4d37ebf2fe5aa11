// SPDX-License-Identifier: BSL-1.0
// node --test colours_test.mjs: the colours of reports and replays, in light and in dark pages. Texts have a contrast
// of at least 4.5 with their background (WCAG 2.2, 1.4.3), and marks of at least 3 (1.4.11). Colours with different
// meanings differ for colour-blind readers, too.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

const root = new URL("../../../src/", import.meta.url);

/** The custom properties of the first and the second :root of a style: light and dark. */
function schemes_of(file) {
  const [light, dark] = [...readFileSync(new URL(file, root), "utf8").matchAll(/:root \{([^}]*)\}/g)]
    .map(([, text]) => Object.fromEntries([...text.matchAll(/--([\w-]+): (#[0-9a-f]+)/g)].map(([, name, colour]) => [name, colour])));
  return { light, dark: { ...light, ...dark } };
}

/** Linear red, green, blue in [0, 1]. */
function linear(colour) {
  const digits = colour.length === 4 ? [...colour.slice(1)].map((digit) => digit + digit) : colour.slice(1).match(/../g);
  return digits.slice(0, 3).map((digit) => parseInt(digit, 16) / 255).map((x) => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4));
}

const times = (matrix, vector) => matrix.map((row) => row.reduce((sum, x, i) => sum + x * vector[i], 0));
const luminance = (colour) => times([[0.2126, 0.7152, 0.0722]], linear(colour))[0];

function contrast(one, other) {
  const [less, more] = [luminance(one), luminance(other)].sort((a, b) => a - b);
  return (more + 0.05) / (less + 0.05);
}

/** The colours that people see, with all receptors or without red or green ones (Machado, Oliveira, Fernandes 2009). */
const eyes = {
  any: [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
  protanopia: [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
  deuteranopia: [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.01182, 0.04294, 0.968881]],
};

/** The distance in CIELAB. About 2 is just visible. */
function difference(one, other, eye) {
  const lab = (colour) => {
    const seen = times(eye, linear(colour)).map((x) => Math.min(Math.max(x, 0), 1));
    const white = [0.95047, 1, 1.08883];
    const [x, y, z] = times([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]], seen)
      .map((value, i) => value / white[i]).map((t) => (t > 0.008856 ? Math.cbrt(t) : 7.787 * t + 16 / 116));
    return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
  };
  const [a, b] = [lab(one), lab(other)];
  return Math.hypot(...a.map((x, i) => x - b[i]));
}

function check(scheme, { texts = [], marks = [], on, apart = [] }, where) {
  for (const paper of on) {
    for (const [names, least] of [[texts, 4.5], [marks, 3]]) {
      for (const name of names) {
        const ratio = contrast(scheme[name], scheme[paper]);
        assert.ok(ratio >= least, `${where}: ${name} on ${paper} has the contrast ${ratio.toFixed(1)}`);
      }
    }
  }
  for (const [eye, matrix] of Object.entries(eyes)) {
    apart.forEach((one, i) => apart.slice(i + 1).forEach((other) => {
      const far = difference(scheme[one], scheme[other], matrix);
      assert.ok(far >= 25, `${where}, ${eye}: ${one} and ${other} differ by ${far.toFixed(0)}`);
    }));
  }
}

for (const [name, scheme] of Object.entries(schemes_of("tool/replay/replay.css"))) {
  const phases = ["flying", "sliding", "rolling", "spinning", "resting"];
  const energies = ["kinetic", "spin", "potential", "lost", "total"];
  test(`replay, ${name}`, () => {
    check(scheme, { texts: ["ink", "faint", "accent"], marks: ["arrow"], on: ["paper", "raised", "stage-near", "stage-far"] }, name);
    check(scheme, { marks: phases, on: ["raised", "stage-near", "stage-far"], apart: phases }, name);
    check(scheme, { texts: energies, on: ["raised"], apart: energies }, name);
  });
}

for (const [name, scheme] of Object.entries(schemes_of("report/pages/report.css"))) {
  test(`report, ${name}`, () => {
    check(scheme, { texts: ["ink", "faint", "link", "bad"], on: ["paper", "raised", "bad-paper"] }, name);
    check(scheme, { texts: ["ink", "good"], on: ["paper", "good-paper"] }, name);
    check(scheme, { texts: ["ink"], on: ["odd-paper", ...Array.from({ length: 8 }, (_, i) => `shade-${i}`)] }, name);
    check(scheme, { texts: ["before", "computed", "exact"], on: ["raised"] }, name);
    for (const other of ["before", "exact"]) {
      check(scheme, { on: [], apart: ["computed", other] }, name);
    }
  });
}
