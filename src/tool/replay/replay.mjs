// SPDX-License-Identifier: BSL-1.0
import { Chart } from "./chart.mjs";
import { by_id } from "./elements.mjs";
import { phases } from "./motion.mjs";
import { Panel } from "./panel.mjs";
import { Player } from "./player.mjs";
import { read } from "./replay_data.mjs";
import { quantity } from "./units.mjs";
import { View } from "./view.mjs";

function report(text) {
  by_id("message").textContent = text;
  by_id("message").hidden = false;
  by_id("picture").hidden = true;
}

/** The view, or null if there is no WebGL. Without WebGL, everything except the picture works. */
function view_of(replay, changed) {
  try {
    const view = new View(by_id("picture"), replay, changed);
    by_id("caption").textContent = view.surroundings.step > 0 ? `grid ${quantity(view.surroundings.step, "m", 1)}` : "";
    by_id("reset").hidden = false;
    by_id("reset").addEventListener("click", () => {
      view.look_from_the_start();
      changed();
    });
    return view;
  } catch (error) {
    console.warn(error);
    report("This browser has no WebGL, so the page cannot draw the bodies. The chart, the times and the tables work.");
    return null;
  }
}

/** The colours of the page's style, light or dark, for the WebGL picture. */
function colours() {
  const style = getComputedStyle(document.documentElement);
  const of = (name) => style.getPropertyValue(`--${name}`).trim();
  return { phases: phases.map(of), arrow: of("arrow"), line: of("line"),
    dark: matchMedia("(prefers-color-scheme: dark)").matches };
}

function start() {
  const replay = read(by_id("replay").textContent);
  by_id("title").textContent = replay.title || document.title;
  if (replay.law) {
    by_id("law").hidden = false;
    by_id("law").lastElementChild.textContent = replay.law;
  }

  // More rings would hide the bodies.
  by_id("rings").checked = replay.bodies.length <= 2000;
  let is_due = false;
  const draw = (now) => {
    is_due = false;
    player.advance(now);
    const states = replay.motions.map((motion) => motion.at(player.time));
    panel.show(player.time, states);
    chart.show(player.time);
    view?.draw(player.time, player.speed, states, { arrows: by_id("arrows").checked, rings: by_id("rings").checked });
    document.body.dataset.ready = "true";
    if (player.is_playing) {
      redraw();
    }
  };
  const redraw = () => {
    if (!is_due) {
      is_due = true;
      requestAnimationFrame(draw);
    }
  };
  const player = new Player(replay, redraw);
  const panel = new Panel(replay, redraw);
  const chart = new Chart(by_id("chart"), by_id("energies"), replay, (time) => player.seek(time));
  const view = view_of(replay, redraw);

  const to_fragment = () => {
    const found = /^#t=([0-9.eE+-]+)$/.exec(location.hash);
    if (found && Number.isFinite(Number(found[1]))) {
      player.pause();
      player.seek(Number(found[1]));
    }
  };
  const restyle = () => {
    view?.set_colours(colours());
    redraw();
  };
  let size = "";
  const resize = () => {
    const { clientWidth, clientHeight } = by_id("stage");
    // Setting the size of a canvas waits for all pending drawing, so it is only set if it changed.
    const now = [clientWidth, clientHeight, devicePixelRatio].join(" ");
    if (now === size) {
      return;
    }
    size = now;
    view?.resize(Math.max(clientWidth, 1), Math.max(clientHeight, 1), devicePixelRatio);
    chart.resize();
    // A resized canvas is empty, so it is drawn at once.
    draw(performance.now());
  };
  to_fragment();
  restyle();
  resize();
  new ResizeObserver(resize).observe(by_id("stage"));
  addEventListener("hashchange", to_fragment);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", restyle);
  for (const choice of ["arrows", "rings"]) {
    by_id(choice).addEventListener("change", redraw);
  }
}

try {
  start();
} catch (error) {
  console.error(error);
  report(`This replay cannot be shown: ${error.message}`);
}
