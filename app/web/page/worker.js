// SPDX-License-Identifier: MIT
// Draws in a thread of its own, so that the page never waits for a picture.

import { startedEngine } from "./engine.js";

/** @typedef {import("./engine.js").Engine} Engine */
/** @typedef {import("./engine.js").Entry} Entry */
/** @typedef {import("./engine.js").Appearance} Appearance */
/** @typedef {import("./geometry.js").Point} Point */
/** What the page asks for; cage and camera are those of the moment.
 * @typedef {{kind: "start", wasm: string} | {kind: "load", entry: Entry} | {kind: "look", appearance: Appearance} |
 *   {kind: "hash"} | {kind: "draw", id: number, width: number, height: number, view: number[], rest: Point[], current: Point[],
 *    bends: boolean, samples: number, begin: boolean, keepExposure: boolean}} Request
 */

/** The bytes of Base64 that is compressed with gzip.
 * @param {string} base64 */
async function unpacked(base64) {
  const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).arrayBuffer();
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
  if (request.kind === "load") return [{ kind: "loaded", extent: engine.load(request.entry) }, []];
  if (request.kind === "look") {
    engine.setAppearance(request.appearance);
    return [{ kind: "looked" }, []];
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
