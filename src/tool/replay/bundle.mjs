// SPDX-License-Identifier: BSL-1.0
// node bundle.mjs FILE: writes the page, with marks for its title and its replay, as one text, or as C++ if FILE ends
// in .cpp.
import { createHash } from "node:crypto";
import { readFile, writeFile } from "node:fs/promises";

import { build } from "esbuild";

async function built(entry) {
  const result = await build({
    absWorkingDir: import.meta.dirname ?? new URL(".", import.meta.url).pathname,
    entryPoints: [entry],
    bundle: true,
    minify: true,
    charset: "utf8",
    target: ["es2021"],
    format: entry.endsWith(".css") ? undefined : "iife",
    // The licence of three.js requires its notice.
    legalComments: "inline",
    write: false,
  });
  return result.outputFiles[0].text.trim();
}

function digest(text) {
  return `'sha256-${createHash("sha256").update(text).digest("base64")}'`;
}

/** Replaces a mark by a text. Throws if the mark does not occur exactly once. */
function filled(page, mark, text) {
  const parts = page.split(mark);
  if (parts.length !== 2) {
    throw new Error(`${mark} occurs ${parts.length - 1} times in the page, expected once`);
  }
  return parts.join(text);
}

function as_cpp(page) {
  const lines = [];
  const bytes = Buffer.from(page);
  for (let at = 0; at < bytes.length; at += 64) {
    lines.push([...bytes.subarray(at, at + 64)].join(","));
  }
  return `// Made by bundle.mjs.
#include "scene/replay_html.hpp"

namespace carom::tool {
namespace {

constexpr unsigned char bytes[] = {
${lines.join(",\n")}};

}  // namespace

std::string_view replay_page() { return {reinterpret_cast<const char*>(bytes), sizeof bytes}; }

}  // namespace carom::tool
`;
}

// Neither the script nor the style may end its element. esbuild writes "<\\/script" in strings, and the check confirms
// this.
const script = await built("replay.mjs");
const style = await built("replay.css");
if (/<\/script|<!--/i.test(script) || /<\/style/i.test(style)) {
  throw new Error("the bundled code contains the end tag of its element");
}
let page = await readFile(new URL("page.html", import.meta.url), "utf8");
// Only the bundled script runs, and nothing is loaded.
page = filled(page, "{{policy}}",
  `default-src 'none'; script-src ${digest(script)}; style-src ${digest(style)}; base-uri 'none'; form-action 'none'`);
page = filled(page, "{{style}}", style);
page = filled(page, "{{script}}", script);
const file = process.argv[2] ?? "replay_page.html";
await writeFile(file, file.endsWith(".cpp") ? as_cpp(page) : page);
