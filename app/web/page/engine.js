// SPDX-License-Identifier: MIT
// The engine of app/web/engine.h.

const standardPlain = [235, 235, 235, 255];
const standardBackground = [13, 16, 23, 255];

/** The bytes of a text, as notation::inBase85() writes them. @param {string} text */
export function bytesOf(text) {
  const digits = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz!#$%()*+,-./:;=?@[]^_|~";
  const values = new Uint8Array(128), bytes = new Uint8Array(4 * Math.ceil(text.length / 5)), view = new DataView(bytes.buffer);
  for (let i = 0; i < 85; ++i) values[digits.charCodeAt(i)] = i;
  for (let at = 0; at < text.length; at += 5) {
    let number = 0;
    for (let i = at; i < at + 5; ++i) number = 85 * number + (i < text.length ? values[text.charCodeAt(i)] : 84);
    view.setUint32((4 * at) / 5, number);
  }
  return bytes.slice(0, Math.floor((4 * text.length) / 5));
}

/** Starts an engine from its WebAssembly. @param {BufferSource} bytes */
export async function startedEngine(bytes) {
  let running = /** @type {Record<string, any>} */ ({});
  // The C library asks for little: a clock. There are no environment and no files.
  const system = {
    /** @param {number} _id @param {bigint} _precision @param {number} time */
    clock_time_get(_id, _precision, time) {
      new DataView(running.memory.buffer).setBigUint64(time, BigInt(Math.round(performance.now() * 1e6)), true);
      return 0;
    },
    environ_sizes_get: () => 8, // there is none
    environ_get: () => 8,
    fd_close: () => 0,
    fd_seek: () => 70,
    fd_write: () => 8,
  };
  const module = await WebAssembly.instantiate(bytes, {
    env: { emscripten_notify_memory_growth() {} },
    wasi_snapshot_preview1: system,
  });
  running = module.instance.exports;
  running._initialize?.();
  return new Engine(running);
}

/** One engine: an entry, how it is looked at, and its picture. */
export class Engine {
  /** @param {Record<string, any>} exports */
  constructor(exports) {
    this.calls = exports;
    this.self = exports.barycage_new();
    this.size = { width: 0, height: 0 };
    this.appearance = /** @type {Appearance} */ ({});
    this.motion = /** @type {Motion | null} */ (null); // of the entry that was loaded
    this.dimension = 2;
    this.maps = this.corners = 0;
    this.room = 0;
    this.buffer = 0;
  }

  /** "barycage web engine: interface I, pixels P, hashes H" */
  versions() {
    return this.text(this.calls.barycage_versions());
  }

  /** Whether the engine can draw such entries. @param {Entry} entry */
  knows(entry) {
    return this.calls.barycage_load(this.self, entry.dimension, this.numbers([]), 0) !== 0;
  }

  /** @param {Entry} entry @returns {Extent | null} null where no attractor is certain */
  load(entry) {
    const d = entry.dimension, length = d * (d + 1) + 1;
    const rows = entry.maps.flatMap((map) => Array.from({ length }, (_, i) => map[i] ?? NaN));
    this.calls.barycage_load(this.self, d, this.numbers(rows), entry.maps.length);
    Object.assign(this, { dimension: d, maps: entry.maps.length, corners: 0 });
    if (entry.links) this.calls.barycage_links(this.self, this.numbers(entry.links.flat()));
    if (entry.symmetry) {
      const { group, order, angle, centre, frame } = entry.symmetry;
      const place = this.numbers([...centre, ...frame, ...Array(d).fill(0)]);
      this.calls.barycage_symmetry(this.self, group, order, angle, place);
    }
    for (const branch of entry.branches ?? []) {
      const change = this.numbers(branch.change);
      const word = change + 8 * branch.change.length;
      new Int32Array(this.calls.memory.buffer, word, branch.word.length).set(branch.word);
      this.calls.barycage_branch(this.self, word, branch.word.length, change);
    }
    this.setAppearance(entry.appearance ?? {});
    /** @type {Solid} */
    const { look, colour, light, fog, clip } = entry.solid ?? { look: 0, colour: 0, light: [-40, 40], fog: 0 };
    this.calls.barycage_light(this.self, look, colour, this.numbers([...light, fog]));
    if (clip) {
      const [x, y, z, lowest, highest] = clip;
      this.calls.barycage_clip(this.self, this.numbers([x, y, z, lowest ?? -Infinity, highest ?? Infinity]));
    }
    const extent = this.extent();
    const { rest, current, bends } = entry.cage ?? { rest: extent?.simplex ?? [], current: extent?.simplex ?? [], bends: true };
    this.setCage(rest, current, bends);
    this.motion = this.readMotion(entry);
    return extent;
  }

  /** @returns {Extent | null} */
  extent() {
    if (!this.calls.barycage_settle(this.self)) return null;
    const d = this.dimension, boxLength = 2 * d + 1, corners = d * (d + 1);
    const box = this.numbers(Array(boxLength + corners).fill(0));
    this.calls.barycage_extent(this.self, box, box + 8 * boxLength);
    const all = this.read(box, boxLength + corners);
    return { box: all.slice(0, boxLength), simplex: points(all.slice(boxLength), d) };
  }

  /** What the lines of the entry say of its animation. @param {Entry} entry @returns {Motion | null} */
  readMotion({ text, cage }) {
    const lines = text?.lines.join("\n") ?? "";
    if (!lines.includes("barycage: animation")) return null;
    const bytes = new TextEncoder().encode(`${lines}\0`), at = this.calls.malloc(bytes.length);
    new Uint8Array(this.calls.memory.buffer, at).set(bytes);
    const to = this.numbers(Array(9 + this.maps).fill(0));
    const isKnown = this.calls.barycage_animation(this.self, at, cage ? 1 : 0, to);
    this.calls.free(at);
    if (!isKnown) return null;
    const [frames, seconds, length, last, loop, ...flags] = this.read(to, 9 + this.maps);
    const [movesCage, movesCamera, movesLook, turns, ...movesMap] = flags.map(Boolean);
    return { rate: frames / seconds, length, frames: loop === 0 ? last + 1 : last, isEndless: loop !== 0,
      movesCage, movesCamera, movesLook, turns, movesMap };
  }

  /** The frame that is drawn from now on, below 0 the entry at rest. @param {number} frame @param {boolean} follows the keys of
   *   the camera set it */
  show(frame, follows) {
    this.calls.barycage_moment(this.self, frame, follows ? 1 : 0);
  }

  /** @returns {Shown} */
  shown() {
    const d = this.dimension, length = d * (d + 1) + 1, rows = this.maps * length, corners = this.corners * d, camera = 14;
    const at = this.numbers(Array(rows + corners + camera).fill(0));
    const isSet = this.calls.barycage_shown(this.self, at, at + 8 * rows, at + 8 * (rows + corners));
    const all = this.read(at, rows + corners + camera);
    return { rows: points(all.slice(0, rows), length).map((row) => row.map((x) => (Number.isNaN(x) ? null : x))),
      corners: points(all.slice(rows, rows + corners), d), camera: isSet ? all.slice(-camera) : null };
  }

  /** The box of what is shown. @returns {number[] | null} */
  reach() {
    const at = this.numbers(Array(2 * this.dimension + 1).fill(0));
    return this.calls.barycage_reach(this.self, at) ? this.read(at, 2 * this.dimension) : null;
  }

  /** The row at rest of a map as it is shown. @param {number} map @param {Row} row @returns {Row} */
  still(map, row) {
    const at = this.numbers(row);
    this.calls.barycage_still(this.self, map, at);
    return this.read(at, row.length).map((x) => (Number.isNaN(x) ? null : x));
  }

  /** @param {Appearance} given */
  setAppearance(given) {
    this.appearance = given;
    this.calls.barycage_appearance(this.self, this.numbers([given.colourBy ?? 0, given.brightness ?? 20,
      given.gamma ?? 2.2, given.contrast ?? 1, given.vibrancy ?? 1, given.supersample ?? 1,
      ...(given.plain ?? standardPlain), ...(given.background ?? standardBackground)]));
    const stops = given.stops ?? this.palettes()[0].stops;
    this.calls.barycage_stops(this.self, this.numbers(stops.flat()), stops.length);
    for (const [map, colour] of given.mapColours ?? [])
      this.calls.barycage_map_colour(this.self, map, this.numbers(colour));
    for (const [map, coordinate, speed] of given.mapBlends ?? [])
      this.calls.barycage_map_blend(this.self, map, coordinate, speed);
  }

  /** @param {Point[]} rest @param {Point[]} current @param {boolean} bends */
  setCage(rest, current, bends) {
    const flat = [...rest.flat(), ...current.flat()];
    const at = this.numbers(flat);
    this.corners = this.calls.barycage_cage(this.self, at, at + 4 * flat.length, rest.length, bends ? 1 : 0) ? rest.length : 0;
  }

  /** @param {number} width @param {number} height @param {number[]} view as barycage_camera() has it */
  setCamera(width, height, view) {
    this.size = { width, height };
    this.calls.barycage_camera(this.self, width, height, this.numbers(view));
    if (this.dimension === 2) this.calls.barycage_turn(this.self, view[3] ?? 0, view[4] ? 1 : 0);
  }

  /** @param {number} samples @param {boolean} begin @param {boolean} keepExposure
   * @returns {number} how many points are drawn */
  draw(samples, begin, keepExposure) {
    return this.calls.barycage_draw(this.self, samples, begin ? 1 : 0, keepExposure ? 1 : 0);
  }

  /** A copy of the picture, RGBA. @returns {Uint8ClampedArray<ArrayBuffer>} */
  pixels() {
    const at = this.calls.barycage_pixels(this.self);
    const bytes = new Uint8ClampedArray(4 * this.size.width * this.size.height);
    bytes.set(new Uint8Array(this.calls.memory.buffer, at, bytes.length));
    return bytes;
  }

  hash() {
    const half = (/** @type {number} */ high) =>
      (this.calls.barycage_hash(this.self, high) >>> 0).toString(16).padStart(8, "0");
    return half(1) + half(0);
  }

  /** @returns {Palette[]} */
  palettes() {
    return Array.from({ length: this.calls.barycage_palettes() }, (_, i) => {
      const at = this.numbers(Array(5 * 64).fill(0));
      const count = this.calls.barycage_palette_stops(i, at);
      return { name: this.text(this.calls.barycage_palette_name(i)), stops: points(this.read(at, 5 * count), 5) };
    });
  }

  /** Where these numbers stand for the next call. @param {(number | null)[]} values @returns {number} */
  numbers(values) {
    const bytes = 8 * values.length + 512; // and a word of a branch
    if (bytes > this.room) {
      if (this.buffer) this.calls.free(this.buffer);
      this.buffer = this.calls.malloc(bytes);
      this.room = bytes;
    }
    new Float64Array(this.calls.memory.buffer, this.buffer, values.length).set(values.map((v) => v ?? NaN));
    return this.buffer;
  }

  /** @param {number} at @param {number} count */
  read(at, count) {
    return Array.from(new Float64Array(this.calls.memory.buffer, at, count));
  }

  /** @param {number} at */
  text(at) {
    const bytes = new Uint8Array(this.calls.memory.buffer, at);
    return new TextDecoder().decode(bytes.slice(0, bytes.indexOf(0)));
  }
}

/** @param {number[]} numbers @param {number} length @returns {number[][]} */
function points(numbers, length) {
  return Array.from({ length: numbers.length / length }, (_, i) => numbers.slice(i * length, (i + 1) * length));
}
