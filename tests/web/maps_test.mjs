// SPDX-License-Identifier: MIT
// Maps that are dragged by their images of the cage. As page_test.mjs.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { join } from "node:path";
import { test } from "node:test";
import { alt, cli, collection, control, current, escape, keep, obstacles, page, paper, pixels, press, rested, right, shift, shown,
  smallTargets, source, tab } from "./pages.mjs";

const maple = page(paper, "--entry", "maple");
const rows = (browser) => browser.value("barycage.entry.maps");
const label = (browser) => browser.value("document.activeElement.getAttribute('aria-label')");
const said = (browser, id) => browser.value(`document.getElementById("${id}").textContent`);
/** The images of the corners in the window, the middle behind them: of each map. */
const images = (browser) => browser.value(`(() => { const r = document.getElementById("stage").getBoundingClientRect();
  return barycage.figure.held().map(({ points }) => [...points, points.reduce((a, p) => a.map((x, i) => x + p[i] / points.length),
    points[0].map(() => 0))].map((p) => barycage.figure.pixel(p)).map(([x, y]) => [x + r.left, y + r.top])); })()`);
const way = ([x, y], dx, dy) => [[x, y], [x + dx / 2, y + dy / 2], [x + dx, y + dy]];
/** A drag, and what it has done to the picture. */
async function drag(browser, points, options) {
  await browser.drag(points, options);
  await settled(browser);
}
/** Nothing is worked out any more, and what was drawn last is as it is to be. */
async function settled(browser) {
  await browser.until("barycage.drawing.waiting.length === 0 && !barycage.drawing.isStale");
  await rested(browser);
}
async function withMaps(path, options) {
  const browser = await shown(path, options);
  await rested(browser);
  await press(browser, "hold-maps");
  assert.equal(await browser.value("document.getElementById('hold-maps').getAttribute('aria-pressed')"), "true");
  return browser;
}
const isNear = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]) < 2;

test("a corner of a map is dragged: this map alone changes, the picture and the table follow, Reset returns all", async () => {
  const browser = await withMaps(maple);
  const before = await images(browser), maps = await rows(browser), picture = await pixels(browser);
  const view = await browser.value("barycage.figure.camera");
  await keep(browser, "maps-light");
  await drag(browser, way(before[0][1], 30, -20));
  const after = await images(browser), changed = await rows(browser);
  assert.ok(isNear(after[0][1], [before[0][1][0] + 30, before[0][1][1] - 20]), "the corner is under the pointer");
  for (const corner of [0, 2]) assert.ok(isNear(after[0][corner], before[0][corner]), "the others stay");
  assert.notDeepEqual(changed[0], maps[0]);
  assert.deepEqual(changed.slice(1), maps.slice(1));
  assert.notEqual(await pixels(browser), picture);
  assert.match(await said(browser, "said"), /^Corner 2 of map 1, at \(/);
  assert.equal(await browser.value("Number(document.querySelectorAll('#maps input')[1].value)"), Number(changed[0][0].toPrecision(5)));
  await keep(browser, "maps-dragged");
  await press(browser, "reset");
  await browser.until("barycage.figure.isKnown");
  await settled(browser);
  assert.deepEqual(await rows(browser), maps);
  assert.deepEqual(await current(browser), await browser.value("barycage.figure.rest"));
  assert.deepEqual(await browser.value("barycage.figure.camera"), view); // the page itself may have scrolled to the button
  assert.equal(await browser.value("document.querySelectorAll('#maps input')[1].value"), String(maps[0][0]));
  assert.deepEqual(await browser.complaints(), []);
});

test("the number of a map moves it, with Ctrl its edges rotate, with Alt they scale, with Shift along one axis", async () => {
  const browser = await withMaps(maple);
  const maps = await rows(browser), size = (row) => row[0] * row[3] - row[1] * row[2];
  const middle = (await images(browser))[1][3];
  await drag(browser, way(middle, 25, 4), { key: shift });
  let row = (await rows(browser))[1];
  assert.deepEqual(row.slice(0, 4), maps[1].slice(0, 4), "the matrix stays, exactly");
  assert.equal(row[5], maps[1][5], "along one axis");
  assert.ok(row[4] > maps[1][4]);
  const side = async () => { // a point between two corners of the second map, which is chosen now
    const [a, b] = (await images(browser))[1];
    return [0.3 * a[0] + 0.7 * b[0], 0.3 * a[1] + 0.7 * b[1]];
  };
  await drag(browser, way(await side(), 3, 30), { key: control });
  const turned = (await rows(browser))[1];
  assert.ok(Math.abs(size(turned) - size(row)) < 1e-12 && Math.abs(turned[0] - row[0]) > 1e-3, "turned, of the same size");
  row = turned;
  await drag(browser, way(await side(), 20, 10), { key: alt });
  const scaled = (await rows(browser))[1], factor = scaled[0] / row[0];
  assert.ok(Math.abs(factor - 1) > 1e-3);
  for (let i = 0; i < 4; ++i) assert.ok(Math.abs(scaled[i] - factor * row[i]) < 1e-12, "all by the same factor");
  assert.deepEqual((await rows(browser)).toSpliced(1, 1), maps.toSpliced(1, 1));
  assert.deepEqual(await browser.complaints(), []);
});

test("a dragged cage carries the handles, and stays where it is while a map is dragged", async () => {
  const browser = await shown(maple);
  await browser.value("void (barycage.figure.current = barycage.figure.rest.map(([x, y]) => [x + y / 3, y / 2]), barycage.figure.change())");
  await press(browser, "hold-maps");
  const cage = await current(browser), rest = await browser.value("barycage.figure.rest"), before = await images(browser);
  await browser.value("barycage.figure.choose(2)");
  await drag(browser, way(before[2][0], -20, 15));
  const after = await images(browser);
  assert.ok(isNear(after[2][0], [before[2][0][0] - 20, before[2][0][1] + 15]));
  for (const corner of [1, 2]) assert.ok(isNear(after[2][corner], before[2][corner]));
  assert.deepEqual(await current(browser), cage);
  assert.deepEqual(await browser.value("barycage.figure.rest"), rest);
  // What is saved has both.
  await browser.value(`(() => { window.saved = []; URL.createObjectURL = (blob) => { blob.text().then((t) => saved.push(t));
    return "data:,"; }; HTMLAnchorElement.prototype.click = () => {}; })()`);
  await browser.value("document.getElementById('ifs').click()");
  await browser.until("saved.length === 1");
  const info = execFileSync(cli, ["info", "--json", collection(await browser.value("saved[0]"))], { encoding: "utf8" });
  for (const number of [...cage.flat(), ...(await rows(browser))[2].slice(0, 6)]) assert.ok(info.includes(String(number)), `${number} is kept`);
  assert.deepEqual(await browser.complaints(), []);
});

test("a drag stops where the attractor would be lost, and says so", async () => {
  const browser = await withMaps(maple);
  const maps = await rows(browser), size = (row) => Math.sqrt(Math.abs(row[0] * row[3] - row[1] * row[2]));
  const middle = (await images(browser))[2][3];
  await drag(browser, [middle]); // a click chooses the map
  const side = async () => {
    const [a, , b] = (await images(browser))[2];
    return [0.4 * a[0] + 0.6 * b[0], 0.4 * a[1] + 0.6 * b[1]];
  };
  const [x, y] = await side();
  await drag(browser, way([x, y], x - middle[0], y - middle[1]), { key: alt }); // to twice the size
  assert.match(await said(browser, "notice"), /^Stopped/);
  assert.notEqual(await browser.value("barycage.figure.extent"), null);
  const factor = size((await rows(browser))[2]) / size(maps[2]);
  assert.ok(factor > 1.02 && factor < 1.9, `it has gone part of the way: ${factor}`);
  await keep(browser, "maps-stopped");
  const [back, down] = await side();
  await drag(browser, way([back, down], (middle[0] - back) / 2, (middle[1] - down) / 2), { key: alt });
  assert.equal(await said(browser, "notice"), "");
  assert.ok(size((await rows(browser))[2]) < 0.9 * factor * size(maps[2]));
  assert.deepEqual((await rows(browser)).toSpliced(2, 1), maps.toSpliced(2, 1));
  assert.deepEqual(await browser.complaints(), []);
});

test("the keyboard alone: M, Tab to maps and their corners, arrows, Escape", async () => {
  const browser = await shown(maple);
  await rested(browser);
  const maps = await rows(browser), { holdsMaps } = await browser.value("({ holdsMaps: barycage.figure.holdsMaps })");
  assert.equal(holdsMaps, false);
  await browser.value("document.getElementById('stage').focus()");
  await browser.keys("m", tab);
  assert.match(await label(browser), /^Map 1, at \(/);
  await browser.keys(tab);
  assert.match(await label(browser), /^Corner 1 of map 1, at \(/);
  await browser.keys(tab, tab, tab);
  assert.match(await label(browser), /^Map 2, at \(/);
  await browser.keys(right, right);
  await browser.until("barycage.entry.maps[1][4] > " + maps[1][4]);
  await rested(browser);
  assert.deepEqual((await rows(browser))[1].slice(0, 4), maps[1].slice(0, 4));
  assert.match(await label(browser), /^Map 2, at \(/); // it keeps the focus
  assert.match(await said(browser, "said"), /^Map 2, at \(/);
  await browser.keys(tab);
  assert.match(await label(browser), /^Corner 1 of map 2, at \(/);
  await browser.keys("m");
  assert.equal(await browser.value("document.activeElement.id"), "stage");
  await browser.keys(tab);
  assert.match(await label(browser), /^Corner 1, at \(/);
  // Escape takes back what is being dragged.
  await browser.value("document.getElementById('stage').focus()");
  await browser.keys("m");
  const moved = await rows(browser), at = (await images(browser))[3][3];
  await browser.drag(way(at, 40, 40), { release: false });
  await browser.until("barycage.entry.maps[3][4] !== " + moved[3][4]);
  await browser.keys(escape);
  await browser.until("barycage.entry.maps[3][4] === " + moved[3][4]);
  assert.deepEqual(await rows(browser), moved);
  assert.deepEqual(await browser.complaints(), []);
});

test("maps are dragged where this is allowed", async () => {
  const browser = await shown(page(paper, "--entry", "maple", "--allow", "cage,code"));
  assert.ok(await browser.value("document.getElementById('hold-maps').hidden"));
  const only = await withMaps(page(paper, "--entry", "maple", "--allow", "maps", "--lang", "de"));
  assert.equal(await said(only, "hold-maps"), "Abbildungen");
  assert.match(await said(only, "hint"), /Nummer einer Abbildung/);
  const before = await rows(only), at = (await images(only))[2][3];
  await drag(only, way(at, 20, 10));
  assert.notDeepEqual((await rows(only))[2], before[2]);
  await press(only, "hold-maps");
  assert.equal(await only.value("document.querySelectorAll('.corner').length"), 0); // the cage is not to be dragged
});

test("in space: the corners of a tetrahedron, and its number", async () => {
  const browser = await withMaps(page(join(source, "ifs_library/space_sponges.ifs"), "--entry", "cross_space"), { dark: true });
  const before = await images(browser), maps = await rows(browser), picture = await pixels(browser);
  await keep(browser, "maps-solid-dark");
  await drag(browser, way(before[0][4], 12, -9));
  const row = (await rows(browser))[0];
  assert.deepEqual(row.slice(0, 9), maps[0].slice(0, 9), "it moves as a whole");
  assert.notDeepEqual(row.slice(9), maps[0].slice(9));
  assert.notEqual(await pixels(browser), picture);
  const moved = await images(browser);
  await drag(browser, way(moved[0][2], -15, 10));
  const after = await images(browser);
  assert.ok(isNear(after[0][2], [moved[0][2][0] - 15, moved[0][2][1] + 10]));
  for (const corner of [0, 1, 3]) assert.ok(isNear(after[0][corner], moved[0][corner]), "the others stay");
  assert.deepEqual((await rows(browser)).slice(1), maps.slice(1));
  assert.deepEqual(await browser.complaints(), []);
});

test("a telephone: a finger drags a map, and every target is large enough", async () => {
  const browser = await withMaps(maple, { width: 390, height: 844, ratio: 2, touch: true, dark: true });
  await keep(browser, "maps-phone-dark");
  assert.ok((await browser.value("document.documentElement.scrollWidth - innerWidth")) <= 0, "no sideways scrolling");
  assert.deepEqual(await smallTargets(browser), []);
  const maps = await rows(browser), at = (await images(browser))[2][3];
  await drag(browser, way([at[0] + 6, at[1] + 8], 15, -12), { pointer: "touch" });
  assert.notDeepEqual((await rows(browser))[2], maps[2]);
  assert.deepEqual(await browser.complaints(), []);
});

test("axe finds nothing that keeps anybody out", async () => {
  for (const dark of [false, true]) assert.deepEqual(await obstacles(await withMaps(maple, { dark })), []);
});
