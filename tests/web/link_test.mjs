// SPDX-License-Identifier: MIT
// Links to entries: pages that are opened by one, and the links that they copy. As page_test.mjs.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { constants, deflateRawSync, gunzipSync, inflateRawSync } from "node:zlib";
import { startedEngine } from "../../app/web/page/engine.js";
import { readEntry } from "../../app/web/page/entry_reader.js";
import { entryText } from "../../app/web/page/ifs_text.js";
import { cli, collection, corners, current, keep, page, paper, pixels, press, rested, shown, source } from "./pages.mjs";

const maple = page(paper, "--entry", "maple", "--caption", "A caption of the maple");
const solid = page(join(source, "ifs_library/space_sponges.ifs"), "--entry", "menger");
const inBase64 = (bytes) => bytes.toString("base64url");
/** The address of a page with this text in its link. */
const address = (path, text) => `file://${path}#${inBase64(deflateRawSync(text))}`;
const heading = (browser) => browser.value("document.querySelector('h1').textContent");
const notice = (browser) => browser.value("document.getElementById('notice').textContent");
const triangle = `triangle {
  ; barycage: version 1
  ; barycage: palette glacier
  ; barycage: gamma 3
  ; barycage: background #f0f0e0
  ; barycage: map-colour 2 #ff0000ff
  .5 0 0 .5 0 0 .3
  .5 0 0 .5 .5 0 .3
  .5 0 0 .5 .25 .5 .4
}
`;

/** Opens an address as if in a new window. */
async function visit(browser, url) {
  await browser.open("about:blank");
  await browser.open(url);
  await browser.until("window.barycage && document.body.dataset.state === 'live'");
}

/** In place of the clipboard, which nobody may read here. @param {string} writeText */
const onClipboard = (browser, writeText) =>
  browser.value(`void Object.defineProperty(navigator, "clipboard", { configurable: true, value: { writeText: ${writeText} } })`);

/** What Copy Link puts on the clipboard. */
async function copied(browser) {
  await onClipboard(browser, "async (text) => { window.copiedLink = text; }");
  await press(browser, "copy-link");
  await browser.until("document.getElementById('copied').textContent !== ''");
  return browser.value("window.copiedLink");
}

test("a page that is opened by a link shows its entry, and none of the page's own", async () => {
  const browser = await shown(address(maple, triangle));
  await rested(browser);
  assert.equal(await heading(browser), "triangle");
  assert.equal(await browser.value("document.title"), "triangle");
  assert.equal(await browser.value("document.querySelector('.caption').textContent"), "");
  assert.equal(await browser.value("barycage.entry.maps.length"), 3);
  assert.equal(await browser.value("document.querySelector('#palettes [aria-checked=true]').title"), "Glacier");
  assert.equal(await notice(browser), "");
  await keep(browser, "link");
  assert.deepEqual(await browser.complaints(), []);
});

// Everything that comment lines can say of a picture.
const everyLine = collection(`flat {
  ; barycage: version 1
  ; barycage: symmetry d3:15
  ; barycage: symmetry-centre 0.5 0.25
  ; barycage: branch 2 1
  ; barycage: by 1 0.1
  ; barycage: by 0 0.9
  ; barycage: by 0.3 -0.2
  ; barycage: colour-by blend
  ; barycage: palette mine
  ; barycage: stop 0 #102030ff
  ; barycage: stop 1 #f0e0d0ff
  ; barycage: plain #00ff00ff
  ; barycage: background #ffffff00
  ; barycage: brightness 7
  ; barycage: contrast 1.5
  ; barycage: vibrancy 0.25
  ; barycage: supersample 2
  ; barycage: off 3 0.2
  ; barycage: map-colour 1 #ff8000ff
  ; barycage: map-blend 1 0.9 0.75
  ; barycage: map-blend 2 0.1
  .5 0 0 .5 0 0 .6
  .4 -.1 .1 .4 .5 .1 .4
  .5 0 0 .5 0 .5 0
}
joined {
  ; barycage: version 1
  ; barycage: rest 0 0
  ; barycage: rest 1 0
  ; barycage: rest 1 1
  ; barycage: rest 0 1
  ; barycage: current 0 0
  ; barycage: current 1.1000000000000001 \\
  ; barycage: current 0.10000000000000001
  ; barycage: current 1 1.25
  ; barycage: current 0 1
  ; barycage: colour-by map
  ; barycage: links 1 1 0 1
  ; barycage: links 3 0.5
  ; barycage: links 3 1 0
  ; barycage: unweighted all
  .5 0 0 .5 0 0 .3
  .5 0 0 .5 .5 0 .3
  .5 0 0 .5 0 .5 .4
}
stiff {
  ; barycage: version 1
  ; barycage: rest 0 0
  ; barycage: rest 1 0
  ; barycage: rest 1 1
  ; barycage: rest 0 1
  ; barycage: current 0 0
  ; barycage: current 1 0
  ; barycage: current 1.5 1.25
  ; barycage: current 0 1
  ; barycage: deformation affine-fit
  ; barycage: colour-by plain
  .5 0 0 .5 0 0
  .5 0 0 .5 .5 0
  .5 0 0 .5 0 .5
}
cut (3D) {
  ; barycage: version 1
  ; barycage: symmetry octahedral
  ; barycage: space-look ink
  ; barycage: solid-colour height
  ; barycage: light 30 -10
  ; barycage: fog 0.5
  ; barycage: clip-normal 0 0 1
  ; barycage: clip-range - 0.25
  .3 0 0 0 .3 0 0 0 .3 .6 .2 0 1
  .2 0 0 0 .2 0 0 0 .2 .1 .1 .1 1
}
cloud (3D) {
  ; barycage: version 1
  ; barycage: branch 1
  ; barycage: by 1 0 0
  ; barycage: by 0 1 0.2
  ; barycage: by 0 0 1
  ; barycage: by 0 0.5 0
  ; barycage: space-look cloud
  .5 0 0 0 .5 0 0 0 .5 0 0 0 .2
  .5 0 0 0 .5 0 0 0 .5 .5 0 0 .4
  .5 0 0 0 .5 0 0 0 .5 0 .5 .5 .4
}
`);

test("a link and a page give the engine the same entry, and so the same pixels", async () => {
  const engine = await startedEngine(gunzipSync(readFileSync(join(source, "app/web/built/engine.wasm.gz"))));
  const library = join(source, "ifs_library"), own = join(source, "tests/data/seeds/own_lines.ifs");
  const drawn = (entry) => {
    const { box, simplex } = engine.load(entry);
    engine.setCamera(200, 150, entry.dimension === 3 ? [.5, .5, .5, 30, 20, 2, 0] : [(box[0] + box[2]) / 2, (box[1] + box[3]) / 2,
      120 / (box[2] - box[0])]);
    const { rest, current: moved, bends } = entry.cage ?? { rest: simplex, current: simplex, bends: true };
    engine.setCage(rest, moved, bends);
    engine.draw(200_000, true, false);
    return engine.hash();
  };
  const hashes = new Set();
  for (const [file, ...names] of [[everyLine, "flat", "joined", "stiff", "cut", "cloud"], [own, "everything"], [paper, "maple"],
    [join(library, "linked.ifs"), "penrose_tiles"], [join(library, "motion.ifs"), "menger_turning"]])
    for (const name of names) {
      const html = readFileSync(page(file, "--entry", name), "utf8");
      const { entry } = JSON.parse(html.match(/id="content">([^]*?)<\/script>/)[1]);
      const { rest = [], current: moved = [] } = entry.cage ?? {};
      const read = readEntry(entryText(entry, rest, moved, false), engine.palettes());
      assert.ok("entry" in read, `${name} is read`);
      for (const part of ["name", "dimension", "maps", "links", "symmetry", "cage", "solid"])
        assert.deepEqual(read.entry[part], entry[part], `${part} of ${name}`);
      assert.deepEqual(read.entry.branches, entry.branches ?? [], name);
      assert.deepEqual(read.entry.appearance.stops, entry.appearance.stops, name);
      assert.equal(drawn(read.entry), drawn(entry), name);
      hashes.add(drawn(entry));
    }
  assert.equal(hashes.size, 9);
});

test("points that go on in another line are read, and branches inside themselves are left to the program", () => {
  const palettes = [{ name: "Maple", stops: [[0, 0, 0, 0, 255], [1, 255, 255, 255, 255]] }];
  const line = (text) => `  ; barycage: ${text}\n`;
  const solidText = (lines) => `a (3D) {\n${lines.map(line).join("")}  .5 0 0 0 .5 0 0 0 .5 0 0 0 1\n}\n`;
  const rest = ["0 0 0", "1 0 0", "0 1 0", "0 0 1"];
  const moved = ["0 0 0", "1.25 \\", "0.5 \\", "0.125", "0 1 0", "0 0 \\", "1"];
  const read = readEntry(solidText([...rest.map((p) => `rest ${p}`), ...moved.map((p) => `current ${p}`)]), palettes);
  assert.deepEqual(read.entry.cage.current, [[0, 0, 0], [1.25, .5, .125], [0, 1, 0], [0, 0, 1]]);
  assert.deepEqual(readEntry(solidText(["branch 0 1", "by 1 0 0", "by 0 1 0", "by 0 0 1", "by 0 0 1"]), palettes), { flaw: "linkForeign" });
});

test("a link that is copied holds what has been dragged, typed and chosen", async () => {
  const browser = await shown(maple);
  await rested(browser);
  const at = await corners(browser);
  await browser.drag([at[1], [at[1][0] + 20, at[1][1] + 20], [at[1][0] + 60, at[1][1] + 40]]);
  await browser.value("document.querySelectorAll('#palettes button')[2].click()");
  await browser.value(`(() => { const cell = document.querySelectorAll("#maps input")[8]; cell.focus();
    cell.value = "1/2"; cell.dispatchEvent(new Event("input", { bubbles: true })); cell.blur(); })()`);
  await browser.until("barycage.entry.maps[1][0] === 0.5");
  const link = await copied(browser);
  await keep(browser, "link-copied");
  assert.match(link, /^file:\/\/.*\.html#[\w-]{100,2000}$/);
  const text = inflateRawSync(Buffer.from(link.replace(/.*#/, ""), "base64url")).toString();
  assert.match(text, /^maple \{ ; Maple\n[^]*; barycage: palette Glacier\n[^]*\}\n$/);
  // The program reads it…
  const info = JSON.parse(execFileSync(cli, ["info", "--json", link], { encoding: "utf8" }));
  const now = await current(browser);
  assert.ok(now.flat().every((x) => JSON.stringify(info).includes(String(x))));
  assert.equal(info.entries[0].maps[1].linear[0][0], 0.5);
  // … and so does a page.
  const other = await shown(link);
  assert.deepEqual(await current(other), now);
  assert.equal(await other.value("barycage.entry.maps[1][0]"), 0.5);
  assert.match(await other.value("barycage.entry.text.begin"), /^maple \{ ; Maple$/);
  assert.equal(await other.value("document.querySelector('#palettes [aria-checked=true]').title"), "Glacier");
  assert.deepEqual(await other.complaints(), []);
});

test("where the clipboard is refused, the link can be copied by hand", async () => {
  const browser = await shown(maple);
  await onClipboard(browser, "async () => { throw new Error('refused'); }");
  await press(browser, "copy-link");
  await browser.until("!document.getElementById('link').hidden");
  assert.match(await browser.value("document.getElementById('link').value"), /#[\w-]+$/);
  assert.equal(await browser.value("document.activeElement.id"), "link");
  await browser.value("document.getElementById('link').scrollIntoView({ block: 'center' })");
  await keep(browser, "link-by-hand");
});

test("a link that is cut off, damaged, too large or of another kind says so in a sentence", async () => {
  const whole = inBase64(deflateRawSync(triangle));
  const zeros = deflateRawSync(Buffer.alloc(300_000_000), { level: 9 });
  const wrong = [[maple, whole.slice(0, 60), /cut off at its end/], [maple, whole + "AAAA", /damaged/], [maple, "%3Cb%3E", /damaged/],
    [maple, inBase64(Buffer.alloc(40, 255)), /damaged/], [maple, inBase64(deflateRawSync("no entry")), /damaged/],
    [maple, inBase64(deflateRawSync("a {\n 1 2 three\n}")), /damaged/], [maple, inBase64(zeros), /more than 1 MB/],
    [maple, inBase64(deflateRawSync(readFileSync(join(source, "ifs_library/space_sponges.ifs")))), /cannot draw|damaged/],
    [maple, inBase64(deflateRawSync("a (3D) {\n .5 0 0 0 .5 0 0 0 .5 0 0 0\n .5 0 0 0 .5 0 0 0 .5 1 0 0\n}")), /cannot draw/]];
  const browser = await shown(maple);
  for (const [path, data, sentence] of wrong) {
    await visit(browser, `file://${path}#${data}`);
    assert.match(await notice(browser), sentence);
    assert.equal(await heading(browser), "maple");
    if (sentence.source.includes("cut off")) await keep(browser, "link-cut");
    assert.deepEqual(await browser.complaints(), []);
  }
});

test("wherever a link is cut off, the page shows its own entry and says so", async () => {
  const browser = await shown(maple);
  const whole = inBase64(deflateRawSync(triangle));
  for (let size = 4; size < whole.length; size += 7) {
    await visit(browser, `file://${maple}#${whole.slice(0, size)}`);
    assert.match(await notice(browser), /cut off/, `after ${size} characters`);
  }
});

test("names in links are text", async () => {
  const name = "<img src=x onerror=window.pwned=1>";
  const browser = await shown(address(maple, triangle.replace("triangle", name)));
  await rested(browser);
  assert.equal(await heading(browser), name);
  assert.equal(await browser.value("window.pwned ?? null"), null);
  assert.deepEqual(await browser.complaints(), []);
});

test("another link in the same window, typed or pasted, is shown", async () => {
  const browser = await shown(maple);
  const before = await pixels(browser);
  const until = async (name) => {
    await browser.until(`window.barycage && document.querySelector('h1').textContent === '${name}'`);
    await rested(browser);
  };
  await browser.value(`(() => { location.hash = "${inBase64(deflateRawSync(triangle))}"; })()`);
  await until("triangle");
  assert.notEqual(await pixels(browser), before);
  const other = inBase64(deflateRawSync(triangle.replace("triangle", "pasted"), { strategy: constants.Z_HUFFMAN_ONLY }));
  await browser.value(`(() => { const data = new DataTransfer(); data.setData("text/plain", " barycage:${other}\\n");
    document.body.dispatchEvent(new ClipboardEvent("paste", { clipboardData: data, bubbles: true })); })()`);
  await until("pasted");
});
