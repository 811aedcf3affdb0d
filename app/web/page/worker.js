// SPDX-License-Identifier: MIT
// Draws in a thread of its own, so that the page never waits for a picture.

import { Engine, startedEngine } from "./engine.js";

/** The bytes of Base64 that is compressed with gzip.
 * @param {string} base64 */
async function unpacked(base64) {
  const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  const stream = new Response(bytes).body?.pipeThrough(new DecompressionStream("gzip")); // WebKitGTK cannot read a Blob here
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

/** @param {Engine} engine @param {Question} request @returns {Answer} */
function answerTo(engine, request) {
  if (request.kind === "start")
    return { palettes: engine.palettes(), versions: engine.versions(), knowsSpace: engine.knows({ name: "", dimension: 3, maps: [] }) };
  if (request.kind === "load") {
    const { entry, change } = request;
    return change ? loadChanged(engine, entry, change) : { extent: engine.load(entry) };
  }
  if (request.kind === "look") {
    engine.setAppearance(request.appearance);
    return {};
  }
  const { width, height } = request, began = performance.now();
  let { samples } = request;
  if (request.kind === "thumbnail") drawSmall(engine, request.entry, width, height, samples);
  else {
    if (request.begin) {
      engine.setCamera(width, height, request.view);
      engine.setCage(request.rest, request.current, request.bends);
    }
    samples = engine.draw(samples, request.begin, request.keepExposure);
  }
  return { width, height, pixels: engine.pixels(), samples, milliseconds: performance.now() - began };
}

/** @type {Promise<Engine> | undefined} whose WebAssembly the engines of all figures share */
let started;

/** Answers a figure, one request after the other. @param {MessagePort | Window & typeof globalThis} figure */
function serve(figure) {
  /** @type {Engine | undefined} */
  let engine;
  let last = Promise.resolve();
  figure.onmessage = (/** @type {MessageEvent<Question>} */ { data, ports: [other] }) => {
    if (other) serve(other);
    else last = last.then(async () => {
      if (data.kind === "start") engine = new Engine((await (started ??= unpacked(data.wasm).then(startedEngine))).calls);
      if (!engine) throw new Error("the engine has not started");
      const answer = answerTo(engine, data);
      figure.postMessage(answer, { transfer: answer.pixels ? [answer.pixels.buffer] : [] });
    }).catch((error) => figure.postMessage({ failure: String(error) }));
  };
}

serve(self);
