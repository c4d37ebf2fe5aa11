// SPDX-License-Identifier: BSL-1.0
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { PageInBrowser, page } from './page_in_browser.mjs';

let browser;
before(async () => { browser = await PageInBrowser.make(); });
after(() => browser.stop());

test('the page works by keyboard', async () => {
  await browser.open(page);
  const focused = () => browser.call(() => document.activeElement.id);
  await browser.call(() => document.getElementById('example').focus());
  for (const expected of ['judge', 'copy', 'text']) {
    await browser.press('Tab', 9);
    assert.equal(await focused(), expected);
  }
  await browser.press('Tab', 9);
  assert.equal(await focused(), 'text', 'Tab indents in the editor');
  assert.match(await browser.field('text'), /^ {2}|\n {2}$/);
  await browser.press('Escape', 27);
  for (const expected of ['law', 'precision', 'domain', 'cases', 'seed']) {
    await browser.press('Tab', 9);
    assert.equal(await focused(), expected, 'Escape and Tab leave the editor');
  }
  assert.notEqual(await browser.call(() => getComputedStyle(document.activeElement).outlineStyle), 'none');
  await browser.key('Enter', 2);
  await browser.idle();
  assert.match(await browser.text('#verdict'), /^Sound\. /);
});

test('Tab indents lines, and Shift and Tab takes the indent away', async () => {
  await browser.open(page);
  await browser.set('text', 'one\ntwo\nthree');
  await browser.call(() => {
    const editor = document.getElementById('text');
    editor.focus();
    editor.setSelectionRange(1, 5);
  });
  await browser.press('Tab', 9);
  assert.equal(await browser.field('text'), '  one\n  two\nthree');
  await browser.press('Tab', 9, 8);
  assert.equal(await browser.field('text'), 'one\ntwo\nthree');
});

test('each control has a name, and the verdict is announced', async () => {
  await browser.open(page);
  await browser.choose('Inertia in world axes');
  await browser.judge();
  const { nodes } = await browser.ask('Accessibility.getFullAXTree');
  const roles = ['button', 'combobox', 'textbox', 'spinbutton', 'progressbar', 'region', 'image'];
  const nameless = nodes.filter(({ role, name, ignored }) => !ignored && roles.includes(role?.value) && !name?.value);
  assert.deepEqual(nameless.map(({ role }) => role.value), []);
  const announced = await browser.call(() => document.querySelector('[role=status] .result') !== null);
  assert.equal(announced, true);
});

/** The least contrast of a text to its background, and its place. */
function least_contrast() {
  const parsed = (colour) => colour.match(/[\d.]+/g).map(Number);
  const channel = (c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
  const luminance = ([r, g, b]) => 0.2126 * channel(r / 255) + 0.7152 * channel(g / 255) + 0.0722 * channel(b / 255);
  const background = (node) => {
    const colour = parsed(getComputedStyle(node).backgroundColor);
    return colour.length === 3 || colour[3] > 0 ? colour : background(node.parentElement);
  };
  const nodes = [...document.querySelectorAll('body *:not(option):not(script):not(noscript)')].filter((node) =>
    [...node.childNodes].some((child) => child.nodeType === Node.TEXT_NODE && child.data.trim())
    && node.checkVisibility() && !node.closest('svg') && !node.matches(':disabled, .skip'));
  const contrasts = nodes.map((node) => {
    const [dark, light] = [luminance(parsed(getComputedStyle(node).color)), luminance(background(node))].sort();
    return [(light + 0.05) / (dark + 0.05), `${node.localName}: ${node.textContent.slice(0, 40)}`];
  });
  return contrasts.reduce((least, one) => (one[0] < least[0] ? one : least));
}

for (const scheme of ['light', 'dark']) {
  test(`${scheme} mode has the contrast of WCAG AA`, async () => {
    await browser.colour_scheme(scheme);
    await browser.open(page);
    await browser.choose("The note's method");
    await browser.judge();
    const [contrast, where] = await browser.call(least_contrast);
    assert.ok(contrast >= 4.5, `${contrast} at ${where}`);
    const [red] = await browser.call(() => getComputedStyle(document.body).backgroundColor.match(/\d+/g).map(Number));
    assert.equal(red < 128, scheme === 'dark');
    await browser.colour_scheme('light');
  });
}

function too_wide() {
  const nodes = [...document.querySelectorAll('body *')].filter((node) => node.checkVisibility()
    && !node.closest('svg') && !node.matches('.skip, .spoken'));
  const wide = nodes.filter((node) => node.getBoundingClientRect().right > innerWidth + 1);
  return [...wide.map((node) => node.id || node.localName),
    ...(document.documentElement.scrollWidth > innerWidth ? ['the page'] : [])];
}

test('a verdict is marked as old after an edit', async () => {
  await browser.open(page);
  const is_old = () => browser.call(() => document.getElementById('results').classList.contains('old'));
  await browser.set('seed', '2');
  assert.equal(await is_old(), false, 'nothing is judged');
  await browser.call(() => document.getElementById('seed').focus());
  await browser.ask('Input.insertText', { text: '3' });
  await browser.judge();
  await browser.call(() => document.getElementById('seed').blur());
  assert.equal(await is_old(), false);
  for (const [field, value] of [['law', 'rough'], ['text', 'changed']]) {
    await browser.set(field, value);
    assert.equal(await is_old(), true, field);
    assert.match(await browser.text('#state'), /changed since this verdict/);
    await browser.judge();
    assert.equal(await is_old(), false);
  }
});

for (const [width, height] of [[360, 740], [820, 1000], [1280, 900], [1920, 1080]]) {
  test(`nothing is wider than the page at ${width} px`, async () => {
    await browser.resize(width, height);
    await browser.open(page);
    assert.deepEqual(await browser.call(too_wide), []);
    await browser.choose("The note's method");
    await browser.judge();
    assert.deepEqual(await browser.call(too_wide), []);
    await browser.resize(1280, 900);
  });
}
