// SPDX-License-Identifier: MIT
// Pages of entries that move, in Chromium, with real events. As page_test.mjs.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { statSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { cli, collection, corners, current, keep, obstacles, page, pixels, press, rested, right, shown, smallTargets,
  source } from "./pages.mjs";

const library = join(source, "ifs_library/motion.ifs");
const maple = page(library, "--entry", "maple_wind"), fern = page(library, "--entry", "fern_unfolding");
const calm = ["--force-prefers-reduced-motion"];
const home = "\uE011", end = "\uE010";
const frame = (browser) => browser.value("barycage.player.frame");
const isPlaying = (browser) => browser.value("barycage.player.run > 0");
const name = (browser) => browser.value("document.getElementById('play').ariaLabel");
const wait = (milliseconds) => new Promise((on) => setTimeout(on, milliseconds));
/** Frames that are shown one after the other, as the page tells them. @param {number} milliseconds */
async function framesIn(browser, milliseconds) {
  await browser.value(`(() => { const player = barycage.player, show = player.show; window.seen = [];
    player.show = () => { seen.push(player.frame); show(); }; })()`);
  await wait(milliseconds);
  return browser.value("seen");
}
/** Sierpinski's triangle, two maps of which turn. @param {string} header of the animation */
const turning = (header) => collection(`wheel {\n  ; barycage: animation ${header}\n  ; barycage: motion turn\n  ; barycage: of 2 3\n`
  + "  ; barycage: count 1\n  ; barycage: pivot .5 .5\n  .5 0 0 .5 0 0\n  .5 0 0 .5 .5 0\n  .5 0 0 .5 0 .5\n}\n");

test("a page of an entry that moves plays it, and the button, Space and the slider stop it", async () => {
  const browser = await shown(maple);
  const before = await frame(browser), picture = await pixels(browser);
  await browser.until(`barycage.player.frame > ${before} + 3 || barycage.player.frame < ${before}`);
  assert.notEqual(await pixels(browser), picture);
  assert.equal(await name(browser), "Pause");
  await press(browser, "play");
  assert.equal(await isPlaying(browser), false);
  assert.equal(await name(browser), "Play");
  const still = await frame(browser);
  await wait(200);
  assert.equal(await frame(browser), still);
  await rested(browser);
  await keep(browser, "moving-desktop");
  await browser.value("document.getElementById('stage').focus()");
  await browser.keys(" ");
  assert.equal(await isPlaying(browser), true);
  await browser.until(`barycage.player.frame !== ${still}`);
  await browser.keys(" ");
  assert.equal(await isPlaying(browser), false);
  await browser.value("document.getElementById('time').focus()");
  await browser.keys(home, right, right);
  assert.equal(await frame(browser), 2);
  assert.equal(await browser.value("document.getElementById('time').getAttribute('aria-valuetext')"), "Frame 2, 0.08 s");
  await browser.keys(end);
  assert.equal(await frame(browser), 95, "the last frame of a cycle is the one before the first");
  await browser.keys(" ");
  assert.equal(await isPlaying(browser), true);
  assert.deepEqual(await browser.complaints(), []);
});

test("the slider is drawn with the mouse and with a finger, and pictures follow", async () => {
  for (const [pointer, options] of [["mouse", {}], ["touch", { width: 390, height: 844, ratio: 2, touch: true }]]) {
    const browser = await shown(maple, options);
    const { left, top, width, height } = await browser.value("document.getElementById('time').getBoundingClientRect().toJSON()");
    assert.ok(height >= 44);
    const at = (share) => [left + 8 + share * (width - 16), top + height / 2];
    await browser.drag([at(0.1), at(0.3), at(0.5)], { pointer });
    assert.ok(Math.abs((await frame(browser)) - 47) < 4, `${pointer}: ${await frame(browser)}`);
    assert.equal(await isPlaying(browser), false);
    await rested(browser);
    const picture = await pixels(browser);
    await browser.drag([at(0.5), at(0.7)], { pointer });
    await rested(browser);
    assert.notEqual(await pixels(browser), picture);
    if (pointer === "touch") assert.deepEqual(await smallTargets(browser), []);
    assert.ok((await browser.value("document.documentElement.scrollWidth - innerWidth")) <= 0, "no sideways scrolling");
    await keep(browser, `moving-${pointer}`);
    assert.deepEqual(await browser.complaints(), []);
  }
});

test("who wants less motion sees a still frame, and can play it", async () => {
  const browser = await shown(maple, { switches: calm });
  await rested(browser);
  assert.equal(await isPlaying(browser), false);
  assert.equal(await frame(browser), 0);
  await press(browser, "play");
  await browser.until("barycage.player.frame > 2");
  assert.deepEqual(await browser.complaints(), []);
});

test("time runs at the rate of the file, once, round, or there and back", async () => {
  const slow = await shown(page(turning("100 10/1 cycle")));
  const seen = await framesIn(slow, 2000), steps = seen.length;
  assert.ok(steps >= 12 && steps <= 26, `${steps} frames in two seconds`);
  assert.deepEqual(seen, [...seen].sort((a, b) => a - b));
  const once = await shown(page(turning("20 20/1 off")));
  await once.until("barycage.player.frame === 20 && barycage.player.run === 0", 10);
  await press(once, "play");
  assert.ok((await frame(once)) < 20, "it begins anew");
  for (const [loop, last, ascends] of [["cycle", 11, false], ["there-and-back", 23, false]]) {
    const browser = await shown(page(turning(`12 24/1 ${loop}`)));
    const round = await framesIn(browser, 3000);
    assert.equal(Math.max(...round), last);
    assert.equal(round.every((f, i) => i === 0 || f > round[i - 1]), ascends, "it comes round");
    assert.equal(await browser.value("document.getElementById('time').max"), String(last));
  }
});

test("there and back shows the same maps on both ways", async () => {
  const browser = await shown(page(turning("12 24/1 there-and-back")), { switches: calm });
  const at = async (f) => {
    await browser.value(`barycage.player.go(${f})`);
    await rested(browser);
    return browser.value("barycage.figure.shown.rows");
  };
  const way = await at(5);
  assert.notDeepEqual(await at(9), way);
  assert.deepEqual(await at(19), way);
});

test("the cage is dragged while it plays, and stays where it was put", async () => {
  const browser = await shown(maple);
  const at = await corners(browser), before = await frame(browser);
  await browser.drag([at[1], [at[1][0] + 20, at[1][1] + 20], [at[1][0] + 60, at[1][1] + 40]]);
  const moved = await corners(browser), placed = await current(browser);
  assert.ok(Math.hypot(moved[1][0] - at[1][0] - 60, moved[1][1] - at[1][1] - 40) < 2, "the corner is under the pointer");
  assert.deepEqual(moved[0], at[0]);
  assert.equal(await isPlaying(browser), true);
  await browser.until(`Math.abs(barycage.player.frame - ${before}) > 12`);
  assert.deepEqual(await current(browser), placed);
  await press(browser, "reset");
  assert.deepEqual(await current(browser), await browser.value("barycage.figure.rest"));
  assert.equal(await isPlaying(browser), true);
  assert.deepEqual(await browser.complaints(), []);
});

test("a cage that turns with the plane is dragged as it is seen", async () => {
  const browser = await shown(page(collection("round {\n  ; barycage: animation 60 24/1 cycle\n  ; barycage: motion orbit\n"
    + "  ; barycage: count 1\n  ; barycage: pivot .3 .2\n  .5 0 0 .5 0 0\n  .5 0 0 .5 .5 0\n  .5 0 0 .5 0 .5\n}\n")), { switches: calm });
  const seen = () => browser.value(`(() => { const r = document.getElementById("stage").getBoundingClientRect();
    return barycage.figure.placed.map((p) => barycage.figure.pixel(p)).map(([x, y]) => [x + r.left, y + r.top]); })()`);
  const first = await seen();
  await browser.value("barycage.player.go(15)"); // a quarter
  await rested(browser);
  const at = await seen();
  assert.ok(Math.hypot(at[1][0] - first[1][0], at[1][1] - first[1][1]) > 50);
  await browser.drag([at[1], [at[1][0] + 20, at[1][1] + 10], [at[1][0] + 40, at[1][1] + 20]]);
  await rested(browser);
  const moved = await seen();
  assert.ok(Math.hypot(moved[1][0] - at[1][0] - 40, moved[1][1] - at[1][1] - 20) < 2);
  await browser.value("barycage.player.go(0)");
  await rested(browser);
  const back = await seen(); // turned back by a quarter, so is what was dragged
  assert.ok(Math.hypot(Math.abs(back[1][0] - first[1][0]) - 20, Math.abs(back[1][1] - first[1][1]) - 40) < 2);
  assert.deepEqual(await browser.complaints(), []);
});

test("all of the motion is in sight", async () => {
  for (const path of [maple, fern]) {
    const browser = await shown(path, { switches: calm });
    for (const f of [0, 20, 48, 71, 95]) {
      await browser.value(`barycage.player.go(${f})`);
      await rested(browser);
      const isClear = await browser.value(`(() => { const c = document.getElementById("canvas"), w = c.width, h = c.height;
        const copy = new OffscreenCanvas(w, h).getContext("2d", { willReadFrequently: true });
        copy.drawImage(c, 0, 0);
        const edges = [[0, 0, w, 1], [0, h - 1, w, 1], [0, 0, 1, h], [w - 1, 0, 1, h]].flatMap((r) => [...copy.getImageData(...r).data]);
        return edges.every((x, i) => x === edges[i % 4]); })()`);
      assert.ok(isClear, `frame ${f} of ${path}`);
    }
  }
});

test("the table shows the moment, stops time where it is touched, and changes the file's maps", async () => {
  const browser = await shown(maple, { switches: calm });
  const cell = (n) => `document.querySelectorAll("#maps input")[${n}]`;
  await browser.value("barycage.player.go(0)");
  await rested(browser);
  const first = await browser.value(`${cell(9)}.value`);
  await browser.value("barycage.player.go(30)");
  await rested(browser);
  assert.notEqual(await browser.value(`${cell(9)}.value`), first);
  await press(browser, "play");
  await browser.value(`void (${cell(3)}.id = "typed")`);
  await press(browser, "typed");
  assert.equal(await isPlaying(browser), false);
  const moment = await frame(browser), rest = await browser.value("barycage.entry.maps[0]");
  await rested(browser);
  const picture = await pixels(browser);
  await browser.value(`(() => { const c = ${cell(3)}; c.select(); })()`);
  await browser.keys("0", ".", "2");
  await browser.until(`barycage.drawing.waiting.length === 0 && barycage.entry.maps[0][4] !== ${rest[4]}`);
  await rested(browser);
  assert.ok(Math.abs((await browser.value("barycage.figure.shown.rows[0][4]")) - 0.2) < 1e-9, "what is drawn is what was typed");
  assert.notEqual(await pixels(browser), picture);
  assert.equal(await frame(browser), moment);
  const typed = await browser.value("barycage.entry.maps[0]");
  assert.notDeepEqual(typed, rest);
  assert.notEqual(typed[4], 0.2, "at rest it is another number");
  await press(browser, "reset");
  await browser.until(`JSON.stringify(barycage.entry.maps[0]) === ${JSON.stringify(JSON.stringify(rest))}`);
  // What keys move is theirs.
  const keyed = await shown(fern, { switches: calm });
  const locked = await keyed.value("[...document.querySelectorAll('#maps li')].map((li) => li.querySelector('input').readOnly)");
  assert.deepEqual(locked, [false, true, true, true]);
  assert.equal(await keyed.value("document.getElementById('hold-maps').hidden"), true);
  assert.deepEqual([...(await browser.complaints()), ...(await keyed.complaints())], []);
});

test("maps are dragged at the moment that is shown", async () => {
  const browser = await shown(maple, { switches: calm });
  await browser.value("barycage.player.go(30)");
  await press(browser, "hold-maps");
  await rested(browser);
  const handle = () => browser.value(`(() => { const r = document.querySelectorAll("#cage .middle .dot")[1].getBoundingClientRect();
    return [r.left + r.width / 2, r.top + r.height / 2]; })()`);
  const at = await handle(), rest = await browser.value("barycage.entry.maps[1]");
  await browser.drag([at, [at[0] + 15, at[1] + 5], [at[0] + 30, at[1] + 10]]);
  await rested(browser);
  const to = await handle();
  assert.ok(Math.hypot(to[0] - at[0] - 30, to[1] - at[1] - 10) < 2, "the map is under the pointer");
  assert.notDeepEqual(await browser.value("barycage.entry.maps[1]"), rest);
  assert.equal(await frame(browser), 30);
  assert.deepEqual(await browser.complaints(), []);
});

test("pictures of the frame, files and links keep what is shown", async () => {
  const browser = await shown(maple);
  await browser.value(`(() => { window.saved = []; const click = HTMLAnchorElement.prototype.click;
    URL.createObjectURL = (blob) => { (blob.type === "image/png" ? createImageBitmap(blob).then((b) => {
      const copy = new OffscreenCanvas(b.width, b.height).getContext("2d"); copy.drawImage(b, 0, 0);
      const d = copy.getImageData(0, 0, b.width, b.height).data; let sum = 0;
      for (let i = 0; i < d.length; i += 4) sum = (sum * 31 + d[i] + 256 * d[i + 1]) % 4294967291; return sum; }) : blob.text())
      .then((s) => saved.push([window.named, s])); return "blob:none"; };
    HTMLAnchorElement.prototype.click = function () { window.named = this.download; }; })()`);
  await press(browser, "png");
  await browser.until("saved.length === 1");
  const [[file, sum]] = await browser.value("saved");
  assert.equal(file, `maple_wind ${await frame(browser)}.png`);
  assert.equal(await browser.value("barycage.drawing.total >= barycage.drawing.enough"), true);
  assert.equal(sum, await pixels(browser));
  const at = await corners(browser);
  await browser.drag([at[1], [at[1][0] + 20, at[1][1] + 20], [at[1][0] + 60, at[1][1] + 40]]);
  await press(browser, "ifs");
  await browser.until("saved.length === 2");
  const text = (await browser.value("saved"))[1][1];
  assert.match(text, /; barycage: animation 96 24\/1 cycle\n/);
  assert.match(text, /; barycage: current /);
  const info = JSON.parse(execFileSync(cli, ["info", "--json", "--frame", "12", collection(text)], { encoding: "utf8" }));
  assert.ok(JSON.stringify(info).includes("\"maple_wind\""));
  assert.deepEqual(await browser.complaints(), []);
});

test("nothing plays in a tab that is not seen", async () => {
  const browser = await shown(maple);
  const [tab] = await browser.send("GET", "/window/handles");
  const { handle } = await browser.send("POST", "/window/new", { type: "tab" });
  await browser.send("POST", "/window", { handle });
  await browser.open("data:text/html,other");
  await wait(800);
  await browser.send("POST", "/window", { handle: tab });
  const hidden = await browser.value("document.hidden ? barycage.player.frame : -1");
  if (hidden < 0) { // this Chromium shows every tab: the page is told
    await browser.value("Object.defineProperty(document, 'hidden', { configurable: true, get: () => true })");
    await wait(100);
    const before = await frame(browser);
    await wait(500);
    assert.equal(await frame(browser), before);
    await browser.value("delete document.hidden");
    await browser.until(`barycage.player.frame !== ${before}`);
  } else {
    await wait(500);
    assert.equal(await frame(browser), hidden);
  }
});

test("a gallery plays what is under the pointer, and nothing else", async () => {
  const browser = await shown(page(library, "--all"));
  await browser.until("barycage.drawing.waiting.length === 0");
  const tile = (i) => `(() => { const c = document.querySelectorAll("#tiles canvas")[${i}];
    const copy = new OffscreenCanvas(60, 45).getContext("2d", { willReadFrequently: true }); copy.drawImage(c, 0, 0, 60, 45);
    return copy.getImageData(0, 0, 60, 45).data.reduce((s, x) => (s * 31 + x) % 4294967291, 0); })()`;
  const quiet = [await browser.value(tile(0)), await browser.value(tile(1))];
  await wait(500);
  assert.deepEqual([await browser.value(tile(0)), await browser.value(tile(1))], quiet);
  const [x, y] = await browser.value(`(() => { const r = document.querySelectorAll("#tiles canvas")[1].getBoundingClientRect();
    return [r.left + r.width / 2, r.top + r.height / 2]; })()`);
  const over = (px, py) => browser.send("POST", "/actions", { actions: [{ type: "pointer", id: "mouse", parameters: { pointerType: "mouse" },
    actions: [{ type: "pointerMove", duration: 20, x: Math.round(px), y: Math.round(py) }] }] });
  await over(x, y);
  await browser.until(`${tile(1)} !== ${quiet[1]}`);
  const moving = await browser.value(tile(1));
  await browser.until(`${tile(1)} !== ${moving} && ${tile(1)} !== ${quiet[1]}`);
  assert.equal(await browser.value(tile(0)), quiet[0]);
  await keep(browser, "moving-gallery");
  await over(5, 5);
  await browser.until(`${tile(1)} === ${quiet[1]} && barycage.drawing.waiting.length === 0`);
  // A click leads to the figure, which plays; Back stops it.
  await browser.drag([[x, y]]);
  await browser.until("document.body.dataset.view === 'figure' && barycage.player.run > 0");
  await browser.send("POST", "/back", {});
  await browser.until("document.body.dataset.view === 'gallery'");
  assert.equal(await isPlaying(browser), false);
  assert.deepEqual(await browser.complaints(), []);
});

test("a figure alone keeps its button and slider, and a solid turns", async () => {
  const browser = await shown(page(library, "--entry", "menger_turning", "--show", "figure"));
  assert.equal(await browser.value("getComputedStyle(document.querySelector('aside')).display"), "none");
  const before = await pixels(browser);
  await browser.until("barycage.player.frame > 3");
  assert.notEqual(await pixels(browser), before);
  await press(browser, "play");
  await rested(browser);
  // The corners of the cage go round with the picture.
  const at = await corners(browser);
  await browser.value("barycage.player.go((barycage.player.frame + 24) % 96)");
  await rested(browser);
  assert.ok((await corners(browser)).some(([x, y], i) => Math.hypot(x - at[i][0], y - at[i][1]) > 30));
  await keep(browser, "moving-solid");
  assert.deepEqual(await browser.complaints(), []);
});

test("keys of the camera lead the view, and a hand takes over where time stands", async () => {
  const browser = await shown(page(library, "--entry", "endless_zoom"), { switches: calm });
  const scale = () => browser.value("barycage.figure.camera.scale(barycage.figure.size)");
  await browser.value("barycage.player.go(0)");
  await rested(browser);
  const wide = await scale();
  await browser.value("barycage.player.go(20)");
  await rested(browser);
  assert.ok((await scale()) > 1.1 * wide);
  await press(browser, "fit");
  await rested(browser);
  const whole = await scale();
  await wait(100);
  assert.equal(await scale(), whole);
  assert.deepEqual(await browser.complaints(), []);
});

test("what does not move has neither button nor slider, and pages that move are small", async () => {
  const still = await shown(page(join(source, "ifs_library/paper.ifs"), "--entry", "maple"));
  assert.equal(await still.value("document.getElementById('play').offsetParent"), null);
  assert.equal(await still.value("barycage.player.motion"), null);
  await still.value("document.getElementById('stage').focus()");
  await still.keys(" ");
  assert.equal(await isPlaying(still), false);
  assert.ok(statSync(maple).size <= 500_000, `${statSync(maple).size} bytes`);
});

test("axe finds nothing that keeps anybody out, in light and dark, and in every language", async () => {
  for (const [dark, locale] of [[false, "en"], [true, "de"], [false, "mk"]]) {
    const browser = await shown(maple, { dark, locale, switches: calm });
    assert.deepEqual(await obstacles(browser), []);
    await keep(browser, `moving-${locale}`);
  }
});
