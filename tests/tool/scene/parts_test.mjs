// SPDX-License-Identifier: BSL-1.0
// node --test parts_test.mjs: the parts of the page of replays that draw nothing by themselves.
import assert from "node:assert/strict";
import { test } from "node:test";

import { path_of, spread, ticks, value_at } from "../../../src/tool/replay/chart_parts.mjs";
import { dot } from "../../../src/tool/replay/quaternion.mjs";
import { face_of, grid_on, grid_step, half_spaces, steepness } from "../../../src/tool/replay/region.mjs";
import { count_up_to, radius_of, read } from "../../../src/tool/replay/replay_data.mjs";
import { quantity } from "../../../src/tool/replay/units.mjs";

const up = [0, 0, 1];
const box = [[-1, -2, 0], [1, 2, 3]];

test("a room has six faces of four corners, each on its plane and within the others", () => {
  const spaces = half_spaces([], { least: box[0], greatest: box[1] }, box);
  assert.equal(spaces.length, 6);
  spaces.forEach((space, index) => {
    const corners = face_of(index, spaces, 5, up);
    assert.equal(corners.length, 4);
    for (const { point, behind } of corners) {
      assert.ok(Math.abs(dot(space.normal, point) - space.offset) < 1e-9);
      assert.ok(spaces.every(({ normal, offset }) => dot(normal, point) >= offset - 1e-6));
      assert.ok(behind >= 0 && behind !== index);
    }
  });
});

test("planes that are the room's walls are not drawn twice", () => {
  const floor = { normal: [0, 0, 2], point: [7, 7, 0] };
  assert.equal(half_spaces([floor], { least: box[0], greatest: box[1] }, box).length, 6);
});

test("a ramp ends where it meets the floor", () => {
  const spaces = half_spaces([{ normal: up, point: [0, 0, 0] }, { normal: [-1, 0, 1], point: [0, 0, 0] }], null, box);
  assert.equal(spaces.filter(({ real }) => real).length, 2);
  const floor = face_of(0, spaces, 5, up).map(({ point }) => point[0]);
  const ramp = face_of(1, spaces, 5, up).map(({ point }) => point);
  assert.ok(Math.max(...floor) < 1e-5);
  assert.ok(ramp.every(([x, , z]) => x > -1e-5 && Math.abs(x - z) < 1e-9));
});

test("the lines of a grid lie on the face, a step apart", () => {
  const spaces = half_spaces([], { least: box[0], greatest: box[1] }, box);
  const index = spaces.findIndex(({ normal }) => normal[2] === 1);
  const lines = grid_on(face_of(index, spaces, 5, up), up, 0.5, up);
  assert.equal(lines.length, 3 + 7);
  assert.ok(lines.flat().every(([x, y, z]) => Math.abs(x) < 1.0001 && Math.abs(y) < 2.0001 && Math.abs(z) < 1e-6));
  assert.equal(grid_step(24, 24), 1);
  assert.equal(grid_step(3, 24).toPrecision(3), "0.200");
});

test("one looks onto a table from further above than into a room", () => {
  assert.equal(steepness(box, up), 0.5);
  assert.equal(steepness([[0, 0, 0], [10, 5, 1]], up), 0.5 + 2 * (0.9 - 0.6));
  assert.equal(steepness([[0, 0, 0], [10, 5, 1]], [-1, 0, 0]), 0.5);
});

test("a replay that ends before its scene knows of how much it is a part", () => {
  assert.equal(read('{"duration": 3}').of_duration, 3);
  assert.equal(read('{"duration": 3, "of_duration": 35}').of_duration, 35);
});

test("ticks are round and within", () => {
  assert.deepEqual(ticks(0, 10, 5), [0, 2, 4, 6, 8, 10]);
  assert.deepEqual(ticks(-3, 3, 3), [-2, 0, 2]);
  assert.deepEqual(ticks(1, 1, 5), [1]);
});

test("a path with many points to a column keeps the extremes", () => {
  const t = Array.from({ length: 100000 }, (_, i) => i / 100000);
  const y = t.map((_, i) => (i === 54321 ? 7 : i === 54322 ? -7 : 0));
  const path = path_of(t, y, (x) => x * 300, (x) => x);
  assert.ok(path.includes(" 7.00") && path.includes(" -7.00"));
  assert.ok(path.split("L").length <= 4 * 300);
  assert.equal(path_of([0, 1], [1, 2], (x) => 10 * x, (x) => x), "M0.00 1.00L10.00 2.00");
});

test("names at the ends of lines are apart, in the order of the ends", () => {
  assert.deepEqual(spread([50, 0, 49, 98, 99], 10, 5, 100), [59, 5, 49, 90, 100]);
});

test("values of a series are in a straight line between its points, and jump where it jumps", () => {
  const [t, y] = [[0, 1, 1, 2], [0, 2, 5, 5]];
  for (const [time, value] of [[-1, 0], [0, 0], [0.5, 1], [1, 5], [1.5, 5], [9, 5]]) {
    assert.equal(value_at(t, y, time), value, `at ${time}`);
  }
});

test("numbers are counted up to one", () => {
  const numbers = [1, 2, 2, 3];
  assert.deepEqual([0, 1, 2, 2.5, 9].map((x) => count_up_to(4, (i) => numbers[i], x)), [0, 1, 3, 3, 4]);
});

test("quantities have the prefix that suits them", () => {
  assert.deepEqual([0, 1.5, -0.00123, 12345, 0.2, Number.NaN].map((x) => quantity(x, "J", 3)),
    ["0 J", "1.50 J", "−1.23 mJ", "12.3 kJ", "200 mJ", "–"]);
  assert.equal(quantity(0.2, "m", 1), "200 mm");
});

test("a replay of nothing but a plane can be read", () => {
  const replay = read(JSON.stringify({ title: "t", law: "rough", duration: 1, gravity: [0, 0, -1], bodies: [],
    planes: [{ name: "floor", normal: up, point: [0, 0, 0] }], room: null, arcs: [], impacts: [], series: {} }));
  assert.deepEqual([replay.motions, replay.series.t, replay.room], [[], [], null]);
});

test("impacts are put in the order of time, a polyhedron has the radius of its farthest corner", () => {
  const replay = read(JSON.stringify({ duration: 1, impacts: [[0.5, 0, -1, 1, 2, 3, 4, 5, 6], [0.2, 0, -2, 0, 0, 0, 0, 0, 1]] }));
  assert.deepEqual(replay.impacts.map(({ time }) => time), [0.2, 0.5]);
  assert.deepEqual(replay.impacts[1], { time: 0.5, a: 0, b: -1, point: [1, 2, 3], impulse: [4, 5, 6] });
  assert.equal(radius_of({ kind: "polyhedron", vertices: [[1, 0, 0], [0, 3, 4]] }), 5);
});
