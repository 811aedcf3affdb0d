// SPDX-License-Identifier: MIT
// The frames of a page are those of barycage-cli render --frame, pixel by pixel: the engine that the page carries, in node,
// with the entry that the page carries. As page_test.mjs.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { gunzipSync } from "node:zlib";
import { bytesOf, startedEngine } from "../../app/web/page/engine.js";
import { cli, collection, folder, page, source } from "./pages.mjs";
import { decoded, hashOf } from "./png.mjs";

const motion = join(source, "ifs_library/motion.ifs");
const width = 320, height = 240, samples = 300_000;

/** The entry and the engine of a page. @param {string} path */
async function contentOf(path) {
  const text = readFileSync(path, "utf8"), part = (id) => text.match(new RegExp(`id="${id}">([^<]*)<`))[1];
  const engine = await startedEngine(gunzipSync(bytesOf(part("engine"))));
  return { engine, entry: JSON.parse(part("content")).entry };
}

/** The hashes of some frames: of the engine, and of the program.
 * @param {string} file @param {string} name @param {number[]} frames @param {number[]} view of the plane: centre and height */
async function framesOf(file, name, frames, view) {
  const { engine, entry } = await contentOf(page(file, "--entry", name));
  const extent = engine.load(entry);
  assert.ok(extent && engine.motion, name);
  const at = view ? [view[0], view[1], height / view[2]] : [0, 0, 1];
  const picture = join(folder, "frame.png");
  return frames.map((frame) => {
    engine.setCamera(width, height, entry.dimension === 3 ? entry.view : at);
    engine.show(frame, !view);
    engine.draw(samples, true, false);
    const seen = entry.dimension === 3 ? ["--orbit", "30,20", "--view",
      [...entry.view.slice(0, 3), entry.view[5]].join()] : view ? ["--view", view.join()] : [];
    execFileSync(cli, ["render", file, "--entry", name, "--frame", String(frame), "--size", `${width}x${height}`,
      ...(entry.dimension === 3 ? ["--supersample", "1"] : ["--points", String(samples)]), ...seen, "-o", picture]);
    return [engine.hash(), hashOf(decoded(readFileSync(picture)).pixels)];
  });
}

/** Whether all are equal, and no two frames are. @param {string[][]} frames @param {string} name */
function areTheSame(frames, name) {
  for (const [shown, rendered] of frames) assert.equal(shown, rendered, name);
  assert.equal(new Set(frames.map(([shown]) => shown)).size, frames.length, `${name} moves`);
}

test("motions: wind, turns, breath and palettes", async () => {
  for (const [name, view] of [["maple_wind", [0, 1, 9]], ["tree_storm", [0, 1, 4]], ["sea_fan_swell", [0, 1, 4]],
    ["bracts_breathing", [0, 0, 3]], ["flake_turning", [0, 0, 3]]])
    areTheSame(await framesOf(motion, name, [0, 7, 31], view), name);
});

test("keys of maps, there and back", async () => {
  for (const [name, view] of [["fern_unfolding", [0, 5, 12]], ["dragon_folding", [0.4, 0, 2]], ["koch_growing", [0.5, 0.2, 1.2]],
    ["maple_to_fern", [0, 2, 14]]])
    areTheSame(await framesOf(motion, name, [0, 13, 50], view), name);
  const [[there], [back]] = await framesOf(motion, "dragon_folding", [30, 2 * 96 - 30], [0.4, 0, 2]);
  assert.equal(there, back);
});

test("keys of the camera, of the cage and of the look", async () => {
  areTheSame(await framesOf(motion, "endless_zoom", [0, 20, 41]), "endless_zoom");
  areTheSame(await framesOf(motion, "weave_walk", [3, 40]), "weave_walk");
  const lines = ["animation 40 25/2 off", "track cage", "key 0 smooth", "value 0 0 1 0 0 1", "key 20 smooth", "value 0 0 1.4 .2 .1 1",
    "key 40 linear", "value 0 0 1 0 -.3 1.2", "track look", "key 0 linear", "look palette Glacier", "look brightness 20",
    "key 40 linear", "look palette Fern", "look brightness 60"];
  const cage = ["rest 0 0", "rest 1 0", "rest 0 1", "current 0 0", "current 1 0", "current 0 1"];
  const file = collection(`keyed {\n${[...cage, ...lines].map((line) => `  ; barycage: ${line}\n`).join("")}  .5 0 0 .5 0 0 .33\n`
    + "  .5 0 0 .5 .5 0 .33\n  .5 .1 0 .4 0 .5 .34\n}\n");
  areTheSame(await framesOf(file, "keyed", [0, 9, 20, 33, 40], [0.5, 0.5, 2]), "keyed");
});

test("the whole plane that turns, with the cage that an entry without one has", async () => {
  const file = collection("round {\n  ; barycage: animation 60 24/1 cycle\n  ; barycage: motion orbit\n  ; barycage: count -1\n"
    + "  ; barycage: pivot .3 .2\n  .5 0 0 .5 0 0 .33\n  .5 0 0 .5 .5 0 .33\n  .5 .1 0 .4 0 .5 .34\n}\n");
  areTheSame(await framesOf(file, "round", [0, 11, 45], [0.3, 0.2, 3]), "round");
});

test("a solid on a turntable", async () => {
  areTheSame(await framesOf(motion, "menger_turning", [0, 10, 33]), "menger_turning");
});
