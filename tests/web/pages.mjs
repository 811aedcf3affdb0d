// SPDX-License-Identifier: MIT
// What the tests of pages share: pages that barycage-cli writes, browsers that show them, and what is seen there.
// Pictures of it go to BARYCAGE_PICTURES, if it is given.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { afterEach } from "node:test";
import { Browser } from "./browser.mjs";

export const cli = process.env.BARYCAGE_CLI;
const pictures = process.env.BARYCAGE_PICTURES;
export const folder = mkdtempSync(join(tmpdir(), "barycage-pages-"));
export const source = new URL("../../", import.meta.url).pathname;
export const paper = join(source, "ifs_library/paper.ifs");
export const shift = "\uE008", control = "\uE009", alt = "\uE00A", tab = "\uE004", right = "\uE014", escape = "\uE00C";

let written = 0;
/** @param {string} file @param {...string} options @returns {string} the path of the page */
export function page(file, ...options) {
  const path = join(folder, `${++written}.html`);
  execFileSync(cli, ["page", file, "-o", path, ...options]);
  return path;
}
/** @param {string} text */
export function collection(text) {
  const path = join(folder, `${++written}.ifs`);
  writeFileSync(path, text);
  return path;
}
/** @type {Browser[]} */
export const open = [];
afterEach(() => Promise.all(open.splice(0).map((browser) => browser.end()))); // what plays takes time from the next
export async function shown(path, options = {}) {
  const browser = await Browser.start(options);
  open.push(browser);
  await browser.open(path.includes("://") ? path : `file://${path}`);
  await browser.until("window.barycage && document.body.dataset.state === 'live'");
  return browser;
}
const isRefined = "barycage.drawing.total >= barycage.drawing.enough || barycage.drawing.total === 0 && !barycage.drawing.isBusy";
export async function rested(browser) {
  // Nor is an entry under way to the engine.
  await browser.until("barycage.drawing.waiting.length === 0 && !barycage.drawing.isBusy && !barycage.drawing.isStale");
  await browser.until(isRefined);
}
export async function keep(browser, name) {
  if (pictures) writeFileSync(join(pictures, `${name}.png`), await browser.picture());
}
export const corners = (browser) => browser.value(`(() => { const r = document.getElementById("stage").getBoundingClientRect();
  return barycage.figure.current.map((p) => barycage.figure.pixel(p)).map(([x, y]) => [x + r.left, y + r.top]); })()`);
export const current = (browser) => browser.value("barycage.figure.current");
// A number that other pixels change.
export const pixels = (browser) => browser.value(`(() => { const c = document.getElementById("canvas");
  const copy = new OffscreenCanvas(c.width, c.height).getContext("2d", { willReadFrequently: true });
  copy.drawImage(c, 0, 0);
  const d = copy.getImageData(0, 0, c.width, c.height).data; let sum = 0;
  for (let i = 0; i < d.length; i += 4) sum = (sum * 31 + d[i] + 256 * d[i + 1]) % 4294967291; return sum; })()`);
/** Of axe, which finds what keeps people out. @returns {Promise<string[]>} */
export async function obstacles(browser) {
  const axe = readFileSync(join(process.env.BARYCAGE_NODE_MODULES, "axe-core/axe.min.js"), "utf8");
  await browser.send("POST", "/execute/sync", { script: `${axe}; window.axe = axe;`, args: [] });
  return browser.send("POST", "/execute/async", { args: [], script: `const done = arguments[0];
    axe.run().then((r) => done(r.violations.map((v) => v.id + ": " + v.nodes.map((n) => n.target).join(" "))));` });
}
/** What is too small for fingers. */
export const smallTargets = (browser) => browser.value(`[...document.querySelectorAll("button, .corner .reach, input")].filter((e) => {
  const r = e.getBoundingClientRect(); return r.width > 0 && Math.min(r.width, r.height) < 40; }).map((e) => e.id || e.className)`);
/** A click of the mouse. @param {string} id */
export async function press(browser, id) {
  const { x, y } = await browser.value(`(() => { const button = document.getElementById("${id}");
    button.scrollIntoView({ block: "center" });
    const r = button.getBoundingClientRect();
    return { x: r.left + r.width / 2, y: r.top + r.height / 2 }; })()`);
  await browser.drag([[x, y]]);
}
