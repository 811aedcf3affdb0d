// SPDX-License-Identifier: MIT
// Draws the systems of tests/data/hash_systems.json with the engine of web pages and compares every line with
// tests/data/hashes.txt: node hashes.mjs ENGINE.wasm.gz
import { readFileSync } from "node:fs";
import { gunzipSync } from "node:zlib";
import { startedEngine } from "../../app/web/page/engine.js";

const data = new URL("../data/", import.meta.url);
const systems = JSON.parse(readFileSync(new URL("hash_systems.json", data), "utf8"));

/** @param {number} value */
function bitsOf(value) {
  const view = new DataView(new ArrayBuffer(8));
  view.setFloat64(0, value);
  return view.getBigUint64(0).toString(16).padStart(16, "0");
}

/** The lines of one picture, without the decimal digits of numbers.
 * @param {import("../../app/web/page/engine.js").Engine} engine */
export function linesOf(engine, entry, [width, height, samples]) {
  const { box, simplex } = engine.load(entry);
  const scale = Math.min((.9 * width) / (box[2] - box[0]), (.9 * height) / (box[3] - box[1]));
  engine.setCamera(width, height, entry.view ?? [(box[0] + box[2]) / 2, (box[1] + box[3]) / 2, scale]);
  const { rest, current } = entry.cage ?? { rest: simplex, current: simplex };
  engine.setCage(rest, current, true);
  engine.draw(samples, true, false);
  const lines = [`${entry.name} ${width}x${height} ${samples} samples hash ${engine.hash()}`,
    ...(box.length === 7 ? box.slice(0, 6) : box).map((x) => ` box ${bitsOf(x)}`), ...simplex.flat().map((x) => ` tri ${bitsOf(x)}`)];
  const flat = current.flat();
  flat[0] += .1;
  flat[2] += .7;
  flat[5] -= .4;
  engine.setCage(rest, current.map((p, i) => p.map((_, k) => flat[i * p.length + k])), true);
  engine.draw(samples, true, false);
  lines.push(` dragged hash ${engine.hash()}`);
  engine.setAppearance({ ...entry.appearance, brightness: 8, background: [13, 16, 23, 0], mapColours: [],
    stops: engine.palettes()[5].stops });
  engine.draw(samples, true, false);
  engine.draw(samples, false, false);
  return [...lines, ` refined transparent hash ${engine.hash()}`];
}

const bytes = readFileSync(process.argv[2]);
const engine = await startedEngine(bytes[0] === 0x1f ? gunzipSync(bytes) : bytes);
console.log(engine.versions());
/** Those of the list, without tops, which pages do not draw, and without what this engine does not know. */
const known = new Set(systems.filter(({ entry }) => engine.knows(entry)).map(({ entry }) => entry.name));
const list = readFileSync(new URL("hashes.txt", data), "utf8").split("\n");
let isKnown = false;
const expected = list.filter((line) => {
  if (!line.startsWith(" ")) isKnown = known.has(line.replace(/ \d+x\d+ .*/, ""));
  return isKnown;
}).map((line) => line.replace(/^ (box|tri) \S+/, " $1"));
const drawn = systems.filter(({ entry }) => known.has(entry.name))
  .flatMap(({ entry, pictures }) => pictures.flatMap((picture) => linesOf(engine, entry, picture)));
const different = drawn.filter((line, i) => line !== expected[i]);
for (const line of different) console.error(`${line}\n   instead of ${expected[drawn.indexOf(line)]}`);
console.log(`${drawn.length - different.length} of ${expected.length} lines agree`);
process.exit(different.length === 0 && drawn.length === expected.length && drawn.length > 200 ? 0 : 1);
