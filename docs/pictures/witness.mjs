// SPDX-License-Identifier: BSL-1.0
// node witness.mjs REPORT REPLAY NAME: draws the picture of README.md with Chromium, NAME-light.png and NAME-dark.png.
// REPORT is the report.html of a gate in which a subject violates `restitution`, and REPLAY the replay.html of a scene:
//
//   carom gate bullet-double-as-shipped --families slow --cases 100 --out build/slow
//   carom scene docs/examples/scenes/tumbling_polyhedra.json --out build/tumbling
//   cd docs/pictures && node witness.mjs ../../build/slow/report.html ../../build/tumbling/replay.html witness-and-replay
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

import { Browser } from "../../tests/tool/scene/browser.mjs";

const [report, replay, name] = process.argv.slice(2);
const [width, height, scale] = [900, 466, 1.6]; // CSS pixels, and pixels of the PNG per CSS pixel
const time = 2.6; // s of the replay

const resize = (browser, wide, high) =>
  browser.ask("Emulation.setDeviceMetricsOverride", { width: wide, height: high, deviceScaleFactor: scale, mobile: false });

/** The picture of the bodies and the time line, as a base64 PNG. */
async function frame_of_replay(browser) {
  await resize(browser, 412, 540);
  await browser.open(`${pathToFileURL(replay).href}#t=${time}`);
  await browser.value('document.querySelector("#stage button").style.visibility = "hidden"; stage.style.background = "var(--sunk)"; 0');
  const clip = await browser.value(`(() => {
    const stage = document.getElementById("stage").getBoundingClientRect();
    const time_line = document.querySelector("#transport input[type=range]").getBoundingClientRect();
    return { x: 0, y: stage.top, width: innerWidth, height: time_line.bottom + 4 - stage.top, scale: 1 };
  })()`);
  return (await browser.ask("Page.captureScreenshot", { format: "png", clip })).data;
}

/** The report's drawing of the velocity at the contact point, in the report's style. */
const text = readFileSync(report, "utf8");
const style = text.match(/<style>[^]*?<\/style>/)[0];
const end = text.indexOf("</svg>", text.indexOf("violates restitution: the contact point"));
const drawing = text.slice(text.lastIndexOf("<svg", end), end).replace("<svg", '<svg class="drawing"') + "</svg>";

const page = (frame) => `<!DOCTYPE html><html><head><meta charset="utf-8"/>${style}<style>
  body { width: ${width}px; height: ${height}px; display: flex; font-size: 15px; line-height: 1.4; overflow: hidden; }
  section { flex: 0 0 50%; padding: 14px 18px; }
  section + section { border-left: 1px solid var(--rule); }
  h1 { font-size: 17px; margin: 0 0 10px; white-space: nowrap; }
  .drawing { width: 412px; height: 300px; background: var(--raised); border-radius: 6px; }
  p { margin: 10px 0 0; }
  img { display: block; width: 414px; /* 412 and its border */ border: 1px solid var(--rule); border-radius: 6px; }
</style></head><body data-ready="true">
<section><h1>A witness: Bullet 3.24, default settings</h1>
  ${drawing}
  <p>The arrows show the velocity of A at the contact point. B is immovable and the restitution is 1, so A must rebound at
  its speed of approach, 0.18 m/s. In Bullet it does not rebound.</p></section>
<section><h1>A frame of a scene’s replay</h1><img src="data:image/png;base64,${frame}"/>
  <p>Pink arrows are impulses. Carom judges each one.</p></section></body></html>`;

const folder = mkdtempSync(join(tmpdir(), "picture-"));
const browser = new Browser("/usr/bin/chromium", join(folder, "profile"), ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"]);
try {
  await browser.start(width, height);
  for (const scheme of ["light", "dark"]) {
    await browser.colour_scheme(scheme);
    const file = join(folder, "page.html");
    writeFileSync(file, page(await frame_of_replay(browser)));
    await resize(browser, width, height);
    await browser.open(pathToFileURL(file).href);
    writeFileSync(`${name}-${scheme}.png`, await browser.picture());
  }
} finally {
  await browser.stop();
  rmSync(folder, { recursive: true, force: true });
}
