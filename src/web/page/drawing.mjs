// SPDX-License-Identifier: BSL-1.0
import { trusted } from './trusted.mjs';

const tags = ['div', 'figure', 'figcaption', 'svg', 'g', 'title', 'desc', 'path', 'ellipse', 'circle', 'line', 'rect',
  'text'];
const attributes = ['class', 'd', 'x', 'y', 'x1', 'y1', 'x2', 'y2', 'cx', 'cy', 'r', 'rx', 'ry', 'width', 'height',
  'transform', 'viewBox', 'role', 'text-anchor'];

function copied(node) {
  if (node.nodeType === Node.TEXT_NODE) {
    return [document.createTextNode(node.data)];
  }
  if (node.nodeType !== Node.ELEMENT_NODE || !tags.includes(node.localName)) {
    return [];
  }
  const copy = document.createElementNS(node.namespaceURI, node.localName);
  for (const name of attributes) {
    if (node.hasAttribute(name)) {
      copy.setAttribute(name, node.getAttribute(name));
    }
  }
  copy.append(...[...node.childNodes].flatMap(copied));
  return [copy];
}

/** The elements of a drawing. Only shapes and texts are copied, since the solver shares a worker with the judge. */
export function drawn(html) {
  const { body } = new DOMParser().parseFromString(trusted.createHTML(html), 'text/html');
  return [...body.childNodes].flatMap(copied);
}
