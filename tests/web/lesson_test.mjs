// SPDX-License-Identifier: MIT
// A lesson as a page. As page_test.mjs.
import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { corners, current, folder, keep, obstacles, page, paper, press, rested, shown, smallTargets, source, tab } from "./pages.mjs";

const lesson = join(folder, "trees.lesson");
writeFileSync(lesson, `lesson: Trees
file: paper.ifs

## A maple
entry: maple

Drag the crown.

Then go on.

## A maple that leans
entry: maple
cage: -6 5, 3 5, 4 -3
tool: maps

The wind has come.

## A flower <b>
entry: flower
view: area 0 0 2 1
colour: address

Look closely.
`);
const path = page(paper, "--lesson", lesson);
const text = (browser, selector) => browser.value(`document.querySelector("${selector}").textContent`);
const pageDown = "\uE00F", pageUp = "\uE00E";

test("a lesson is read step by step, and each begins as it is written", async () => {
  const browser = await shown(path);
  await browser.until("barycage.drawing.drawn > 0");
  await rested(browser);
  assert.equal(await text(browser, "#lesson h2"), "A maple");
  assert.equal(await text(browser, "#lesson .caption"), "Drag the crown.\n\nThen go on.");
  assert.equal(await text(browser, "#lesson .place"), "1 / 3");
  assert.equal(await browser.value("document.title"), "A maple – Trees");
  await keep(browser, "lesson-light");
  const start = await current(browser), at = await corners(browser);
  await browser.drag([at[1], [at[1][0] + 20, at[1][1] + 10], [at[1][0] + 40, at[1][1] + 20]]);
  assert.notDeepEqual(await current(browser), start);
  await press(browser, "previous"); // there is none
  assert.equal(await text(browser, "#lesson .place"), "1 / 3");
  await press(browser, "next");
  await browser.until("barycage.figure.holdsMaps");
  assert.equal(await text(browser, "#lesson h2"), "A maple that leans");
  assert.deepEqual(await current(browser), [[-6, 5], [3, 5], [4, -3]]);
  await press(browser, "next");
  await browser.until("barycage.entry.name === 'flower' && barycage.figure.isKnown");
  assert.equal(await text(browser, "#lesson h2"), "A flower <b>");
  assert.equal(await browser.value("barycage.figure.holdsMaps"), false);
  assert.equal(await browser.value("barycage.entry.appearance.colourBy"), 2);
  await browser.until("barycage.figure.camera.target.every((x) => x === 0)");
  const { width, height } = await browser.value("barycage.figure.size");
  const scale = await browser.value("barycage.figure.camera.scale(barycage.figure.size)");
  assert.ok(Math.abs(scale / Math.min(width / 2, height) - 1) < 1e-12, "the area fills the picture");
  await rested(browser);
  await keep(browser, "lesson-last");
  await press(browser, "next"); // there is none
  assert.equal(await text(browser, "#lesson .place"), "3 / 3");
  // Back, the first step is as it was written, not as it was dragged.
  await press(browser, "previous");
  await press(browser, "previous");
  await browser.until("barycage.entry.name === 'maple' && barycage.figure.isKnown && !barycage.figure.holdsMaps");
  assert.deepEqual(await current(browser), start);
  assert.deepEqual(await browser.complaints(), []);
});

test("the keys of presenters, and the keyboard alone", async () => {
  const browser = await shown(path);
  await browser.keys(pageDown);
  await browser.until("document.querySelector('#lesson .place').textContent === '2 / 3'");
  await browser.keys(pageUp);
  await browser.until("document.querySelector('#lesson .place').textContent === '1 / 3'");
  await browser.keys(tab, tab, "\uE007", "\uE007");
  await browser.until("document.querySelector('#lesson .place').textContent === '3 / 3'");
  assert.equal(await browser.value("document.activeElement.id"), "next"); // at the end, too
});

test("a lesson in German, dark, on a telephone, and for everybody", async () => {
  const german = page(join(source, "resources/lessons/maple_triangle.ifs"), "-q", "--lesson",
    join(source, "resources/lessons/maple_triangle.de.lesson"), "--lang", "de");
  const browser = await shown(german, { dark: true, width: 390, height: 844, ratio: 2, touch: true });
  await browser.until("barycage.drawing.drawn > 0");
  await rested(browser);
  assert.equal(await text(browser, "#next"), "Weiter");
  await keep(browser, "lesson-phone-dark");
  assert.ok((await browser.value("document.documentElement.scrollWidth - innerWidth")) <= 0, "no sideways scrolling");
  assert.deepEqual(await smallTargets(browser), []);
  assert.deepEqual(await obstacles(browser), []);
  assert.deepEqual(await obstacles(await shown(path)), []);
  assert.deepEqual(await browser.complaints(), []);
});
