// SPDX-License-Identifier: MIT
// Points and drags, without a document: y is up in the world and down on the screen.

/** @param {Point} a @param {Point} b @returns {Point} */
export const plus = (a, b) => a.map((x, i) => x + b[i]);
/** @param {Point} a @param {Point} b @returns {Point} */
export const minus = (a, b) => a.map((x, i) => x - b[i]);
/** @param {Point} a @param {number} factor @returns {Point} */
export const times = (a, factor) => a.map((x) => x * factor);
/** @param {Point} a @param {Point} b */
export const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
/** @param {Point[]} points @returns {Point} */
export const middle = (points) => times(points.reduce(plus), 1 / points.length);

/** @param {Point} p @param {Point} a @param {Point} b distance of p from the segment ab */
export function distanceToSegment(p, a, b) {
  const along = minus(b, a);
  const length = dot(along, along);
  const share = length > 0 ? Math.min(Math.max(dot(minus(p, a), along) / length, 0), 1) : 0;
  const off = minus(p, plus(a, times(along, share)));
  return Math.hypot(off[0], off[1]);
}

/** @param {Point} p @param {Point[]} polygon */
export function isInside(p, polygon) {
  let inside = false;
  polygon.forEach((a, i) => {
    const b = polygon[(i + 1) % polygon.length];
    const crosses = a[1] > p[1] !== b[1] > p[1];
    if (crosses && p[0] < ((b[0] - a[0]) * (p[1] - a[1])) / (b[1] - a[1]) + a[0]) inside = !inside;
  });
  return inside;
}

/** The nearest edge within reach, by the index of its first corner; -1 where there is none.
 * @param {Point[]} corners @param {Point} p @param {number} reach */
export function edgeAt(corners, p, reach) {
  const distances = corners.map((c, i) => distanceToSegment(p, c, corners[(i + 1) % corners.length]));
  const least = Math.min(...distances);
  return least <= reach ? distances.indexOf(least) : -1;
}

/** The vertices after a drag from one point of the plane to another. Constrained: along one axis, in steps of 15°, or in one
 * direction, as in the program. @param {Point[]} vertices those at the press @param {number[]} moving indices @param {Mode} mode
 * @param {Point} from @param {Point} to @param {boolean} isConstrained */
export function dragged(vertices, moving, mode, from, to, isConstrained) {
  const changed = (/** @type {(vertex: Point) => Point} */ change) => vertices.map((v, i) => (moving.includes(i) ? change(v) : v));
  const isFlat = (/** @type {Point} */ [x, y]) => Math.abs(x) > Math.abs(y);
  if (mode === "move") {
    const offset = minus(to, from);
    if (isConstrained) offset[isFlat(offset) ? 1 : 0] = 0;
    return changed((v) => plus(v, offset));
  }
  const pivot = middle(vertices), before = minus(from, pivot), after = minus(to, pivot);
  const around = (/** @type {(p: Point) => Point} */ linear) => changed((v) => plus(pivot, linear(minus(v, pivot))));
  if (mode === "rotate") {
    const turn = Math.atan2(after[1], after[0]) - Math.atan2(before[1], before[0]), step = Math.PI / 12;
    const angle = isConstrained ? Math.round(turn / step) * step : turn;
    const c = Math.cos(angle), s = Math.sin(angle);
    return around(([x, y]) => [c * x - s * y, s * x + c * y]);
  }
  const factor = dot(before, before) > 0 ? dot(after, before) / dot(before, before) : 1;
  const kept = isConstrained ? (isFlat(before) ? 1 : 0) : -1;
  return around((p) => p.map((x, i) => (i === kept ? x : factor * x)));
}

/** The images of points under the affine map that takes one simplex to another.
 * @param {Point[]} from @param {Point[]} to @param {Point[]} points @returns {Point[]} */
export function carried(from, to, points) {
  const [o, ...ends] = from;
  const columns = ends.map((p) => minus(p, o));
  return points.map((p) => {
    const shares = solved(columns, minus(p, o));
    return shares.reduce((sum, share, i) => plus(sum, times(minus(to[i + 1], to[0]), share)), to[0]);
  });
}

/** The rows of the matrix of a map. @param {Row} map @param {number} dimension */
export function matrixOf(map, dimension) {
  const numbers = /** @type {number[]} */ (map);
  return Array.from({ length: dimension }, (_, i) => numbers.slice(i * dimension, (i + 1) * dimension));
}

/** @param {Row} map @param {Point} point @returns {Point} its image */
export function image(map, point) {
  const d = point.length;
  return matrixOf(map, d).map((row, i) => dot(row, point) + Number(map[d * d + i]));
}

/** The row of a map whose images of a simplex are moved. Where all move alike, its matrix stays as it is.
 * @param {Row} row @param {Point[]} simplex @param {Point[]} offsets */
export function withImagesMoved(row, simplex, offsets) {
  const m = /** @type {number[]} */ ([...row]), [origin, ...ends] = simplex, [first, ...others] = offsets, d = ends.length;
  const least = 1e-12 * Math.max(...offsets.flat().map(Math.abs));
  const apart = others.map((offset) => minus(offset, first).map((x) => (Math.abs(x) < least ? 0 : x)));
  const sides = ends.map((p) => minus(p, origin));
  first.forEach((_, column) => {
    const shares = solved(sides, first.map((_, i) => (i === column ? 1 : 0)));
    first.forEach((_, i) => {
      const slope = shares.reduce((sum, share, k) => sum + share * apart[k][i], 0);
      m[i * d + column] += slope;
      m[d * d + i] -= slope * origin[column];
    });
  });
  first.forEach((x, i) => (m[d * d + i] += x));
  return m;
}

/** Of two or three columns. @param {Point[]} columns @returns {number} */
export function determinant([a, b, c]) {
  if (!c) return a[0] * b[1] - a[1] * b[0];
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1]) + c[0] * (a[1] * b[2] - a[2] * b[1]);
}

/** Cramer's rule. @param {Point[]} columns @param {Point} right @returns {number[]} */
function solved(columns, right) {
  const all = determinant(columns);
  return columns.map((_, i) => determinant(columns.map((c, k) => (k === i ? right : c))) / all);
}
