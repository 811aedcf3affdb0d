// SPDX-License-Identifier: MIT
// A page within another one, by the snippet that docs/guide.md gives. As page_test.mjs.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { Browser } from "./browser.mjs";
import { corners, current, folder, keep, open, page, paper, rested, source } from "./pages.mjs";

test("a figure in a frame of another page is dragged there", async () => {
  const snippet = readFileSync(join(source, "docs/guide.md"), "utf8").match(/^ *<iframe [^\n]*<\/iframe>/m)?.[0] ?? "";
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
