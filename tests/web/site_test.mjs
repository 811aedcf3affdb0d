// SPDX-License-Identifier: MIT
// The documentation as a site, as ./dev site builds it: no link leads nowhere, and figures are dragged. As page_test.mjs.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { appendFileSync, cpSync, existsSync, readFileSync, readdirSync, rmSync, statSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { Browser } from "./browser.mjs";
import { cli, corners, current, folder, keep, obstacles, open, pixels, rested, smallTargets, source } from "./pages.mjs";

const python = process.env.BARYCAGE_PYTHON ?? "/usr/bin/python3";
const phone = { width: 390, height: 844, ratio: 2, touch: true };

/** Builds the site of this tree. @returns {string} what the program says of it; empty: it is built */
function build(tree, site) {
  const { status, stdout, stderr } = spawnSync(python, [join(tree, "docs/site/build.py"), cli, site], { encoding: "utf8" });
  assert.equal(stdout, "");
  assert.equal(status === 0, stderr === "", stderr);
  return stderr;
}

const site = join(folder, "site");
assert.equal(build(source, site), "");
const pages = readdirSync(site, { recursive: true }).filter((name) => name.endsWith(".html"));
const addressOf = (name) => `file://${join(site, name)}`;

async function shown(name, options) {
  const browser = await Browser.start(options);
  open.push(browser);
  await browser.open(addressOf(name));
  return browser;
}

/** Looks at the figure of an entry from now on, once it is live. */
async function enter(browser, entry) {
  const figure = `document.querySelector('[data-entry="${entry}"]')`;
  await browser.send("POST", "/frame", { id: null });
  await browser.value(`${figure}.scrollIntoView({ block: "center", behavior: "instant" })`);
  await browser.until(`${figure}.classList.contains("live")`);
  const id = await browser.value(`[...document.querySelectorAll("iframe")].indexOf(${figure}.querySelector("iframe"))`);
  const place = await browser.value(`${figure}.querySelector("iframe").getBoundingClientRect().toJSON()`);
  await browser.send("POST", "/frame", { id });
  await browser.until("window.barycage");
  await rested(browser);
  return place;
}

test("every document has its page, and no link and no anchor leads nowhere", async () => {
  const documents = readdirSync(join(source, "docs"), { recursive: true }).filter((name) => name.endsWith(".md"));
  for (const name of documents) assert.ok(pages.includes(name === "README.md" ? "index.html" : name.replace(/md$/, "html")), name);
  const browser = await shown("index.html", phone);
  /** @type {Map<string, string[]>} */
  const ids = new Map(), links = [];
  for (const name of pages) {
    await browser.open(addressOf(name));
    ids.set(join(site, name), await browser.value("[...document.querySelectorAll('[id]')].map((e) => e.id)"));
    const led = await browser.value(`[...document.querySelectorAll("a, link, img, script")].map((e) => [e.localName, e.href ?? e.src])`);
    links.push(...led.filter(([kind, link]) => kind !== "a" || !link.startsWith("https://")).map(([, link]) => ({ name, link })));
    assert.deepEqual(await browser.value("[...document.images].filter((e) => !e.alt && !e.closest('.home')).map((e) => e.src)"), [], name);
    assert.ok((await browser.value("document.documentElement.scrollWidth - innerWidth")) <= 0, `${name} scrolls sideways`);
    assert.equal(await browser.value("document.querySelectorAll('h1').length"), 1, name);
  }
  for (const { name, link } of links) {
    const path = fileURLToPath(link.replace(/#.*/, "")), anchor = decodeURIComponent(link.match(/#(.+)/)?.[1] ?? "");
    assert.ok(path.startsWith(site) && statSync(path, { throwIfNoEntry: false })?.isFile(), `${name}: ${link}`);
    if (anchor) assert.ok(ids.get(path)?.includes(anchor), `${name}: ${link}`);
  }
  assert.ok(links.length > 1000);
  assert.ok(ids.get(join(site, "formats.html")).includes("fractint-collections-ifs-and-ifs-entries-of-par"));
  assert.ok(ids.get(join(site, "mathematics.html")).includes("when-does-a-system-have-an-attractor"));
  assert.deepEqual(await browser.complaints(), []);
});

test("what cannot be right in the documents ends the build, and is named", () => {
  const tree = join(folder, "tree");
  /** @param {Record<string, string>} added to the ends of files, which are made where they are not there */
  const change = (added) => {
    rmSync(tree, { recursive: true, force: true });
    for (const part of ["docs", "README.md", "resources/slurm", "resources/barycage.svg"])
      cpSync(join(source, part), join(tree, part), { recursive: true });
    for (const [name, text] of Object.entries(added)) appendFileSync(join(tree, name), text);
    return build(tree, join(folder, "other"));
  };
  const install = (text) => change({ "docs/install.md": text });
  assert.equal(install("\n## Twice\n\n## Twice\n\n[Here](#twice-1), [there](guide.md#on-the-canvas), <https://example.org/>\n"), "");
  assert.match(readFileSync(join(folder, "other/install.html"), "utf8"), /<h2 id="twice-1">.*href="#twice-1".*href="guide.html#on-the-canvas"/s);
  assert.match(install("\n[There](nowhere.md)\n"), /docs\/install.md: nowhere.md leads nowhere/);
  assert.match(install("\n[There](guide.md#nothing-of-the-kind)\n"), /docs\/install.md: guide.md#nothing-of-the-kind leads to no heading/);
  assert.match(install("\n[There](../../../../../../etc/passwd)\n"), /leads nowhere/);
  assert.match(install("\n![](images/window.png)\n"), /window.png has no words/);
  assert.match(install("\n![A window](images/windows.png)\n"), /images\/windows.png leads nowhere/);
  assert.match(install("\n<script>alert(1)</script>\n"), /HTML that is no comment/);
  assert.match(install("\nA <b>word</b>\n"), /HTML in a line/);
  assert.match(change({ "docs/alone.md": "# Alone\n" }), /docs\/alone.md: no document leads to it/);
  assert.match(change({ "docs/alone.md": "Alone\n", "docs/install.md": "\n[There](alone.md)\n" }), /docs\/alone.md: does not begin with its title/);
  assert.match(change({ "docs/figures.ifs": "\nunseen {\n  0.5 0 0 0.5 0 0 1\n}\n" }), /figures.ifs: no document shows unseen/);
});

test("corners are dragged in the guide, all figures of which share one engine, and nothing leaves the disk", async () => {
  const browser = await shown("guide.html", { traces: true });
  const still = "document.querySelector('[data-entry=\"maple_leaning\"] img')";
  assert.ok(await browser.value(`${still}.getBoundingClientRect().width === 672 && ${still}.alt.length > 10`));
  await enter(browser, "maple_leaning");
  const other = await pixels(browser);
  const { x, y, width } = await enter(browser, "maple");
  assert.equal(width, 672);
  assert.equal(await browser.value("document.getElementById('name').textContent"), "The maple, an attractor of four maps");
  const at = await corners(browser), before = await pixels(browser);
  await browser.send("POST", "/frame", { id: null });
  await keep(browser, "site-guide");
  assert.equal(await browser.value("barycageWorkers.size"), 1);
  assert.equal(await browser.value("document.querySelectorAll('figure.live').length >= 2"), true);
  assert.equal(await browser.value(`${still}.getBoundingClientRect().height`), 0);
  await browser.drag([0, 20, 40].map((way) => [x + at[2][0] + way, y + at[2][1] - way / 2]));
  await enter(browser, "maple");
  const moved = await corners(browser);
  assert.ok(Math.hypot(moved[2][0] - at[2][0] - 40, moved[2][1] - at[2][1] + 20) < 2, "the corner is under the pointer");
  assert.notEqual(await pixels(browser), before);
  await enter(browser, "maple_leaning");
  assert.equal(await pixels(browser), other, "the other figure is as it was");
  assert.notDeepEqual(await current(browser), await browser.value("barycage.figure.rest"));
  // The list of sections follows the reader, and every other figure is live where it comes near.
  await browser.send("POST", "/frame", { id: null });
  await browser.value("document.getElementById('lessons').scrollIntoView()");
  await browser.until("document.querySelector('.contents .read').textContent === 'Lessons'");
  const entries = await browser.value("[...document.querySelectorAll('[data-entry]')].map((e) => e.dataset.entry)");
  assert.ok(entries.length >= 8);
  for (const entry of entries) {
    await enter(browser, entry);
    assert.equal(await browser.value("barycage.entry.name"), entry);
    assert.equal(await browser.value("barycage.figure.holdsMaps"), entry.endsWith("_maps"));
    assert.notEqual(await browser.value("barycage.figure.extent"), null, entry);
  }
  await browser.send("POST", "/frame", { id: null });
  assert.equal(await browser.value("barycageWorkers.size"), 1);
  const requests = await browser.requests();
  assert.ok(requests.some((address) => address.endsWith("/figures.js")));
  assert.deepEqual(requests.filter((address) => !/^(data|blob|about):/.test(address) && !address.startsWith(`file://${site}/`)), []);
  assert.deepEqual(await browser.complaints(), []);
});

/** Asserts that nothing keeps anybody out. What axe itself loads is refused by the page, and is no complaint of it. */
async function assertOpen(browser, name) {
  assert.deepEqual(await browser.complaints(), [], name);
  assert.deepEqual(await obstacles(browser), [], name);
  await browser.complaints();
}

test("on a telephone and on a desk, light and dark, for everybody", async () => {
  for (const [look, options] of Object.entries({ phone, "phone-dark": { ...phone, dark: true }, desktop: {}, "desktop-dark": { dark: true } })) {
    const browser = await shown("index.html", options);
    await enter(browser, "maple");
    await assertOpen(browser, `${look}, figure`);
    if (options.touch) assert.deepEqual(await smallTargets(browser), [], look);
    await browser.send("POST", "/frame", { id: null });
    await keep(browser, `site-${look}`);
    for (const name of ["index.html", "guide.html", "mathematics.html", "formats.html", "decisions/index.html"]) {
      await browser.open(addressOf(name));
      await assertOpen(browser, `${look}, ${name}`);
    }
    if (options.touch) {
      await browser.open(addressOf("guide.html"));
      await browser.value("document.querySelector('summary').click()");
      await browser.until("document.querySelector('.soon')");
      await assertOpen(browser, `${look}, contents`);
      await browser.value("[...document.querySelectorAll('header nav a')].find((a) => a.hash === '#lessons').click()");
      await browser.until("!document.querySelector('details').open && location.hash === '#lessons'");
      // The figures above become live meanwhile, and what is read stays in place.
      await browser.until("document.querySelector('.live') && Math.abs(document.getElementById('lessons').getBoundingClientRect().top - 72) < 2");
    }
    assert.deepEqual(await browser.complaints(), []);
  }
});

test("without scripts, and on paper, the pictures are there", async () => {
  const browser = await shown("glossary.html");
  const look = (cmd, params) => browser.send("POST", "/goog/cdp/execute", { cmd, params });
  const stills = "[...document.querySelectorAll('[data-entry] img')]";
  await look("Emulation.setScriptExecutionDisabled", { value: true });
  await browser.open(addressOf("guide.html"));
  await browser.until(`${stills}[0].naturalWidth === 672`);
  assert.ok(await browser.value(`${stills}.every((e) => e.getBoundingClientRect().height === 504)`));
  assert.equal(await browser.value("document.querySelectorAll('iframe').length"), 0);
  assert.ok(await browser.value("document.querySelector('[data-entry] figcaption').getBoundingClientRect().height > 0"));
  await keep(browser, "site-plain");
  await look("Emulation.setScriptExecutionDisabled", { value: false });
  await browser.open(addressOf("guide.html"));
  await enter(browser, "maple");
  await browser.send("POST", "/frame", { id: null });
  await look("Emulation.setEmulatedMedia", { media: "print" });
  assert.deepEqual(await browser.value("['nav', 'header', 'iframe'].filter((e) => document.querySelector(e).getBoundingClientRect().height)"), []);
  assert.ok(await browser.value(`${stills}[0].getBoundingClientRect().height > 100`));
});

test("figures show maps of the collection", () => {
  const library = join(source, "ifs_library"), row = /^ *(-?[\d.]+(?: -?[\d.]+)*) -?[\d.]+$/gm; // without its weight
  const mapsOf = (path) => [...readFileSync(path, "utf8").matchAll(row)].map(([, map]) => map);
  const known = new Set(readdirSync(library).filter((name) => name.endsWith(".ifs")).flatMap((name) => mapsOf(join(library, name))));
  const maps = mapsOf(join(source, "docs/figures.ifs"));
  assert.equal(maps.length, 4 + 4 + 8 + 4 + 4 + 3 + 2 + 4 + 2);
  assert.deepEqual(maps.filter((map) => !known.has(map)), []);
});

test("the site is small, and holds nothing that no page shows", () => {
  const files = readdirSync(site, { recursive: true }).filter((name) => statSync(join(site, name)).isFile());
  const text = pages.map((name) => readFileSync(join(site, name), "utf8")).join();
  for (const name of files.filter((name) => name.startsWith("images/"))) assert.ok(text.includes(name), name);
  assert.ok(statSync(join(site, "figures.js")).size < 700e3);
  assert.ok(files.reduce((sum, name) => sum + statSync(join(site, name)).size, 0) < 10e6);
  for (const name of readdirSync(join(source, "docs/site"))) assert.doesNotMatch(readFileSync(join(source, "docs/site", name), "utf8"), /innerHTML|https?:\/\//);
  assert.ok(!existsSync(join(site, "figures.ifs")));
});
