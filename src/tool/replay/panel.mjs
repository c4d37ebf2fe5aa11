// SPDX-License-Identifier: BSL-1.0
import { add_row, by_id } from "./elements.mjs";
import { phases } from "./motion.mjs";
import { count_up_to } from "./replay_data.mjs";
import { quantity } from "./units.mjs";

function counted(count, one, many) {
  return `${count} ${count === 1 ? one : many}`;
}

/** The contents of the scene, the number of bodies in each phase, and the motion of one body. */
export class Panel {
  /** @param changed called when another body is chosen */
  constructor(replay, changed) {
    this.replay = replay;
    const table = by_id("counts");
    const spheres = replay.bodies.filter(({ kind }) => kind === "sphere").length;
    const kinds = [[spheres, "sphere", "spheres"], [replay.bodies.length - spheres, "polyhedron", "polyhedra"]]
      .filter(([count]) => count > 0).map((kind) => counted(...kind));
    add_row(table, "Law", replay.law);
    add_row(table, "Bodies", kinds.join(", ") || "none");
    add_row(table, "Planes", String(replay.planes.length));
    this.impacts = add_row(table, "Impacts");
    add_row(table, "Duration", quantity(replay.of_duration, "s"));
    if (replay.of_duration > replay.duration) {
      add_row(table, "Shown", `the first ${quantity(replay.duration, "s")}`);
    }
    add_row(table, "Gravity", quantity(Math.hypot(...replay.gravity), "m/s²", 3));

    this.counts = phases.map((phase) => {
      const item = document.createElement("li");
      const sign = document.createElement("i");
      sign.style.setProperty("--phase", `var(--${phase})`);
      const count = document.createElement("b");
      item.append(sign, phase, count);
      by_id("phases").append(item);
      return { item, count };
    });

    this.choice = by_id("body");
    replay.bodies.forEach(({ name }, index) => this.choice.append(new Option(name, index)));
    this.choice.addEventListener("change", changed);
    by_id("body-section").hidden = replay.bodies.length === 0;
    const state = by_id("body-state");
    this.body = { phase: add_row(state, "Phase"), speed: add_row(state, "Speed"), spin: add_row(state, "Angular speed"),
      position: add_row(state, "Position") };
  }

  show(time, states) {
    const { impacts } = this.replay;
    this.impacts.textContent = `${count_up_to(impacts.length, (i) => impacts[i].time, time)} of ${impacts.length}`;
    const counts = phases.map(() => 0);
    states.forEach(({ phase }) => { counts[phase] += 1; });
    this.counts.forEach(({ item, count }, index) => {
      count.textContent = String(counts[index]);
      item.classList.toggle("none", counts[index] === 0);
    });
    const state = states[Number(this.choice.value)];
    if (state) {
      this.body.phase.textContent = phases[state.phase];
      this.body.speed.textContent = quantity(Math.hypot(...state.velocity), "m/s");
      this.body.spin.textContent = quantity(Math.hypot(...state.angular_velocity), "rad/s");
      this.body.position.textContent = `(${state.position.map((x) => x.toFixed(3).replace("-", "−")).join(", ")}) m`;
    }
  }
}
