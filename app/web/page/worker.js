// SPDX-License-Identifier: MIT
// Draws in a thread of its own, so that the page never waits for a picture.

import { bytesOf, Engine, startedEngine } from "./engine.js";

/** The bytes of text in base 85 that is compressed with gzip. @param {string} text */
async function unpacked(text) {
  const stream = new Response(bytesOf(text)).body?.pipeThrough(new DecompressionStream("gzip")); // WebKitGTK cannot read a Blob here
  return new Response(stream).arrayBuffer();
}

/** A small picture of all of an entry, as it is in the collection.
 * @param {Engine} drawing @param {Question & {kind: "thumbnail"}} request */
function drawSmall(drawing, { entry, width, height, samples, frame = -1 }) {
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
  if (!entry.cage && !drawing.motion) drawing.setCage([], [], true);
  drawing.show(frame, true);
  drawing.draw(samples, true, false);
}

/** What the picture reaches at evenly spaced frames: 19, for a motion that repeats itself does so at other ones, or fewer where
 * maps are many. @param {Engine} engine @returns {Extent["reach"]} */
function reachOf(engine) {
  const { motion, maps } = engine, count = Math.max(5, Math.min(19, Math.round(300 / maps)));
  if (!motion) return undefined;
  const reach = Array.from({ length: count }, (_, i) => {
    engine.show(Math.round((motion.length * i) / (count - 1)), false);
    return { box: engine.reach() ?? [], corners: motion.movesCage || motion.turns ? engine.shown().corners : [] };
  });
  return reach.filter(({ box }) => box.length > 0);
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
    if (change) return loadChanged(engine, entry, change);
    const extent = engine.load(entry);
    return { extent: extent && { ...extent, reach: reachOf(engine) }, motion: engine.motion };
  }
  if (request.kind === "look") {
    engine.setAppearance(request.appearance);
    return {};
  }
  if (request.kind === "still") {
    engine.show(request.frame, false);
    return { row: engine.still(request.map, request.row) };
  }
  const { width, height } = request, began = performance.now();
  let { samples } = request;
  if (request.kind === "thumbnail") drawSmall(engine, request);
  else {
    if (request.begin) {
      engine.setCamera(width, height, request.view);
      engine.setCage(request.rest, request.current, request.bends);
      engine.show(request.frame, request.follows);
    }
    samples = engine.draw(samples, request.begin, request.keepExposure);
  }
  const shown = engine.motion ? engine.shown() : undefined;
  return { width, height, pixels: engine.pixels(), shown, samples, milliseconds: performance.now() - began };
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
