// SPDX-License-Identifier: MIT
// Draws in a thread of its own, so that the page never waits for a picture.

import { startedEngine } from "./engine.js";

/** @typedef {import("./engine.js").Engine} Engine */
/** @typedef {import("./engine.js").Entry} Entry */
/** @typedef {import("./engine.js").Appearance} Appearance */
/** @typedef {import("./geometry.js").Point} Point */
/** A map that is dragged: its row as it is shown, and where the hand is.
 * @typedef {{map: number, from: (number | null)[], to: (number | null)[]}} Change */
/** What the page asks for; cage and camera are those of the moment.
 * @typedef {{kind: "start", wasm: string} | {kind: "load", entry: Entry, change?: Change} | {kind: "look", appearance: Appearance} |
 *   {kind: "hash"} | {kind: "thumbnail", entry: Entry, width: number, height: number, samples: number} | {kind: "draw", id: number, width: number, height: number, view: number[], rest: Point[], current: Point[],
 *    bends: boolean, samples: number, begin: boolean, keepExposure: boolean}} Request
 */

/** The bytes of Base64 that is compressed with gzip.
 * @param {string} base64 */
async function unpacked(base64) {
  const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).arrayBuffer();
}

/** A small picture of all of an entry, as it is in the collection.
 * @param {Engine} drawing @param {Entry} entry @param {number} width @param {number} height @param {number} samples */
function drawSmall(drawing, entry, width, height, samples) {
  const extent = drawing.load(entry);
  const box = entry.box ?? extent?.box ?? [-1, -1, 1, 1];
  let view = entry.view ?? [];
  if (entry.dimension === 2) {
    const [left, bottom, right, top] = box;
    const scale = 0.9 * Math.min(width / Math.max(right - left, 1e-9), height / Math.max(top - bottom, 1e-9));
    view = [(left + right) / 2, (bottom + top) / 2, scale];
  } else if (extent && !entry.cage) { // without the corners around it: no side is longer than the diagonal of the box
    const middle = [0, 1, 2].map((i) => (box[i] + box[i + 3]) / 2), sides = [0, 1, 2].map((i) => box[i + 3] - box[i]);
    view = [...middle, view[3], view[4], Math.max(Math.hypot(...sides), 1e-9), view[6]];
  }
  drawing.setCamera(width, height, view);
  const { rest, current, bends } = entry.cage ?? { rest: [], current: [], bends: true };
  drawing.setCage(rest, current, bends);
  drawing.draw(samples, true, false);
}

const halvings = 4; // of a way that leads to where there is no attractor: near its end, every look takes long

/** Loads an entry with one map changed, as far as leaves an attractor; all the way where there is none to keep.
 * @param {Engine} loading @param {Entry} entry @param {Change} change */
function loadChanged(loading, entry, { map, from, to }) {
  const at = (/** @type {number} */ share) => {
    const row = to.map((x, i) => (x === null || share === 1 ? x : Number(from[i]) + share * (x - Number(from[i]))));
    return { row, extent: loading.load({ ...entry, maps: entry.maps.map((other, i) => (i === map ? row : other)) }) };
  };
  const whole = at(1);
  if (whole.extent || !at(0).extent) return { ...(whole.extent ? whole : at(1)), isStopped: false };
  let share = 0;
  for (let step = 0.5, i = 0; i < halvings; step /= 2, ++i) if (at(share + step).extent) share += step;
  return { ...at(share), isStopped: true };
}

/** @type {Engine | null} */
let engine = null;

/** @param {Request} request
 * @returns {Promise<[object, Transferable[]]>} the answer, and what it hands over */
async function answer(request) {
  if (request.kind === "start") {
    engine = await startedEngine(await unpacked(request.wasm));
    return [{ kind: "started", palettes: engine.palettes(), versions: engine.versions(),
      knowsSpace: engine.knows({ name: "", dimension: 3, maps: [] }) }, []];
  }
  if (!engine) throw new Error("the engine has not started");
  if (request.kind === "load") {
    const { entry, change } = request;
    return [{ kind: "loaded", ...(change ? loadChanged(engine, entry, change) : { extent: engine.load(entry) }) }, []];
  }
  if (request.kind === "look") {
    engine.setAppearance(request.appearance);
    return [{ kind: "looked" }, []];
  }
  if (request.kind === "thumbnail") {
    const { entry, width, height } = request;
    drawSmall(engine, entry, width, height, request.samples);
    const pixels = engine.pixels();
    return [{ kind: "picture", width, height, pixels }, [pixels.buffer]];
  }
  if (request.kind === "hash") return [{ kind: "hashed", hash: engine.hash() }, []];
  const { id, width, height, begin } = request;
  const began = performance.now();
  if (begin) {
    engine.setCamera(width, height, request.view);
    engine.setCage(request.rest, request.current, request.bends);
  }
  const samples = engine.draw(request.samples, begin, request.keepExposure);
  const pixels = engine.pixels();
  const milliseconds = performance.now() - began;
  return [{ kind: "picture", id, width, height, pixels, samples, milliseconds }, [pixels.buffer]];
}

/** @type {Promise<unknown>} requests are answered one after the other */
let last = Promise.resolve();
self.onmessage = (/** @type {MessageEvent<Request>} */ event) => {
  last = last.then(() => answer(event.data)).then(
    ([message, handed]) => self.postMessage(message, { transfer: handed }),
    (error) => self.postMessage({ kind: "failed", message: String(error) }));
};
