// SPDX-License-Identifier: MIT
// A collection as one page: small pictures, a search, and the way to a figure and back. As page_test.mjs.
import assert from "node:assert/strict";
import { readFileSync, statSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { corners, current, escape, keep, obstacles, page, paper, press, rested, shown, smallTargets, source, tab } from "./pages.mjs";

const gallery = page(paper, "--all", "--caption", "Figures of a paper");
const solids = page(join(source, "ifs_library/space_sponges.ifs"), "--all", "--lang", "de");
const names = (browser) => browser.value(`[...document.querySelectorAll("#tiles li:not([hidden]) span")].map((e) => e.textContent)`);
const view = (browser) => browser.value("document.body.dataset.view");
/** How many colours a small picture has. */
const colours = (i) => `(() => { const c = document.querySelectorAll("#tiles canvas")[${i}];
  const copy = new OffscreenCanvas(60, 45).getContext("2d", { willReadFrequently: true });
  copy.drawImage(c, 0, 0, 60, 45);
  const d = copy.getImageData(0, 0, 60, 45).data;
  return new Set(Array.from({ length: d.length / 4 }, (_, k) => d.slice(4 * k, 4 * k + 3).join())).size; })()`;
/** Clicks the tile of this name. */
async function choose(browser, name) {
  await browser.value(`void ([...document.querySelectorAll("#tiles span")].find((e) => e.textContent === "${name}")
    .closest("button").id = "chosen-${name}")`);
  await press(browser, `chosen-${name}`);
  await browser.until("document.body.dataset.view === 'figure'");
  await rested(browser);
}

test("a gallery shows all entries as pictures, one engine draws them", async () => {
  const browser = await shown(gallery);
  assert.equal(await browser.value("document.querySelector('#gallery h1').textContent"), "Paper");
  assert.equal(await browser.value("document.title"), "Paper");
  assert.equal(await browser.value("document.querySelector('#gallery .caption').textContent"), "Figures of a paper");
  const all = await names(browser);
  assert.deepEqual(all, ["maple", "flower"]);
  assert.equal(await browser.value("document.getElementById('found').textContent"), `${all.length} of ${all.length} fractals`);
  await browser.until(`${colours(0)} > 20 && ${colours(1)} > 20`);
  assert.equal(readFileSync(gallery, "utf8").split("id=\"engine\"").length, 2);
  assert.ok(statSync(gallery).size < 500_000 + 4000 * all.length);
  await keep(browser, "gallery");
  assert.deepEqual(await browser.complaints(), []);
});

test("pictures are drawn when they come into sight, and not before", async () => {
  const browser = await shown(page(join(source, "ifs_library/tiles.ifs"), "--all"), { width: 500, height: 700 });
  await browser.until(`${colours(0)} > 20 && barycage.drawing.waiting.length === 0`); // no picture is waited for
  const last = (await names(browser)).length - 1;
  assert.ok(last > 12);
  assert.equal(await browser.value(colours(last)), 1);
  await browser.value("document.querySelectorAll('#tiles li')[" + last + "].scrollIntoView()");
  await browser.until(`${colours(last)} > 20`);
  assert.deepEqual(await browser.complaints(), []);
});

test("the search finds names by their parts", async () => {
  const browser = await shown(gallery);
  const all = await names(browser);
  await press(browser, "find");
  await browser.keys("M", "A", "p");
  assert.deepEqual(await names(browser), all.filter((name) => name.toLowerCase().includes("map")));
  assert.match(await browser.value("document.getElementById('found').textContent"), new RegExp(`^[1-9] of ${all.length} fractals$`));
  await keep(browser, "gallery-search");
  await browser.keys("q", "q");
  assert.deepEqual(await names(browser), []);
  await browser.keys(escape); // empties the field
  assert.deepEqual(await names(browser), all);
});

test("a click leads to the figure, and Back to the gallery where it was", async () => {
  const browser = await shown(gallery);
  await choose(browser, "maple");
  assert.equal(await browser.value("document.getElementById('name').textContent"), "maple");
  assert.equal(await browser.value("document.title"), "maple");
  assert.equal(await browser.value("getComputedStyle(document.getElementById('gallery')).display"), "none");
  await keep(browser, "gallery-figure");
  const at = await corners(browser), start = await current(browser);
  await browser.drag([at[1], [at[1][0] + 30, at[1][1] + 20], [at[1][0] + 60, at[1][1] + 40]]);
  assert.notDeepEqual(await current(browser), start);
  await browser.send("POST", "/back", {});
  await browser.until("document.body.dataset.view === 'gallery'");
  assert.equal(await browser.value("document.activeElement.querySelector('span').textContent"), "maple");
  // Another one, by its own way back; nothing of the first is left in it.
  const other = (await names(browser)).find((name) => name !== "maple");
  await choose(browser, other);
  assert.equal(await browser.value("barycage.entry.name"), other);
  assert.equal(await browser.value("document.querySelectorAll('#maps .map').length"), await browser.value("barycage.entry.maps.length"));
  await press(browser, "back");
  await browser.until("document.body.dataset.view === 'gallery'");
  // The first one is as the collection has it.
  await choose(browser, "maple");
  assert.deepEqual(await current(browser), start);
  await browser.send("POST", "/refresh", {});
  await browser.until("window.barycage && barycage.drawing.drawn > 0");
  assert.equal(await view(browser), "figure");
  assert.deepEqual(await browser.complaints(), []);
});

test("a damaged link is named where it can be read", async () => {
  const browser = await shown(`file://${gallery}#!!!!`);
  assert.equal(await view(browser), "gallery");
  assert.match(await browser.value("document.querySelector('main').innerText"), /link is damaged/);
});

test("the keyboard alone finds, opens and returns", async () => {
  const browser = await shown(gallery);
  await browser.keys(tab, ..."maple", tab, "\uE007");
  await browser.until("document.body.dataset.view === 'figure'");
  assert.equal(await browser.value("barycage.entry.name"), "maple");
  await browser.value("document.getElementById('back').focus()");
  await browser.keys("\uE007");
  await browser.until("document.body.dataset.view === 'gallery'");
  assert.equal(await browser.value("document.getElementById('find').value"), "maple");
});

test("a gallery of solids, dark, on a telephone, in German", async () => {
  const browser = await shown(solids, { dark: true, width: 390, height: 844, ratio: 2, touch: true });
  await browser.until(`${colours(0)} > 20 && ${colours(1)} > 20 && ${colours(2)} > 20 && ${colours(3)} > 20`);
  await keep(browser, "gallery-phone-dark");
  assert.equal(await browser.value("document.getElementById('find').placeholder"), "Nach Namen suchen");
  assert.ok((await browser.value("document.documentElement.scrollWidth - innerWidth")) <= 0, "no sideways scrolling");
  await choose(browser, "menger");
  await keep(browser, "gallery-solid-phone");
  assert.deepEqual(await smallTargets(browser), [], "targets are large enough for fingers");
  assert.deepEqual(await browser.complaints(), []);
});

test("axe finds nothing that keeps anybody out of a gallery", async () => {
  for (const dark of [false, true]) {
    const browser = await shown(gallery, { dark });
    assert.deepEqual(await obstacles(browser), []);
  }
});
