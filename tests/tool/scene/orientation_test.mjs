// SPDX-License-Identifier: BSL-1.0
// node --test orientation_test.mjs: orientations and positions of bodies between the starts of their arcs.
import assert from "node:assert/strict";
import { test } from "node:test";

import { Motion } from "../../../src/tool/replay/motion.mjs";
import { Orientations, steps_of, turned } from "../../../src/tool/replay/orientation.mjs";
import { product, turn } from "../../../src/tool/replay/quaternion.mjs";

const identity = [1, 0, 0, 0];

/** The angle between two orientations, from their difference. The cosine of a small angle loses half the digits. */
function angle_between(p, q) {
  const sign = p.reduce((sum, x, i) => sum + x * q[i], 0) < 0 ? -1 : 1;
  return 4 * Math.asin(Math.min(1, Math.hypot(...p.map((x, i) => x - sign * q[i])) / 2));
}

/** Integrates the rotation in `steps` steps, each about the angular velocity at the middle of the step. */
function finely_turned(w, b, duration, steps) {
  let q = identity;
  const h = duration / steps;
  for (let step = 0; step < steps; ++step) {
    q = product(turn(w.map((x, i) => (x + b[i] * (step + 0.5) * h) * h)), q);
  }
  return q;
}

const changing = [
  [[3, 0, 0], [0, 2, 0], 2],
  [[10, -4, 7], [-12, 9, 3], 1],
  [[0, 0, 0], [1, 0, 0], 3],
  [[60, 0, 20], [-20, 35, 0], 2],
  [[0, 5, 0], [0, -10, 1e-3], 1],
];

test("one turn about any axis is the identity", () => {
  for (const w of [[2, 0, 0], [0, -3, 0], [1, 2, 2], [100, -30, 5]]) {
    const period = 2 * Math.PI / Math.hypot(...w);
    // The error is at most a hundred roundings of a number of size one.
    assert.ok(angle_between(turned(identity, w, [0, 0, 0], period), identity) < 100 * 2 ** -52);
  }
});

test("a quarter turn goes the right way round", () => {
  const [w, x, y, z] = turned(identity, [0, 0, Math.PI / 2], [0, 0, 0], 1);
  assert.ok(Math.abs(w - Math.SQRT1_2) < 1e-15 && Math.abs(z - Math.SQRT1_2) < 1e-15 && x === 0 && y === 0);
});

test("turns about the world's axes follow each other on the left", () => {
  const first = turned(identity, [0, 0, Math.PI / 2], [0, 0, 0], 1);
  const both = turned(first, [Math.PI / 2, 0, 0], [0, 0, 0], 1);
  assert.ok(angle_between(both, product(turn([Math.PI / 2, 0, 0]), turn([0, 0, Math.PI / 2]))) < 1e-14);
});

test("about one axis, a rate that changes is integrated in one step", () => {
  assert.equal(steps_of([0, 0, 40], [0, 0, -20], 2), 1);
  assert.ok(angle_between(turned(identity, [0, 0, 40], [0, 0, -20], 2), turn([0, 0, 40])) < 1e-13);
});

test("an angular velocity that turns is as in fine steps", () => {
  for (const [w, b, duration] of changing) {
    const [coarse, fine] = [2e5, 4e5].map((steps) => finely_turned(w, b, duration, steps));
    // The method is of second order, so the difference between `coarse` and `fine` exceeds the error of `fine`.
    const own = angle_between(coarse, fine);
    const off = angle_between(turned(identity, w, b, duration), fine);
    assert.ok(off < 1e-5 + own, `${w} + ${b} s: ${off}`);
    assert.ok(own < 1e-6, `${own}`);
  }
});

test("its error goes down by the fourth power of the steps", () => {
  for (const [w, b, duration] of changing.filter(([v, c]) => steps_of(v, c, 1) > 1)) {
    const steps = 4 * steps_of(w, b, duration);
    const exact = turned(identity, w, b, duration, 16 * steps);
    const ratio = angle_between(turned(identity, w, b, duration, steps), exact)
      / angle_between(turned(identity, w, b, duration, 2 * steps), exact);
    assert.ok(ratio > 12 && ratio < 20, `${w} + ${b} s: ${ratio}`);
  }
});

test("the orientation at a time does not depend on the times asked before", () => {
  const arcs = changing.map(([w, b], index) => ({ start: index, end: index + 1, w, b, q: undefined }));
  const one = new Orientations(arcs);
  const two = new Orientations(arcs);
  const times = [0, 0.3, 0.99, 1, 1.7, 2.2, 3.5, 4.999, 5];
  const index_of = (time) => Math.min(Math.floor(time), 4);
  const forward = times.map((time) => one.at(index_of(time), time));
  const backward = [...times].reverse().map((time) => two.at(index_of(time), time)).reverse();
  assert.deepEqual(forward, backward);
});

test("nothing jumps where an arc or a part of one ends", () => {
  const arcs = changing.map(([w, b], index) => ({ start: index, end: index + 1, w, b, q: undefined }));
  const all = new Orientations(arcs);
  const [count, fastest] = [20000, 100];
  let before = all.at(0, 0);
  for (let n = 1; n <= count; ++n) {
    const time = n * 5 / count;
    const now = all.at(Math.min(Math.floor(time), 4), time);
    assert.ok(angle_between(before, now) <= fastest * 5 / count + 2e-5, `at ${time}`);
    before = now;
  }
});

test("arcs of polyhedra begin in the orientation that is given", () => {
  const q = turn([0.3, -1, 2]);
  const arc = (t, phase, ...more) => [t, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 4, 0, 0, 0, phase, ...more];
  const motion = new Motion([arc(0, "flying", ...identity), arc(1, "sliding", ...q)], 2);
  assert.ok(angle_between(motion.at(1).orientation, q) < 1e-15);
  assert.ok(angle_between(motion.at(1.5).orientation, product(turn([0, 0, 2]), q)) < 1e-14);
  assert.equal(motion.at(1.5).phase, 1);
});

test("positions are those of the arc that has begun, whichever way time goes", () => {
  const arc = (t, x, v, a) => [t, x, 0, 0, v, 0, 0, a, 0, 0, 0, 0, 0, 0, 0, 0, "flying"];
  const motion = new Motion([arc(0, 0, 1, 0), arc(1, 1, -2, 4), arc(3, 5, 0, 0)], 4);
  const x_at = (time) => motion.at(time).position[0];
  for (const [time, x] of [[0.5, 0.5], [3.5, 5], [1, 1], [0.25, 0.25], [2, 1], [4, 5], [2.5, 2.5]]) {
    assert.equal(x_at(time), x, `at ${time}`);
  }
  assert.deepEqual(motion.extent(4).map(([x]) => x), [0, 5]);
  assert.deepEqual(motion.at(2).velocity, [2, 0, 0]);
});
