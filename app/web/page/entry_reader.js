// SPDX-License-Identifier: MIT
// Reads the text of an entry, as the program writes it: rows of numbers, and what its comment lines say of the picture.
// docs/formats.md describes them. Lines that are not understood are kept for those who save the entry.

/** @typedef {import("./engine.js").Entry} Entry */
/** @typedef {import("./engine.js").Palette} Palette */
/** @typedef {import("./geometry.js").Point} Point */

const mostMaps = 2000, mostLinked = 256, mostCorners = 64, mostStops = 4096, longestWord = 64;
const largest = 3.4028235e38;
const toneKeys = /** @type {const} */ (["brightness", "gamma", "contrast", "vibrancy"]);
const colourings = ["density", "map", "address", "plain", "blend"];
const looks = ["stone", "ink", "cloud", "x-ray", "depth", "normals"];
const solidColours = ["none", "map", "address", "height", "depth"];
const groups = ["", "mirror", "", "", "tetrahedral", "octahedral", "icosahedral"];

/** @param {string} text */
function numberIn(text) {
  const value = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(text) ? Number(text) : NaN;
  return Math.abs(value) <= largest ? value : NaN;
}

/** @param {string} text @returns {number[] | null} red, green, blue and alpha */
function colourIn(text) {
  const digits = text.match(/^#([0-9a-f]{6})([0-9a-f]{2})?$/i);
  return digits && [...(digits[1] + (digits[2] ?? "ff")).matchAll(/../g)].map(([two]) => parseInt(two, 16));
}

/** The list that stands there, a new one at first.
 * @template Key @template Value @param {Map<Key, Value[]>} lists @param {Key} key @returns {Value[]} */
function listAt(lists, key) {
  const list = lists.get(key) ?? [];
  lists.set(key, list);
  return list;
}

/** What comment lines say, by key: the values of each line, and a list for each key.
 * @param {string[]} lines */
function byKey(lines) {
  /** @type {Map<string, string[][]>} */
  const found = new Map();
  for (const line of lines) {
    const [key, ...values] = (line.match(/^;\s*barycage:\s*(.*)$/)?.[1] ?? "").split(/\s+/);
    if (key) listAt(found, key).push(values);
  }
  return found;
}

/** Points, some of which are on several lines, the first ones of which end with a backslash.
 * @param {string[][]} lines @param {number} dimension @returns {Point[] | null} */
function pointsIn(lines, dimension) {
  /** @type {Point[]} */
  const points = [];
  let isOpen = false;
  for (const values of lines) {
    const continues = isOpen;
    isOpen = values.at(-1) === "\\";
    const numbers = values.slice(0, isOpen ? -1 : undefined).map(numberIn);
    if (continues) points[points.length - 1].push(...numbers);
    else points.push(numbers);
  }
  return points.every((p) => p.length === dimension && p.every(Number.isFinite)) ? points : null;
}

/** @param {string[]} rows @param {number} dimension @returns {(number | null)[][] | null} */
function mapsIn(rows, dimension) {
  const length = dimension * (dimension + 1);
  const lines = rows.map((row) => row.split(/[\s,]+/).filter(Boolean));
  const numbers = lines.flat().map(numberIn);
  const isWeighted = numbers.length % (length + 1) === 0 && !(lines.length > 1 && lines.every((line) => line.length === length));
  const step = isWeighted ? length + 1 : length;
  const count = numbers.length / step;
  if (!Number.isInteger(count) || count < 1 || count > mostMaps || !numbers.every(Number.isFinite)) return null;
  return Array.from({ length: count }, (_, i) => {
    const row = numbers.slice(i * step, (i + 1) * step);
    return isWeighted ? [...row.slice(0, length), Math.max(row[length], 0)] : [...row, null];
  });
}

/** Weights that rows cannot hold, and colours of maps.
 * @param {Entry} entry @param {Map<string, string[][]>} keys */
function readMapLines(entry, keys) {
  const at = entry.dimension * (entry.dimension + 1);
  const mapIn = (/** @type {string} */ text) => entry.maps[Number(text) - 1];
  for (const [map] of keys.get("unweighted") ?? [])
    for (const row of map === "all" ? entry.maps : [mapIn(map)].filter(Boolean)) row[at] = null;
  for (const [map, weight] of keys.get("weight") ?? [])
    if (mapIn(map) && numberIn(weight) > 0) mapIn(map)[at] = numberIn(weight);
  for (const [map] of keys.get("off") ?? []) if (mapIn(map)) mapIn(map)[at] = 0;
  /** @type {[number, number[]][]} */
  const mapColours = [];
  for (const [map, colour] of keys.get("map-colour") ?? []) {
    const read = colourIn(colour ?? "");
    if (mapIn(map) && read) mapColours.push([Number(map) - 1, read]);
  }
  /** @type {Map<number, number[]>} */
  const blends = new Map();
  for (const [map, ...values] of keys.get("map-blend") ?? [])
    if (mapIn(map)) listAt(blends, Number(map) - 1).push(...values.map(numberIn));
  /** @type {[number, number, number][]} */
  const mapBlends = [...blends].map(([map, [coordinate, speed = 0.5]]) => [map, coordinate, speed]);
  const isShare = (/** @type {number} */ x) => x >= 0 && x <= 1;
  entry.appearance = { ...entry.appearance, mapColours,
    mapBlends: mapBlends.filter(([, coordinate, speed]) => isShare(coordinate) && isShare(speed)) };
}

/** @param {Map<string, string[][]>} keys @param {Palette[]} palettes @returns {import("./engine.js").Appearance} */
function appearanceIn(keys, palettes) {
  const last = (/** @type {string} */ key) => keys.get(key)?.at(-1) ?? [];
  const number = (/** @type {string} */ key) => numberIn(last(key)[0] ?? "");
  /** @type {import("./engine.js").Appearance} */
  const appearance = { colourBy: Math.max(0, colourings.indexOf(last("colour-by")[0])) };
  for (const key of toneKeys)
    if (number(key) > 0 || (key === "vibrancy" && number(key) === 0)) appearance[key] = number(key);
  if (appearance.vibrancy !== undefined) appearance.vibrancy = Math.min(appearance.vibrancy, 1);
  if ([1, 2, 3, 4].includes(number("supersample"))) appearance.supersample = number("supersample");
  for (const key of /** @type {const} */ (["plain", "background"])) appearance[key] = colourIn(last(key)[0] ?? "") ?? undefined;
  const stops = (keys.get("stop") ?? []).slice(0, mostStops).map(([at, colour]) =>
    [numberIn(at), ...(colourIn(colour ?? "") ?? [NaN])]);
  const isGradient = stops.length >= 2 && stops.every((stop, i) => stop.every(Number.isFinite) && stop[0] >= (stops[i - 1]?.[0] ?? 0)
    && stop[0] <= 1);
  const given = last("palette").join(" ").toLowerCase();
  const named = palettes.find(({ name }) => name.toLowerCase() === given);
  appearance.stops = isGradient ? stops : (named ?? palettes[0]).stops;
  return appearance;
}

/** @param {Map<string, string[][]>} keys @param {number} colourBy @returns {import("./engine.js").Solid} */
function solidIn(keys, colourBy) {
  const last = (/** @type {string} */ key) => keys.get(key)?.at(-1) ?? [];
  const light = last("light").map(numberIn), fog = numberIn(last("fog")[0] ?? "");
  const clip = [...(keys.get("clip-normal") ?? []).flat().map(numberIn),
    ...(keys.get("clip-range") ?? []).flat().map((x) => (x === "-" ? null : numberIn(x)))];
  const isClipped = clip.length === 5 && clip.every((x) => x === null || Number.isFinite(x));
  const ownColour = solidColours.indexOf(last("solid-colour")[0]);
  return { look: Math.max(0, looks.indexOf(last("space-look")[0])), colour: ownColour >= 0 ? ownColour : colourBy === 1 ? 1 : 0,
    light: light.length === 2 && light.every(Number.isFinite) ? light : [-40, 40],
    fog: fog >= 0 && fog <= 100 ? fog : 0, ...(isClipped ? { clip } : {}) };
}

/** @param {Map<string, string[][]>} keys @param {number} dimension @returns {Entry["symmetry"]} */
function symmetryIn(keys, dimension) {
  const [name, angleText] = (keys.get("symmetry")?.[0]?.[0] ?? "").toLowerCase().split(":");
  const turned = name.match(/^([cd])(\d+)$/);
  const group = turned ? (turned[1] === "c" ? 2 : 3) : groups.indexOf(name);
  const order = turned ? Number(turned[2]) : 1, angle = angleText === undefined ? 0 : numberIn(angleText);
  if (!name || group < 1 || (turned && (order < 2 || order > 24)) || (group > 3 && dimension === 2) || !Number.isFinite(angle))
    return undefined;
  const given = (/** @type {string} */ key) => (keys.get(key) ?? []).flat().map(numberIn);
  const all = Array.from({ length: dimension * dimension }, (_, i) => (i % (dimension + 1) === 0 ? 1 : 0));
  const centre = given("symmetry-centre"), frame = given("symmetry-frame");
  return { group, order, angle, centre: centre.length === dimension ? centre : Array(dimension).fill(0),
    frame: frame.length === all.length ? frame : all };
}

/** @param {Map<string, string[][]>} keys @param {number} count @returns {number[][] | undefined} */
function linksIn(keys, count) {
  const lines = keys.get("links");
  if (!lines || count > mostLinked) return undefined;
  /** @type {Map<number, number[]>} */
  const rows = new Map();
  for (const [map, ...values] of lines) listAt(rows, Number(map)).push(...values.map(numberIn));
  const isValid = [...rows].every(([map, row]) => map >= 1 && map <= count && row.length === count && row.every((x) => x >= 0));
  return isValid ? Array.from({ length: count }, (_, i) => rows.get(i + 1) ?? Array(count).fill(1)) : undefined;
}

/** The branches that are shown elsewhere; null where one of them changes inside itself, which only the program knows.
 * @param {string[]} lines @param {number} dimension @param {number} count @returns {Entry["branches"] | null} */
function branchesIn(lines, dimension, count) {
  /** @type {{word: number[], by: string[][]}[]} */
  const found = [];
  for (const line of lines) {
    const [, key, text] = line.match(/^;\s*barycage:\s*(branch|by)\s+(.*)$/) ?? [];
    const values = (text ?? "").split(/\s+/);
    if (key === "branch") {
      if (found.length === 0 || found[found.length - 1].by.length > 0) found.push({ word: [], by: [] });
      found[found.length - 1].word.push(...values.map(Number));
    } else if (key === "by") found.at(-1)?.by.push(values);
  }
  if (found.some(({ word }) => word[0] === 0)) return null;
  return found.flatMap(({ word, by }) => {
    const points = pointsIn(by, dimension);
    const isKnown = word.length <= longestWord && word.every((map) => Number.isInteger(map) && map >= 1 && map <= count);
    return points?.length === dimension + 1 && isKnown ? [{ word: word.map((map) => map - 1), change: points.flat() }] : [];
  });
}

/** @param {string} text @param {Palette[]} palettes
 * @returns {{entry: Entry} | {flaw: "linkDamaged" | "linkForeign"}} */
export function readEntry(text, palettes) {
  const begin = text.match(/^(?:\s*;[^\n]*\n|\s*\n)*([^{;\n]*)\{/);
  const end = text.lastIndexOf("}");
  if (!begin || end < begin[0].length) return { flaw: "linkDamaged" };
  const heading = begin[1].match(/^\s*(.*?)\s*(\(3d\))?\s*$/i) ?? [];
  const dimension = heading[2] ? 3 : 2;
  const remark = text.slice(begin[0].length).match(/^[ \t]*;[^\n]*/)?.[0] ?? "";
  const body = text.slice(begin[0].length + remark.length, end).split("\n").map((line) => line.trim()).filter(Boolean);
  const comments = body.filter((line) => line.startsWith(";"));
  const rows = body.filter((line) => !line.startsWith(";")).map((line) => line.replace(/;.*/, "").trim());
  const maps = mapsIn(rows, dimension);
  if (!maps) return { flaw: rows.length > mostMaps ? "linkForeign" : "linkDamaged" };
  const keys = byKey(comments), branches = branchesIn(comments, dimension, maps.length);
  if (!branches) return { flaw: "linkForeign" };
  /** @type {Entry} */
  const entry = { name: heading[1] ?? "", dimension, maps, branches, appearance: appearanceIn(keys, palettes),
    links: dimension === 2 ? linksIn(keys, maps.length) : undefined, symmetry: symmetryIn(keys, dimension),
    text: { begin: `${begin[1].trim()} {${remark}`, rows, lines: comments.filter((line) => !/^;\s*barycage:\s*(rest|current)\s/.test(line)) } };
  readMapLines(entry, keys);
  if (dimension === 3) entry.solid = solidIn(keys, entry.appearance?.colourBy ?? 0);
  const rest = pointsIn(keys.get("rest") ?? [], dimension), current = pointsIn(keys.get("current") ?? [], dimension);
  if (rest && current && rest.length === current.length && rest.length > dimension && rest.length <= mostCorners)
    entry.cage = { rest, current, bends: keys.get("deformation")?.at(-1)?.[0] !== "affine-fit" };
  return { entry };
}
