// SPDX-License-Identifier: BSL-1.0
// node browser_test.mjs WRITE_REPLAY DIRECTORY: opens a replay in Chromium, checks it at several times, and operates
// it. The exit status is 77 if there is no Chromium or no replay. With KEEP=1 the test rewrites the reference pictures.
// Check them afterwards.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

import { Browser } from "./browser.mjs";
import { decode, encode, shrunk } from "./png.mjs";

const [write_replay, directory] = process.argv.slice(2);
const chromium = "/usr/bin/chromium";
const here = (name) => fileURLToPath(new URL(name, import.meta.url));
const skipped = 77;

/** The mean luminance of each square of 32 × 32 pixels of the screen within `view`, from 0 to 255. */
const [width, height, square, shrink] = [1280, 800, 32, 4];
function luminance({ width: columns, height: rows, pixels }, view) {
  const cell = square / shrink;
  const values = [];
  for (let y = Math.ceil(view.top / square); (y + 1) * square <= view.bottom && (y + 1) * cell <= rows; ++y) {
    for (let x = Math.ceil(view.left / square); (x + 1) * square <= view.right && (x + 1) * cell <= columns; ++x) {
      let sum = 0;
      for (let n = 0; n < cell * cell; ++n) {
        const at = ((y * cell + Math.floor(n / cell)) * columns + x * cell + n % cell) * 3;
        sum += 0.2126 * pixels[at] + 0.7152 * pixels[at + 1] + 0.0722 * pixels[at + 2];
      }
      values.push(sum / cell ** 2);
    }
  }
  return values;
}
const difference = (one, two) => Math.max(...one.map((x, i) => Math.abs(x - two[i])));

// The permitted difference of luminance. Browsers smooth edges differently, so an edge may move by a pixel. At most
// three edges (outline, ring, shadow), with a contrast of up to 150, cross a square. If they move by one pixel, the
// mean of the square changes by 3 · 32 / 1024 · 150 = 14. A ball that is off by a third of its radius, 12 pixels,
// changes a square by 12 · 32 / 1024 · 150 = 56.
const tolerance = 14;

async function look(browser, page) {
  await browser.open(page);
  const view = await browser.value('(({ left, top, right, bottom }) => ({ left, top, right, bottom }))(document.getElementById("stage").getBoundingClientRect())');
  const seen = {};
  for (const [name, time] of [["start", 0], ["end", 6], ["middle", 2.5], ["again", 2.5]]) {
    // "middle" moves the open page to the time 2.5; "again" opens the page at this time.
    if (name === "again") {
      await browser.open(`${page}#t=${time}`);
    } else {
      await browser.go(`#t=${time}`);
    }
    const picture = shrunk(decode(await browser.picture()), shrink);
    writeFileSync(join(directory, `${name}.png`), encode(picture));
    seen[name] = luminance(picture, view);
  }
  assert.ok(difference(seen.middle, seen.again) <= 1, "the same time looks the same");
  for (const [one, two] of [["start", "middle"], ["middle", "end"], ["start", "end"]]) {
    assert.ok(difference(seen[one], seen[two]) > 2 * tolerance, `${one} and ${two} do not look the same`);
  }
  for (const name of ["start", "middle", "end"]) {
    const stored = here(`pictures/${name}.png`);
    if (process.env.KEEP) {
      writeFileSync(stored, readFileSync(join(directory, `${name}.png`)));
    }
    const off = difference(seen[name], luminance(decode(readFileSync(stored)), view));
    console.log(`${name}: ${off.toFixed(1)} of 255 from the stored picture, allowed ${tolerance}`);
    assert.ok(off <= tolerance, `${name}: ${directory}/${name}.png against ${stored}`);
  }
  await browser.colour_scheme("dark");
  await browser.frame();
  const dark = luminance(shrunk(decode(await browser.picture()), shrink), view);
  assert.ok(dark.filter((x, i) => x < seen.middle[i] - 60).length > dark.length / 2, "dark is dark");
}

async function play(browser, page) {
  const clock = () => browser.value('Number(document.querySelector("#clock b").textContent)');
  await browser.open(`${page}#t=2.5`);
  assert.equal(await clock(), 2.5);
  const replay = JSON.parse(readFileSync(join(directory, "fixture.json"), "utf8"));
  const times = replay.impacts.map(([time]) => time);
  const right = [Math.max(...times.filter((t) => t < 2.5)), Math.min(...times.filter((t) => t > 2.5))];
  const shift = 8;
  await browser.key("ArrowRight", shift);
  assert.ok(Math.abs(await clock() - right[1]) <= 0.0005, "to the next impact");
  await browser.key("ArrowLeft", shift);
  assert.ok(Math.abs(await clock() - right[0]) <= 0.0005, "to the previous impact");
  await browser.key("End");
  assert.equal(await clock(), 6);
  await browser.key("ArrowLeft");
  assert.equal(await clock(), 5.94);
  await browser.key(" ");
  assert.equal(await browser.value('document.getElementById("play").getAttribute("aria-pressed")'), "true");
  await browser.until('document.getElementById("play").getAttribute("aria-pressed") === "false"');
  assert.equal(await clock(), 6, "it plays to its end and stops there");
  const shown = await browser.value('document.querySelector("#energies .total td").textContent');
  const { kinetic, potential, lost } = replay.series;
  assert.equal(shown, `${(kinetic.at(-1) + potential.at(-1) + lost.at(-1)).toPrecision(4)} J`);
}

/** Checks that nothing is wider than the page, and that no parts overlap. */
async function measure(browser, page) {
  for (const [wide, high] of [[1280, 800], [1920, 1080], [1024, 700], [360, 740]]) {
    await browser.resize(wide, high);
    await browser.open(page);
    assert.equal(await browser.value("document.documentElement.scrollWidth <= innerWidth"), true, `at ${wide} × ${high}`);
    // On a narrow screen the transport sticks to the bottom, over the content that scrolls beneath it.
    const overlaps = await browser.value(`[["header, #stage, aside", "#transport"], ["#transport > *"], ["aside > section"]]
      .flatMap(([siblings, other]) => {
        const all = [...document.querySelectorAll(siblings)];
        const more = other ? [...document.querySelectorAll(other)].filter((e) => getComputedStyle(e).position !== "sticky") : [];
        const boxes = [...all, ...more].map((e) => [e.id || e.className || e.tagName, e.getBoundingClientRect()]);
        return boxes.flatMap(([a, p], i) => boxes.slice(i + 1)
          .filter(([, q]) => Math.min(p.right, q.right) - Math.max(p.left, q.left) > 1
            && Math.min(p.bottom, q.bottom) - Math.max(p.top, q.top) > 1)
          .map(([b]) => a + " and " + b));
      })`);
    assert.deepEqual(overlaps, [], `at ${wide} × ${high}`);
  }
  await browser.resize(width, height);
}

/** Tests the controls without WebGL, which is faster. Everything except the picture works without WebGL. */
async function without_webgl(page) {
  const browser = new Browser(chromium, join(directory, "profile-without"), ["--disable-gpu", "--disable-3d-apis"]);
  try {
    await browser.start(width, height);
    await browser.open(`${page}#t=2.5`);
    assert.match(await browser.value('document.getElementById("message").textContent'), /no WebGL/);
    assert.equal(await browser.value('document.querySelectorAll("#chart path").length'), 5);
    await play(browser, page);
    await measure(browser, page);
  } finally {
    await browser.stop();
  }
}

if (!existsSync(chromium)) {
  console.log("skipped: no chromium");
  process.exit(skipped);
}
rmSync(directory, { recursive: true, force: true });
mkdirSync(directory, { recursive: true });
const files = ["fixture.json", "fixture.html"].map((name) => join(directory, name));
assert.equal(spawnSync(process.execPath, [here("fixture.mjs"), files[0]], { stdio: "inherit" }).status, 0);
const { status } = spawnSync(write_replay, files, { stdio: "inherit" });
if (status === skipped) {
  console.log("skipped: the program was built without replays");
  process.exit(skipped);
}
assert.equal(status, 0);
const page = pathToFileURL(files[1]).href;
const browser = new Browser(chromium, join(directory, "profile"), ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"]);
try {
  await browser.start(width, height);
  await look(browser, page);
  assert.deepEqual(browser.errors, []);
  assert.deepEqual(browser.requests, []);
} finally {
  await browser.stop();
}
await without_webgl(page);
