// SPDX-License-Identifier: MIT
// Reads the text of an entry, as the program writes it: rows of numbers, and what its comment lines say of the picture.
// docs/formats.md describes them. Lines that are not understood are kept for those who save the entry.

const mostMaps = 2000, mostLinked = 256, mostCorners = 64, mostStops = 4096, longestWord = 64;
const largest = 3.4028235e38;
const toneKeys = /** @type {const} */ (["brightness", "gamma", "contrast", "vibrancy"]);
const colourings = ["density", "map", "address", "plain", "blend"];
const looks = ["stone", "ink", "cloud", "x-ray", "depth", "normals"];
const solidColours = ["none", "map", "address", "height", "depth"];
const groups = ["", "mirror", "", "", "tetrahedral", "octahedral", "icosahedral"];

/** @param {string} [text] */
function numberIn(text = "") {
  const value = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(text) ? Number(text) : NaN;
  return Math.abs(value) <= largest ? value : NaN;
}

/** @param {string} [text] @returns {number[] | undefined} red, green, blue and alpha */
function colourIn(text = "") {
  const digits = text.match(/^#([0-9a-f]{6})([0-9a-f]{2})?$/i);
  return digits ? [...(digits[1] + (digits[2] ?? "ff")).matchAll(/../g)].map(([two]) => parseInt(two, 16)) : undefined;
}

/** Comment lines by their keys: the words behind them. */
class Remarks {
  /** @param {string[]} lines */
  constructor(lines) {
    /** @type {string[][]} */
    this.lines = lines.map((line) => (line.match(/^;\s*barycage:\s*(.*)$/)?.[1] ?? "").split(/\s+/));
  }

  /** @param {string} key @returns {string[][]} */
  all(key) {
    return this.lines.filter(([first]) => first === key).map(([, ...words]) => words);
  }

  /** The words of the last line, which counts. @param {string} key */
  last(key) {
    return this.all(key).at(-1) ?? [];
  }

  /** @param {string} key */
  number(key) {
    return numberIn(this.last(key)[0]);
  }

  /** Lists of numbers that belong to maps, each of which may be on several lines. @param {string} key */
  byMap(key) {
    const lists = /** @type {Map<number, number[]>} */ (new Map());
    for (const [map, ...words] of this.all(key))
      lists.set(Number(map) - 1, [...(lists.get(Number(map) - 1) ?? []), ...words.map(numberIn)]);
    return lists;
  }
}

/** Points, some of which are on several lines, the first ones of which end with a backslash.
 * @param {string[][]} lines @param {number} dimension @returns {Point[] | null} null where there is none, too */
function pointsIn(lines, dimension) {
  const text = lines.map((words) => words.join(" ")).join("\n").replace(/\\\n/g, "");
  const points = text.split("\n").map((line) => line.split(/\s+/).map(numberIn));
  return points.every((p) => p.length === dimension && p.every(Number.isFinite)) ? points : null;
}

/** @param {string[]} rows @param {number} dimension @returns {Row[] | null} */
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

/** Gives maps the weights that rows cannot hold.
 * @param {Row[]} maps @param {number} at which number of a row the weight is @param {Remarks} remarks */
function weigh(maps, at, remarks) {
  const rowsOf = (/** @type {string} */ map) => maps.filter((_, i) => i + 1 === Number(map));
  for (const [map] of remarks.all("unweighted"))
    for (const row of map === "all" ? maps : rowsOf(map)) row[at] = null;
  for (const [map, weight] of remarks.all("weight"))
    if (numberIn(weight) > 0) for (const row of rowsOf(map)) row[at] = numberIn(weight);
  for (const [map] of remarks.all("off"))
    for (const row of rowsOf(map)) row[at] = 0;
}

/** @param {Remarks} remarks @param {number} count of maps @param {Palette[]} palettes @returns {Appearance} */
function appearanceIn(remarks, count, palettes) {
  const appearance = /** @type {Appearance} */ ({ colourBy: Math.max(0, colourings.indexOf(remarks.last("colour-by")[0])) });
  for (const key of toneKeys) {
    const number = remarks.number(key);
    if (number > 0 || (key === "vibrancy" && number === 0)) appearance[key] = key === "vibrancy" ? Math.min(number, 1) : number;
  }
  if ([1, 2, 3, 4].includes(remarks.number("supersample"))) appearance.supersample = remarks.number("supersample");
  for (const key of /** @type {const} */ (["plain", "background"])) appearance[key] = colourIn(remarks.last(key)[0]);
  const stops = remarks.all("stop").slice(0, mostStops).map(([at, colour]) => [numberIn(at), ...(colourIn(colour) ?? [NaN])]);
  const isGradient = stops.length >= 2 && stops.every((stop, i) => stop.every(Number.isFinite) && stop[0] >= (stops[i - 1]?.[0] ?? 0)
    && stop[0] <= 1);
  const given = remarks.last("palette").join(" ").toLowerCase();
  const named = palettes.find(({ name }) => name.toLowerCase() === given) ?? palettes[0];
  appearance.stops = isGradient ? stops : named.stops;
  appearance.mapColours = [];
  for (const [map, text] of remarks.all("map-colour")) {
    const index = Number(map) - 1, colour = colourIn(text);
    if (colour && index >= 0 && index < count) appearance.mapColours.push([index, colour]);
  }
  appearance.mapBlends = [];
  for (const [map, [coordinate, speed = 0.5]] of remarks.byMap("map-blend"))
    if (map >= 0 && map < count && [coordinate, speed].every((x) => x >= 0 && x <= 1))
      appearance.mapBlends.push([map, coordinate, speed]);
  return appearance;
}

/** @param {Remarks} remarks @param {number} [colourBy] @returns {Solid} */
function solidIn(remarks, colourBy) {
  const light = remarks.last("light").map(numberIn), fog = remarks.number("fog");
  const normal = remarks.all("clip-normal").flat().map(numberIn);
  const range = remarks.all("clip-range").flat().map((word) => (word === "-" ? null : numberIn(word)));
  const isClipped = normal.length === 3 && range.length === 2 && normal.every(Number.isFinite)
    && range.every((x) => x === null || Number.isFinite(x));
  const ownColour = solidColours.indexOf(remarks.last("solid-colour")[0]);
  return { look: Math.max(0, looks.indexOf(remarks.last("space-look")[0])), colour: ownColour >= 0 ? ownColour : colourBy === 1 ? 1 : 0,
    light: light.length === 2 && light.every(Number.isFinite) ? light : [-40, 40],
    fog: fog >= 0 && fog <= 100 ? fog : 0, ...(isClipped ? { clip: [...normal, ...range] } : {}) };
}

/** @param {Remarks} remarks @param {number} dimension @returns {Entry["symmetry"]} */
function symmetryIn(remarks, dimension) {
  const [name, angleText = "0"] = (remarks.all("symmetry")[0]?.[0] ?? "").toLowerCase().split(":");
  const turned = name.match(/^([cd])(\d+)$/);
  const group = turned ? (turned[1] === "c" ? 2 : 3) : groups.indexOf(name);
  const order = turned ? Number(turned[2]) : 1, angle = numberIn(angleText);
  if (!name || group < 1 || (turned && (order < 2 || order > 24)) || (group > 3 && dimension === 2) || !Number.isFinite(angle))
    return undefined;
  const unit = Array.from({ length: dimension * dimension }, (_, i) => (i % (dimension + 1) === 0 ? 1 : 0));
  const given = (/** @type {string} */ key, /** @type {number[]} */ usual) => {
    const numbers = remarks.all(key).flat().map(numberIn);
    return numbers.length === usual.length ? numbers : usual;
  };
  return { group, order, angle, centre: given("symmetry-centre", Array(dimension).fill(0)), frame: given("symmetry-frame", unit) };
}

/** @param {Remarks} remarks @param {number} count of maps @returns {number[][] | undefined} */
function linksIn(remarks, count) {
  const rows = remarks.byMap("links");
  const isValid = [...rows].every(([map, row]) => map >= 0 && map < count && row.length === count && row.every((x) => x >= 0));
  if (rows.size === 0 || count > mostLinked || !isValid) return undefined;
  return Array.from({ length: count }, (_, i) => rows.get(i) ?? Array(count).fill(1));
}

/** The branches that are shown elsewhere; null where one of them changes inside itself, which only the program knows.
 * @param {Remarks} remarks @param {number} dimension @param {number} count of maps @returns {Entry["branches"] | null} */
function branchesIn(remarks, dimension, count) {
  const found = /** @type {{word: number[], by: string[][]}[]} */ ([]);
  for (const [key, ...words] of remarks.lines) {
    if (key === "branch" && found.at(-1)?.by.length !== 0) found.push({ word: [], by: [] });
    if (key === "branch") found.at(-1)?.word.push(...words.map(Number));
    else if (key === "by") found.at(-1)?.by.push(words);
  }
  if (found.some(({ word }) => word[0] === 0)) return null;
  return found.flatMap(({ word, by }) => {
    const points = pointsIn(by, dimension);
    const isKnown = word.length <= longestWord && word.every((map) => Number.isInteger(map) && map >= 1 && map <= count);
    return points?.length === dimension + 1 && isKnown ? [{ word: word.map((map) => map - 1), change: points.flat() }] : [];
  });
}

/** @param {Remarks} remarks @param {number} dimension @returns {Entry["cage"]} */
function cageIn(remarks, dimension) {
  const rest = pointsIn(remarks.all("rest"), dimension), current = pointsIn(remarks.all("current"), dimension);
  if (!rest || rest.length !== current?.length || rest.length <= dimension || rest.length > mostCorners) return undefined;
  return { rest, current, bends: remarks.last("deformation")[0] !== "affine-fit" };
}

/** @param {string} text @param {Palette[]} palettes @returns {{entry: Entry} | {flaw: "linkDamaged" | "linkForeign"}} */
export function readEntry(text, palettes) {
  const begin = text.match(/^(?:\s*;[^\n]*\n|\s*\n)*([^{;\n]*)\{/);
  const end = text.lastIndexOf("}");
  if (!begin || end < begin[0].length) return { flaw: "linkDamaged" };
  const [, name = "", mark] = begin[1].match(/^\s*(.*?)\s*(\(3d\))?\s*$/i) ?? [];
  const dimension = mark ? 3 : 2;
  const remark = text.slice(begin[0].length).match(/^[ \t]*;[^\n]*/)?.[0] ?? "";
  const body = text.slice(begin[0].length + remark.length, end).split("\n").map((line) => line.trim()).filter(Boolean);
  const comments = body.filter((line) => line.startsWith(";"));
  const rows = body.filter((line) => !line.startsWith(";")).map((line) => line.replace(/;.*/, "").trim());
  const maps = mapsIn(rows, dimension);
  if (!maps) return { flaw: rows.length > mostMaps ? "linkForeign" : "linkDamaged" };
  const remarks = new Remarks(comments), branches = branchesIn(remarks, dimension, maps.length);
  if (!branches) return { flaw: "linkForeign" };
  weigh(maps, dimension * (dimension + 1), remarks);
  const appearance = appearanceIn(remarks, maps.length, palettes);
  const lines = comments.filter((line) => !/^;\s*barycage:\s*(rest|current)\s/.test(line));
  return { entry: { name, dimension, maps, branches, appearance, links: dimension === 2 ? linksIn(remarks, maps.length) : undefined,
    symmetry: symmetryIn(remarks, dimension), cage: cageIn(remarks, dimension),
    solid: dimension === 3 ? solidIn(remarks, appearance.colourBy) : undefined,
    text: { begin: `${begin[1].trim()} {${remark}`, rows, lines } } };
}
