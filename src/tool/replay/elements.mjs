// SPDX-License-Identifier: BSL-1.0

export function by_id(id) {
  return document.getElementById(id);
}

export function svg(name, attributes) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) {
    element.setAttribute(key, value);
  }
  return element;
}

/** Adds a row of a heading and a value, and returns the value's cell. */
export function add_row(table, heading, value = "") {
  const row = table.tBodies[0].insertRow();
  const cell = document.createElement("th");
  cell.scope = "row";
  cell.textContent = heading;
  row.append(cell);
  const content = row.insertCell();
  content.textContent = value;
  return content;
}
