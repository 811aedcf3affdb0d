// SPDX-License-Identifier: MIT
// An entry as a collection has it, with what has been dragged and typed.

import { determinant, matrixOf } from "./geometry.js";

/** The determinant rule, for rows whose maps have no weights. @param {Entry} entry @returns {number[]} */
function shares({ dimension, maps }) {
  const sum = (/** @type {number[]} */ list) => list.reduce((a, b) => a + b, 0);
  const sizes = maps.map((map) => Math.abs(determinant(matrixOf(map, dimension))));
  const floored = sizes.map((size) => (sum(sizes) > 0 ? Math.max(size, 0.01 * sum(sizes)) : 1));
  return floored.map((size) => size / sum(floored));
}

/** @param {Entry} entry @param {Point[]} rest @param {Point[]} current @param {boolean} isEdited whether maps have been
 * typed: their rows are written anew, and all others as the collection had them */
export function entryText(entry, rest, current, isEdited) {
  const { begin = `${entry.name} {`, lines = [], rows = [] } = entry.text ?? {};
  const isMoved = rest.some((p, i) => p.some((x, k) => x !== current[i][k]));
  const point = (/** @type {string} */ key) => (/** @type {Point} */ p) =>
    `; barycage: ${key} ${p.map((x) => (p.length === 3 ? Number(x.toPrecision(11)) : x)).join(" ")}`;
  const cage = entry.cage || isMoved ? [...rest.map(point("rest")), ...current.map(point("current"))] : [];
  const chosen = entry.palette === undefined ? [] : [`; barycage: palette ${entry.palette}`];
  const kept = chosen.length > 0 ? lines.filter((line) => !/^; barycage: (palette|stop)\b/.test(line)) : lines;
  const version = lines.length === 0 && cage.length + chosen.length > 0 ? ["; barycage: version 1"] : [];
  const at = entry.dimension * (entry.dimension + 1);
  const usual = entry.maps.some((map) => map[at] === null || map[at] === undefined) ? shares(entry) : [];
  const typed = entry.maps.map((map, i) => [...map.slice(0, at), usual[i] ?? map[at]].join(" "));
  return [begin, ...[...version, ...kept, ...chosen, ...cage, ...(isEdited || rows.length === 0 ? typed : rows)].map((l) => `  ${l}`),
    "}", ""].join("\n");
}
