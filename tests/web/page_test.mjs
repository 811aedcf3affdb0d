// SPDX-License-Identifier: MIT
// Pages that barycage-cli writes, in Chromium, with real events: node --test page_test.mjs, with the program in
// BARYCAGE_CLI and the folder of axe-core in BARYCAGE_NODE_MODULES.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync, readdirSync, statSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { Browser } from "./browser.mjs";
import { alt, cli, collection, control, corners, current, escape, folder, keep, obstacles, open, page, paper, pixels, rested, right, shift,
  shown, smallTargets, source, tab } from "./pages.mjs";


const maple = page(paper, "--entry", "maple", "--caption", "Drag a corner: “the class drags the maple”.");

test("a corner is dragged with the mouse, and the picture follows", async () => {
  const browser = await shown(maple);
  await rested(browser);
  await keep(browser, "desktop-light");
  const before = await pixels(browser), at = await corners(browser);
  await browser.drag([at[1], [at[1][0] + 60, at[1][1] + 30], [at[1][0] + 120, at[1][1] + 60]]);
  await rested(browser);
  const moved = await corners(browser);
  assert.ok(Math.hypot(moved[1][0] - at[1][0] - 120, moved[1][1] - at[1][1] - 60) < 2, "the corner is under the pointer");
  assert.deepEqual(moved[0], at[0]);
  assert.notEqual(await pixels(browser), before);
  await keep(browser, "desktop-dragged");
  // Reset brings the same pixels back.
  await browser.value("document.getElementById('reset').click()");
  await rested(browser);
  const [x, y] = (await current(browser))[1];
  assert.deepEqual([x, y], (await browser.value("barycage.figure.rest"))[1]);
  assert.deepEqual(await browser.complaints(), []);
});

test("edges, the inside, and the keys that rotate, scale and constrain", async () => {
  const browser = await shown(maple);
  const start = await current(browser);
  const at = await corners(browser);
  const between = (a, b) => [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
  const inside = [(at[0][0] + at[1][0] + at[2][0]) / 3, (at[0][1] + at[1][1] + at[2][1]) / 3];
  const to = ([x, y], dx, dy) => [[x, y], [x + dx / 2, y + dy / 2], [x + dx, y + dy]];
  await browser.drag(to(between(at[0], at[1]), 0, 40));
  let now = await current(browser);
  assert.notDeepEqual(now[0], start[0]);
  assert.notDeepEqual(now[1], start[1]);
  assert.deepEqual(now[2], start[2]);
  await browser.value("barycage.figure.reset()");
  await browser.drag(to(inside, 30, 5), { key: shift });
  now = await current(browser);
  assert.equal(now[0][1], start[0][1], "constrained to x");
  assert.ok(now[0][0] > start[0][0]);
  const length = (p) => Math.hypot(p[0][0] - p[1][0], p[0][1] - p[1][1]);
  for (const [key, isRigid] of [[control, true], [alt, false]]) {
    await browser.value("barycage.figure.reset()");
    const off = [inside[0] + 30, inside[1]];
    await browser.drag(to(off, 15, 25), { key });
    now = await current(browser);
    assert.notDeepEqual(now, start);
    assert.equal(Math.abs(length(now) - length(start)) < 1e-9, isRigid);
  }
  // A drag outside moves the view, and Escape takes back what is being dragged.
  await browser.value("barycage.figure.reset()");
  const view = await browser.value("barycage.figure.camera.target[0]");
  await browser.drag(to([at[0][0] - 60, at[2][1] - 20], 50, 0));
  assert.ok((await browser.value("barycage.figure.camera.target[0]")) < view);
  await browser.value("barycage.figure.reset()");
  await browser.value("document.getElementById('stage').focus()");
  await browser.drag(to(at[1], 50, 50), { release: false });
  assert.notDeepEqual(await current(browser), start);
  await browser.keys(escape);
  assert.deepEqual(await current(browser), start);
  assert.deepEqual(await browser.complaints(), []);
});

test("the keyboard alone moves corners, and says where they are", async () => {
  const browser = await shown(maple);
  const start = await current(browser);
  await browser.value("document.getElementById('stage').focus()");
  await browser.keys(tab);
  assert.match(await browser.value("document.activeElement.getAttribute('aria-label')"), /^Corner 1, at \(/);
  await browser.keys(right, right);
  const now = await current(browser);
  assert.ok(now[0][0] > start[0][0]);
  assert.equal(now[0][1], start[0][1]);
  assert.match(await browser.value("document.getElementById('said').textContent"), /^Corner 1, at \(/);
  await keep(browser, "keyboard");
  assert.deepEqual(await browser.complaints(), []);
});

test("a telephone: fingers drag, pinch, and nothing is cut off", async () => {
  const browser = await shown(maple, { width: 390, height: 844, ratio: 2, touch: true });
  await rested(browser);
  await keep(browser, "phone-light");
  assert.ok((await browser.value("document.documentElement.scrollWidth - innerWidth")) <= 0, "no sideways scrolling");
  const at = await corners(browser);
  await browser.drag([[at[2][0] - 14, at[2][1] - 10], [at[2][0] - 40, at[2][1] - 40], [at[2][0] - 60, at[2][1] - 60]],
    { pointer: "touch" });
  const moved = await corners(browser);
  assert.ok(moved[2][0] < at[2][0] - 30, "a finger beside the corner holds it");
  const scale = await browser.value("barycage.figure.camera.scale(barycage.figure.size)");
  await browser.pinch([[150, 200], [250, 200]], [[90, 200], [310, 200]]);
  assert.ok((await browser.value("barycage.figure.camera.scale(barycage.figure.size)")) > 1.5 * scale);
  assert.deepEqual(await smallTargets(browser), [], "targets are large enough for fingers");
  assert.deepEqual(await browser.complaints(), []);
});

test("a window of another size shows all, and back in the old one everything is where it was", async () => {
  const browser = await shown(maple);
  const before = await corners(browser), camera = "JSON.stringify([barycage.figure.camera, barycage.figure.size])";
  const first = await browser.value(camera);
  await browser.send("POST", "/window/rect", { width: 560, height: 900 });
  await browser.until(`${camera} !== ${JSON.stringify(first)}`);
  const { width, height } = await browser.value("barycage.figure.size");
  const inside = await browser.value("barycage.figure.current.map((p) => barycage.figure.pixel(p))");
  assert.ok(inside.every(([x, y]) => x > 0 && x < width && y > 0 && y < height), "the corners of the cage are seen");
  await browser.send("POST", "/window/rect", { width: 1280, height: 900 });
  await browser.until(`${camera} === ${JSON.stringify(first)}`);
  assert.deepEqual(await corners(browser), before);
  assert.deepEqual(await browser.complaints(), []);
});

test("maps are typed, as numbers and as expressions", async () => {
  const browser = await shown(maple);
  await rested(browser);
  const before = await pixels(browser);
  const type = (value) => browser.value(`(() => { const cell = document.querySelectorAll("#maps input")[8]; cell.focus();
    cell.value = ${JSON.stringify(value)}; cell.dispatchEvent(new Event("input", { bubbles: true })); })()`);
  await type("1/2 + 0*cos(60°)");
  await browser.until("barycage.entry.maps[1][0] === 0.5");
  await rested(browser);
  assert.notEqual(await pixels(browser), before);
  await type("0.5 apples");
  assert.match(await browser.value("document.getElementById('problem').textContent"), /“0.5 apples” is not a number/);
  assert.equal(await browser.value("barycage.entry.maps[1][0]"), 0.5);
  await type("1.5");
  await browser.until("document.getElementById('problem').textContent.includes('no attractor')");
  await type("0.61");
  await browser.until("document.getElementById('problem').textContent === ''");
  await rested(browser);
  assert.deepEqual(await browser.complaints(), []);
});

test("the entry that a page saves is read again, as it was dragged", async () => {
  const browser = await shown(maple);
  await browser.value(`(() => { window.saved = []; URL.createObjectURL = (blob) => { blob.text().then((t) => saved.push(t));
    return "data:,"; }; HTMLAnchorElement.prototype.click = () => {}; })()`);
  const at = await corners(browser);
  await browser.drag([at[0], [at[0][0] + 20, at[0][1] + 10], [at[0][0] + 40, at[0][1] + 30]]);
  await browser.value("document.getElementById('ifs').click()");
  await browser.until("saved.length === 1");
  const file = collection(await browser.value("saved[0]"));
  const info = JSON.parse(execFileSync(cli, ["info", "--json", file], { encoding: "utf8" }));
  const entries = JSON.stringify(info);
  for (const number of (await current(browser)).flat()) assert.ok(entries.includes(String(number)), `${number} is kept`);
  assert.deepEqual(await browser.complaints(), []);
});

test("palettes change the picture", async () => {
  const browser = await shown(maple);
  await rested(browser);
  const before = await pixels(browser);
  await browser.value("document.querySelectorAll('#palettes button')[2].click()");
  await browser.until("document.querySelectorAll('#palettes button')[2].getAttribute('aria-checked') === 'true'");
  await rested(browser);
  assert.notEqual(await pixels(browser), before);
  assert.deepEqual(await browser.complaints(), []);
});

test("dark pages, and pages in five languages", async () => {
  for (const [language, word] of [["de", "Abbildungen"], ["es", "Aplicaciones"], ["fr", "Applications"], ["mk", "Пресликувања"], ["en", "Maps"]]) {
    const browser = await shown(page(paper, "--entry", "maple", "--lang", language), { dark: true });
    assert.equal(await browser.value("document.getElementById('table-title').textContent"), word);
    assert.equal(await browser.value("document.documentElement.lang"), language);
    if (language === "de") {
      await rested(browser);
      await keep(browser, "desktop-dark");
    }
    assert.deepEqual(await browser.complaints(), []);
  }
});

test("a figure alone, of a given size", async () => {
  const browser = await shown(page(paper, "--entry", "maple", "--show", "figure", "--size", "600x400", "--allow", "none"));
  const { width, height } = await browser.value("barycage.figure.size");
  assert.equal(Math.round(width), 600);
  assert.equal(Math.round(height), 400);
  assert.equal(await browser.value("document.querySelectorAll('.corner').length"), 0);
  assert.equal(await browser.value("getComputedStyle(document.querySelector('aside')).display"), "none");
  await rested(browser);
  await keep(browser, "figure");
});

test("a solid turns, and its corners bend it", async () => {
  const browser = await shown(page(join(source, "ifs_library/space_sponges.ifs"), "--entry", "menger"));
  await rested(browser);
  await keep(browser, "solid");
  const before = await pixels(browser);
  const { left, top, width, height } = await browser.value("document.getElementById('stage').getBoundingClientRect().toJSON()");
  const middle = [left + width / 2, top + height / 2];
  await browser.drag([middle, [middle[0] + 60, middle[1]], [middle[0] + 120, middle[1] + 20]]);
  await rested(browser);
  assert.notEqual(await pixels(browser), before);
  assert.notEqual(await browser.value("barycage.figure.camera.azimuth"), 30);
  const at = await corners(browser);
  await browser.drag([at[1], [at[1][0] + 20, at[1][1] - 20], [at[1][0] + 40, at[1][1] - 40]]);
  const moved = await corners(browser);
  assert.ok(Math.hypot(moved[1][0] - at[1][0] - 40, moved[1][1] - at[1][1] + 40) < 2);
  assert.deepEqual(await browser.complaints(), []);
});

test("what has no attractor is shown around the origin, and a single point, too", async () => {
  for (const [rows, isCertain] of [[" 1.2 0 0 .5 0 0 .5\n .5 0 0 .5 .2 .2 .5\n", false], [" .5 0 0 .5 0 0 1\n", true]]) {
    const browser = await shown(page(collection(`odd {\n${rows}}\n`), "-q", "--points", "10k"));
    await rested(browser);
    assert.equal(await browser.value("barycage.figure.extent !== null"), isCertain);
    assert.equal(await browser.value("document.getElementById('problem').textContent === ''"), isCertain);
    const ends = await browser.value("[[-1, -1], [1, 1]].map((p) => barycage.figure.pixel(p))");
    const { width, height } = await browser.value("barycage.figure.size");
    if (!isCertain) assert.ok(ends.flat().every((x, i) => x > 0 && x < (i % 2 === 0 ? width : height)) && ends[1][0] - ends[0][0] > height / 2);
    assert.ok(ends.flat().every(Number.isFinite));
    assert.deepEqual(await browser.complaints(), []);
  }
});

test("hostile names and captions are text", async () => {
  const name = "x</script><img src=x onerror=\"window.pwned=1\">";
  const file = collection(`${name} { ; </script><script>window.pwned=1</script>\n .5 0 0 .5 0 0\n .5 0 0 .5 .5 0\n .5 0 0 .5 0 .5\n}\n`);
  const browser = await shown(page(file, "--caption", "{{script}} <b>bold</b> & </style><script>window.pwned=2</script> \u2028"));
  await rested(browser);
  assert.equal(await browser.value("window.pwned ?? null"), null);
  assert.equal(await browser.value("document.querySelector('h1').textContent"), name);
  assert.match(await browser.value("document.querySelector('.caption').textContent"), /^\{\{script\}\} <b>bold<\/b> & <\/style>/);
  assert.deepEqual(await browser.complaints(), []);
});

test("without WebAssembly there is a still picture and a sentence", async () => {
  const path = join(folder, "broken.html");
  writeFileSync(path, readFileSync(maple, "utf8").replace(/(<script type="text\/plain" id="engine">)[^<]{200}/, "$1"));
  const browser = await Browser.start();
  open.push(browser);
  await browser.open(`file://${path}`);
  await browser.until("document.getElementById('plain').textContent.includes('WebAssembly')");
  assert.equal(await browser.value("document.body.dataset.state"), "still");
  assert.ok(await browser.value("document.getElementById('still').naturalWidth > 100"));
  await keep(browser, "still");
});

test("a page that is still loading asks for no other browser", async () => {
  const browser = await Browser.start();
  open.push(browser);
  await browser.send("POST", "/goog/cdp/execute", { cmd: "Page.addScriptToEvaluateOnNewDocument",
    params: { source: "window.Worker = class { postMessage() {} };" } }); // whose engine never answers
  await browser.open(`file://${maple}`);
  assert.equal(await browser.value("document.body.dataset.state"), "still");
  assert.equal(await browser.value("document.getElementById('plain').checkVisibility()"), false);
  assert.ok(await browser.value("document.getElementById('still').checkVisibility()"));
});

test("axe finds nothing that keeps anybody out", async () => {
  for (const dark of [false, true]) {
    const browser = await shown(maple, { dark });
    assert.deepEqual(await obstacles(browser), []);
  }
});

test("nothing leaves the page, and it is small", async () => {
  for (const name of readdirSync(folder).filter((file) => file.endsWith(".html"))) {
    const text = readFileSync(join(folder, name), "utf8");
    const limit = text.includes("\"dimension\": 3") ? 600_000 : 450_000;
    assert.ok(statSync(join(folder, name)).size <= limit, `${name} has ${text.length} bytes`);
    assert.doesNotMatch(text, /new Blob\([^)]*\)\.(stream|text|arrayBuffer)\(/, "WebKitGTK cannot read a Blob of a page on a disk");
    assert.doesNotMatch(text, /\.innerHTML|document\.write|eval\(|https?:\/\/(?!www\.w3\.org\/2000\/svg)/);
  }
});
