// SPDX-License-Identifier: BSL-1.0
import { path_of, spread, ticks, value_at } from "./chart_parts.mjs";
import { svg } from "./elements.mjs";
import { prefix_of, quantity } from "./units.mjs";

const names = { kinetic: "kinetic", spin: "rotational part", potential: "potential", lost: "lost", total: "total" };
const margin = { left: 40, right: 78, top: 16, bottom: 20 };

/** Energy over time, with a cursor at the present time, and the values at that time. */
export class Chart {
  /** @param seek called with the time at the pointer */
  constructor(element, table, replay, seek) {
    this.element = element;
    this.duration = replay.duration;
    const { t, kinetic, potential, lost, spin } = replay.series;
    this.t = t;
    this.series = { total: t.map((_, i) => kinetic[i] + potential[i] + lost[i]), spin, potential, lost, kinetic };
    // The stored values have a rounding error of about 10⁻¹⁵ of the energy. A value below 10⁻¹² of the greatest is
    // shown as 0.
    this.rounding = 1e-12 * Object.values(this.series).flat().reduce((most, y) => Math.max(most, Math.abs(y)), 0);
    this.rows = Object.keys(names).map((name) => {
      const row = table.tBodies[0].insertRow();
      row.className = name;
      const heading = document.createElement("th");
      heading.scope = "row";
      heading.append(names[name]);
      row.append(heading);
      return { name, cell: row.insertCell() };
    });
    const point = (event) => {
      const box = element.getBoundingClientRect();
      const share = (event.clientX - box.left - margin.left) / (box.width - margin.left - margin.right);
      seek(Math.min(Math.max(share, 0), 1) * this.duration);
    };
    element.addEventListener("pointerdown", (event) => {
      element.setPointerCapture(event.pointerId);
      point(event);
    });
    element.addEventListener("pointermove", (event) => {
      if (event.buttons & 1) {
        point(event);
      }
    });
  }

  resize() {
    const { width, height } = this.element.getBoundingClientRect();
    if (this.t.length === 0 || width === 0) {
      return;
    }
    const all = Object.values(this.series).flatMap((y) => [y.reduce((a, b) => Math.min(a, b), 0), y.reduce((a, b) => Math.max(a, b), 0)]);
    const least = Math.min(...all);
    const greatest = Math.max(...all) || 1;
    const room = (greatest - least) * 0.06;
    const low = least < 0 ? least - room : 0;
    this.x_of = (t) => margin.left + t / this.duration * (width - margin.left - margin.right);
    this.y_of = (y) => height - margin.bottom - (y - low) / (greatest + room - low) * (height - margin.top - margin.bottom);
    const [letter, factor] = prefix_of(Math.max(greatest, -least));
    this.element.setAttribute("viewBox", `0 0 ${width} ${height}`);
    this.element.replaceChildren();
    const text = (x, y, anchor, content, look = "") => {
      const node = svg("text", { x, y, "text-anchor": anchor, class: look });
      node.textContent = content;
      this.element.append(node);
    };
    for (const y of ticks(low, greatest + room, 5)) {
      this.element.append(svg("line", { class: "rule", x1: margin.left, x2: width - margin.right, y1: this.y_of(y), y2: this.y_of(y) }));
      text(margin.left - 6, this.y_of(y) + 4, "end", String(Number((y / factor).toPrecision(6))).replace("-", "−"));
    }
    const times = ticks(0, this.duration, 5);
    for (const t of times) {
      text(this.x_of(t), height - 4, t === 0 ? "start" : t > this.duration * 0.97 ? "end" : "middle", `${Number(t.toPrecision(6))}${t === times.at(-1) ? " s" : ""}`);
    }
    text(margin.left - 6, 10, "end", `${letter}J`);
    for (const [name, y] of Object.entries(this.series)) {
      this.element.append(svg("path", { class: `${name} series`, d: path_of(this.t, y, this.x_of, this.y_of) }));
    }
    // At the end of each line is the first word of its name.
    const ends = Object.entries(this.series).map(([name, y]) => ({ name, y: this.y_of(y.at(-1)) }));
    const heights = spread(ends.map(({ y }) => y), 13, margin.top, height - margin.bottom);
    ends.forEach(({ name, y }, i) => {
      const [from, to] = [width - margin.right, width - margin.right + 8];
      this.element.append(svg("line", { class: `${name} leader`, x1: from, y1: y, x2: to, y2: heights[i] }));
      text(to + 2, heights[i] + 4, "start", names[name].split(" ")[0], name);
    });
    this.cursor = svg("line", { class: "cursor", y1: margin.top - 4, y2: height - margin.bottom });
    this.element.append(this.cursor);
    this.dots = Object.keys(this.series).map((name) => {
      const dot = svg("circle", { class: `${name} fill`, r: 3.6 });
      this.element.append(dot);
      return { name, dot };
    });
  }

  show(time) {
    if (this.t.length === 0) {
      return;
    }
    for (const { name, cell } of this.rows) {
      const value = value_at(this.t, this.series[name], time);
      cell.textContent = quantity(Math.abs(value) < this.rounding ? 0 : value, "J");
    }
    if (this.cursor) {
      const x = this.x_of(time);
      this.cursor.setAttribute("x1", x);
      this.cursor.setAttribute("x2", x);
      for (const { name, dot } of this.dots) {
        dot.setAttribute("cx", x);
        dot.setAttribute("cy", this.y_of(value_at(this.t, this.series[name], time)));
      }
    }
  }
}
