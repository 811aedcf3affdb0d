// SPDX-License-Identifier: MIT
// A page within another one, by the snippets that docs/guide.md gives. As page_test.mjs.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { Browser } from "./browser.mjs";
import { cli, corners, current, folder, keep, obstacles, open, page, paper, pixels, rested, smallTargets, source } from "./pages.mjs";

const guide = readFileSync(join(source, "docs/guide.md"), "utf8");

/** An article, without a word of its encoding. @param {string} name @param {string} body */
async function article(name, body, options) {
  const path = join(folder, name);
  writeFileSync(path, `<!doctype html><html lang="en"><title>An article</title><meta name="viewport" content="width=device-width">
    <body style="max-width: 700px; margin: 20px auto"><h1>An article</h1>${body}<p>Text below the figures</p>`);
  const browser = await Browser.start(options);
  open.push(browser);
  await browser.open(`file://${path}`);
  return browser;
}

/** Looks at one of the figures of an article from now on, when it is live; null: at the article.
 * @param {number | null} id */
async function enter(browser, id) {
  await browser.send("POST", "/frame", { id: null });
  if (id === null) return;
  await browser.until(`document.querySelectorAll("iframe").length > ${id}`);
  await browser.send("POST", "/frame", { id });
  await browser.until("window.barycage && document.body.dataset.state === 'live'");
  await rested(browser);
}

const frames = (browser) => browser.value(`[...document.querySelectorAll("iframe")].map((f) => {
  const { x, y, width, height } = f.getBoundingClientRect(); return { x, y, width, height, title: f.title }; })`);

test("scripts put figures into an article: one engine draws them, and each is dragged alone", async () => {
  const snippets = guide.match(/^ *<script src="paper.js" data-entry="\w+"><\/script>/gm) ?? [];
  assert.equal(snippets.length, 2);
  execFileSync(cli, ["page", paper, "--all", "--show", "figure", "--lang", "mk", "-o", join(folder, "paper.js")]);
  execFileSync(cli, ["page", paper, "--entry", "maple", "--caption", "Die Blätter “fallen”", "-o", join(folder, "maple.js")]);
  const browser = await article("scripts.html", [...snippets, "<script src=\"maple.js\"></script>"].join("<p>Text</p>"));
  for (const [id, name] of ["maple", "flower", "maple"].entries()) {
    await enter(browser, id);
    assert.equal(await browser.value("document.getElementById('name').textContent"), name);
    assert.equal(await browser.value("barycage.entry.name"), name);
    assert.equal(await browser.value("barycage.drawing.worker.constructor.name"), "MessagePort");
    await browser.until("document.documentElement.scrollHeight <= innerHeight", 5); // the frame is as high
  }
  assert.equal(await browser.value("document.getElementById('caption').textContent"), "Die Blätter “fallen”");
  await enter(browser, 1);
  const other = await pixels(browser);
  await enter(browser, 0);
  assert.match(await browser.value("document.getElementById('hint').textContent"), /\p{Script=Cyrillic}/u);
  const at = await corners(browser), before = await pixels(browser);
  await enter(browser, null);
  assert.equal(await browser.value("barycageWorkers.size"), 1);
  assert.deepEqual((await frames(browser)).map(({ title }) => title), ["maple", "flower", "maple"]);
  await keep(browser, "article");
  const [{ x, y }] = await frames(browser);
  await browser.drag([0, 20, 40].map((way) => [x + at[1][0] + way, y + at[1][1] + way / 2]));
  await enter(browser, 0);
  assert.notEqual(await pixels(browser), before);
  const moved = await corners(browser);
  assert.ok(Math.hypot(moved[1][0] - at[1][0] - 40, moved[1][1] - at[1][1] - 20) < 2);
  await enter(browser, 1);
  assert.equal(await pixels(browser), other, "the other figure is as it was");
  assert.deepEqual(await browser.complaints(), []);
});

test("a figure of an article has a title and a tool of its own, and the wheel scrolls past it until it is used", async () => {
  const snippet = guide.match(/^ *<script src="paper.js"[^\n]*data-tool[^\n]*<\/script>/m)?.[0] ?? "";
  execFileSync(cli, ["page", paper, "--all", "--show", "figure", "-o", join(folder, "paper.js")]);
  const browser = await article("titles.html", `${snippet}<p style="height: 2000px">Text</p>`);
  const title = snippet.match(/data-title="([^"]+)"/)?.[1];
  await enter(browser, 0);
  assert.ok(title);
  assert.equal(await browser.value("document.getElementById('name').textContent"), title);
  assert.equal(await browser.value("barycage.entry.name"), "maple");
  assert.equal(await browser.value("barycage.figure.holdsMaps"), true);
  assert.equal(await browser.value("document.getElementById('hold-maps').getAttribute('aria-pressed')"), "true");
  const scale = "barycage.figure.camera.height", start = await browser.value(scale);
  await enter(browser, null);
  const [place] = await frames(browser);
  assert.equal(place.title, title);
  const middle = [Math.round(place.x + place.width / 2), Math.round(place.y + 200)];
  const roll = (deltaY) => browser.send("POST", "/actions", { actions: [{ type: "wheel", id: "wheel",
    actions: [{ type: "scroll", x: middle[0], y: middle[1], deltaX: 0, deltaY, duration: 0, origin: "viewport" }] }] });
  await roll(120);
  await browser.until("scrollY === 120");
  await roll(-120);
  await browser.until("scrollY === 0");
  await enter(browser, 0);
  assert.equal(await browser.value(scale), start);
  await enter(browser, null);
  await browser.drag([[place.x + 20, place.y + 20]]); // a click on the figure, beside what it shows
  await roll(120);
  await enter(browser, 0);
  await browser.until(`${scale} > ${start}`);
  await enter(browser, null);
  assert.equal(await browser.value("scrollY"), 0);
  assert.deepEqual(await browser.complaints(), []);
});

test("figures of an article on a telephone, dark, for everybody", async () => {
  execFileSync(cli, ["page", paper, "--entry", "maple", "-o", join(folder, "phone.js")]);
  const browser = await article("phone.html", "<script src=\"phone.js\"></script>", { width: 390, height: 844, ratio: 2, touch: true, dark: true });
  await enter(browser, 0);
  assert.deepEqual(await smallTargets(browser), []);
  assert.deepEqual(await obstacles(browser), []);
  assert.ok((await browser.value("document.documentElement.scrollWidth - innerWidth")) <= 0, "no sideways scrolling");
  // What is longer makes the frame higher.
  await browser.value("void (document.getElementById('caption').textContent = 'word '.repeat(200))");
  await browser.until("document.documentElement.scrollHeight <= innerHeight && innerHeight > 900");
  await enter(browser, null);
  await keep(browser, "article-phone-dark");
  assert.deepEqual(await browser.complaints(), []);
});

test("a figure in a frame of another page is dragged there", async () => {
  const snippet = guide.match(/^ *<iframe [^\n]*<\/iframe>/m)?.[0] ?? "";
  assert.match(snippet, /src="maple.html"/);
  const figure = page(paper, "--entry", "maple", "--show", "figure");
  const outer = join(folder, "outer.html");
  writeFileSync(outer, `<!doctype html><meta charset="utf-8"><title>An article</title><h1>An article</h1>
    ${snippet.replace("maple.html", figure)}<p>Text below the figure</p>`);
  const browser = await Browser.start();
  open.push(browser);
  await browser.open(`file://${outer}`);
  await browser.until("document.querySelector('iframe')");
  await keep(browser, "frame-before");
  await browser.send("POST", "/frame", { id: 0 });
  await browser.until("window.barycage && document.body.dataset.state === 'live'");
  await rested(browser);
  assert.ok(await browser.value("document.documentElement.scrollHeight <= innerHeight"), "nothing is to be scrolled in the frame");
  const at = await corners(browser), start = await current(browser);
  // The pointer moves over the article, of which the frame is a part.
  await browser.send("POST", "/frame", { id: null });
  const { x, y } = await browser.value("document.querySelector('iframe').getBoundingClientRect().toJSON()");
  await browser.drag([0, 20, 40].map((way) => [x + at[1][0] + way, y + at[1][1] + way / 2]));
  await keep(browser, "frame");
  await browser.send("POST", "/frame", { id: 0 });
  const moved = await corners(browser);
  assert.ok(Math.hypot(moved[1][0] - at[1][0] - 40, moved[1][1] - at[1][1] - 20) < 2);
  assert.notDeepEqual(await current(browser), start);
  assert.deepEqual(await browser.complaints(), []);
});
