// SPDX-License-Identifier: BSL-1.0
import { by_id, svg } from "./elements.mjs";
import { count_up_to } from "./replay_data.mjs";

const speeds = [0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10];

/** The time, and its controls: the slider, the buttons, the keys and the clock. */
export class Player {
  /** @param changed called when the time, the speed or the playback changes */
  constructor(replay, changed) {
    this.replay = replay;
    this.changed = changed;
    this.time = 0;
    this.is_playing = false;
    // A short scene is shown in slow motion.
    this.speed = speeds.find((speed) => replay.duration / speed <= 5) ?? 1;
    this.speed = Math.min(this.speed, 1);
    const speed = by_id("speed");
    speeds.forEach((x) => speed.append(new Option(`×${x}`, x, false, x === this.speed)));
    speed.addEventListener("change", () => {
      this.speed = Number(speed.value);
      changed();
    });
    this.slider = by_id("time");
    this.slider.max = replay.duration;
    this.slider.addEventListener("input", () => this.seek(Number(this.slider.value)));
    by_id("play").addEventListener("click", () => this.toggle());
    by_id("previous").addEventListener("click", () => this.step(-1));
    by_id("next").addEventListener("click", () => this.step(1));
    document.addEventListener("keydown", (event) => this.key(event));
    this.digits = Math.max(0, 3 - Math.floor(Math.log10(replay.duration)));
    this.add_ticks();
    this.show();
  }

  add_ticks() {
    const shares = new Set(this.replay.impacts.map(({ time }) => Math.round(time / this.replay.duration * 1000)));
    const ticks = by_id("ticks");
    ticks.setAttribute("viewBox", "0 0 1000 1");
    ticks.firstElementChild.setAttribute("d", [...shares].map((x) => `M${x} 0V1`).join(""));
  }

  seek(time) {
    this.time = Math.min(Math.max(time, 0), this.replay.duration);
    this.show();
    this.changed();
  }

  /** Seeks the next impact (sign > 0) or the previous one. */
  step(sign) {
    this.pause();
    const { impacts } = this.replay;
    const time_of = (i) => impacts[i].time;
    // Impacts at the same time, or closer than `slack`, are one step.
    const slack = this.replay.duration * 1e-9;
    const index = sign > 0 ? count_up_to(impacts.length, time_of, this.time + slack)
      : count_up_to(impacts.length, time_of, this.time - slack) - 1;
    if (index >= 0 && index < impacts.length) {
      this.seek(time_of(index));
    } else {
      this.seek(sign > 0 ? this.replay.duration : 0);
    }
  }

  key(event) {
    const { target, key } = event;
    const acts_by_itself = target.matches("button, select, input[type=checkbox], a, summary");
    if (event.ctrlKey || event.altKey || event.metaKey || (acts_by_itself && (key === " " || target.matches("select")))) {
      return;
    }
    const actions = {
      " ": () => this.toggle(),
      ArrowLeft: () => (event.shiftKey ? this.step(-1) : this.seek(this.time - this.replay.duration / 100)),
      ArrowRight: () => (event.shiftKey ? this.step(1) : this.seek(this.time + this.replay.duration / 100)),
      Home: () => this.seek(0),
      End: () => this.seek(this.replay.duration),
    };
    if (actions[key]) {
      event.preventDefault();
      actions[key]();
    }
  }

  toggle() {
    if (this.is_playing) {
      this.pause();
    } else {
      this.is_playing = true;
      this.latest = undefined;
      if (this.time >= this.replay.duration) {
        this.time = 0;
      }
      this.show();
      this.changed();
    }
  }

  pause() {
    this.is_playing = false;
    this.show();
  }

  /** One frame of the browser's clock, in milliseconds. */
  advance(now) {
    if (this.is_playing) {
      // After the page was hidden, the replay continues where it was: a frame advances it by at most 100 ms.
      const since = this.latest === undefined ? 0 : Math.min(now - this.latest, 100);
      this.latest = now;
      this.time += since / 1000 * this.speed;
      if (this.time >= this.replay.duration) {
        this.time = this.replay.duration;
        this.is_playing = false;
      }
      this.show();
    }
  }

  show() {
    const time = this.time.toFixed(this.digits);
    this.slider.value = this.time;
    this.slider.setAttribute("aria-valuetext", `${time} s`);
    const [now, of] = [document.createElement("b"), document.createElement("span")];
    now.textContent = time;
    of.textContent = ` / ${this.replay.duration.toFixed(Math.min(this.digits, 2))} s`;
    by_id("clock").replaceChildren(now, of);
    const play = by_id("play");
    play.setAttribute("aria-pressed", String(this.is_playing));
    play.setAttribute("aria-label", this.is_playing ? "Pause" : "Play");
  }
}
