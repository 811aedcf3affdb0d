// SPDX-License-Identifier: MIT
// Points, cameras and drags, without a document: y is up in the world and down on the screen.

/** @typedef {number[]} Point two or three coordinates */
/** @typedef {{width: number, height: number}} Size in pixels of the page */
/** @typedef {{centre: Point, scale: number}} PlaneView pixels per unit */
/** @typedef {{target: Point, azimuth: number, elevation: number, height: number, field: number}} SpaceView */

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

/** @param {PlaneView} view @param {Size} size @param {Point} point @returns {Point} */
export function toPixel(view, size, point) {
  return [size.width / 2 + (point[0] - view.centre[0]) * view.scale,
    size.height / 2 - (point[1] - view.centre[1]) * view.scale];
}

/** @param {PlaneView} view @param {Size} size @param {Point} pixel @returns {Point} */
export function toWorld(view, size, pixel) {
  return [view.centre[0] + (pixel[0] - size.width / 2) / view.scale,
    view.centre[1] + (size.height / 2 - pixel[1]) / view.scale];
}

/** All points with a margin, given as a part of the picture.
 * @param {Point[]} points @param {Size} size @param {number} margin @returns {PlaneView} */
export function fitted(points, size, margin) {
  const xs = points.map((p) => p[0]), ys = points.map((p) => p[1]);
  const low = [Math.min(...xs), Math.min(...ys)], high = [Math.max(...xs), Math.max(...ys)];
  const room = 1 - 2 * margin;
  const scale = Math.min((room * size.width) / (high[0] - low[0]), (room * size.height) / (high[1] - low[1]));
  return { centre: [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2],
    scale: Number.isFinite(scale) && scale > 0 ? scale : 100 };
}

/** Zoomed by a factor; what is under the pixel stays there.
 * @param {PlaneView} view @param {Size} size @param {Point} pixel @param {number} factor @returns {PlaneView} */
export function zoomed(view, size, pixel, factor) {
  const scale = Math.min(Math.max(view.scale * factor, 1e-6), 1e12);
  const before = toWorld(view, size, pixel);
  const after = toWorld({ centre: view.centre, scale }, size, pixel);
  return { centre: plus(view.centre, minus(before, after)), scale };
}

/** The axes of a camera in space: to the right, up, and away from the eye.
 * @param {SpaceView} view @returns {[Point, Point, Point]} */
export function axes(view) {
  const a = (view.azimuth * Math.PI) / 180, e = (view.elevation * Math.PI) / 180;
  const towards = [Math.sin(a) * Math.cos(e), Math.sin(e), Math.cos(a) * Math.cos(e)];
  const right = [Math.cos(a), 0, -Math.sin(a)];
  const up = [-Math.sin(a) * Math.sin(e), Math.cos(e), -Math.cos(a) * Math.sin(e)];
  return [right, up, times(towards, -1)];
}

/** How many pixels a unit has at a depth behind the target.
 * @param {SpaceView} view @param {Size} size @param {number} depth */
function unitsToPixels(view, size, depth) {
  const scale = size.height / view.height;
  if (!(view.field > 0)) return scale;
  const distance = view.height / (2 * Math.tan((view.field * Math.PI) / 360));
  return distance + depth > 0 ? (scale * distance) / (distance + depth) : Infinity;
}

/** @param {SpaceView} view @param {Size} size @param {Point} point @returns {Point} */
export function toPixelInSpace(view, size, point) {
  const [right, up, away] = axes(view);
  const seen = minus(point, view.target);
  const scale = unitsToPixels(view, size, dot(seen, away));
  return [size.width / 2 + scale * dot(seen, right), size.height / 2 - scale * dot(seen, up)];
}

/** By how much a point has moved that follows the pointer in the plane of the screen.
 * @param {SpaceView} view @param {Size} size @param {Point} point @param {Point} pixels @returns {Point} */
export function offsetInSpace(view, size, point, pixels) {
  const [right, up, away] = axes(view);
  const scale = unitsToPixels(view, size, dot(minus(point, view.target), away));
  return plus(times(right, pixels[0] / scale), times(up, -pixels[1] / scale));
}

/** Seen from the same direction, all points with a margin, in a picture as wide as high.
 * @param {SpaceView} view @param {Point[]} points @param {number} margin as a part of the picture @returns {SpaceView} */
export function fittedInSpace(view, points, margin) {
  const [right, up] = axes(view);
  const of = (/** @type {(...values: number[]) => number} */ end) => [0, 1, 2].map((i) => end(...points.map((p) => p[i])));
  const target = middle([of(Math.min), of(Math.max)]);
  const reach = Math.max(...points.flatMap((p) => [right, up].map((axis) => Math.abs(dot(minus(p, target), axis)))));
  return { ...view, target, height: reach > 0 ? (2 * reach) / (1 - 2 * margin) : view.height };
}

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

/** @typedef {"vertex" | "edge" | "inside"} Part */

/** What of a cage is under the pointer: a corner before an edge before the inside.
 * @param {Point[]} corners in pixels @param {Point} p @param {number} reach in pixels
 * @returns {{part: Part, index: number} | null} */
export function partAt(corners, p, reach) {
  const distances = corners.map((c) => Math.hypot(c[0] - p[0], c[1] - p[1]));
  const nearest = distances.indexOf(Math.min(...distances));
  if (distances[nearest] <= reach) return { part: "vertex", index: nearest };
  const edges = corners.map((c, i) => distanceToSegment(p, c, corners[(i + 1) % corners.length]));
  const edge = edges.indexOf(Math.min(...edges));
  if (edges[edge] <= reach / 2) return { part: "edge", index: edge };
  return isInside(p, corners) ? { part: "inside", index: 0 } : null;
}

/** @typedef {"move" | "rotate" | "scale"} Mode */

/** The vertices after a drag from one point of the plane to another. Constrained: along one axis, in steps of 15°,
 * or by the same factor in both directions… as in the program.
 * @param {Point[]} vertices those at the press @param {number[]} moving indices @param {Mode} mode
 * @param {Point} from @param {Point} to @param {boolean} isConstrained @returns {Point[]} */
export function dragged(vertices, moving, mode, from, to, isConstrained) {
  const pivot = middle(vertices);
  /** @type {(p: Point) => Point} */
  let change;
  if (mode === "rotate") {
    const turn = Math.atan2(to[1] - pivot[1], to[0] - pivot[0]) - Math.atan2(from[1] - pivot[1], from[0] - pivot[0]);
    const angle = isConstrained ? (Math.round(turn / (Math.PI / 12)) * Math.PI) / 12 : turn;
    const c = Math.cos(angle), s = Math.sin(angle);
    change = (p) => [pivot[0] + c * (p[0] - pivot[0]) - s * (p[1] - pivot[1]),
      pivot[1] + s * (p[0] - pivot[0]) + c * (p[1] - pivot[1])];
  } else if (mode === "scale") {
    const before = minus(from, pivot), after = minus(to, pivot);
    const factor = dot(before, before) > 0 ? dot(after, before) / dot(before, before) : 1;
    const isAlongX = Math.abs(before[0]) > Math.abs(before[1]);
    const factors = isConstrained ? (isAlongX ? [factor, 1] : [1, factor]) : [factor, factor];
    change = (p) => [pivot[0] + factors[0] * (p[0] - pivot[0]), pivot[1] + factors[1] * (p[1] - pivot[1])];
  } else {
    const offset = minus(to, from);
    if (isConstrained) offset[Math.abs(offset[0]) > Math.abs(offset[1]) ? 1 : 0] = 0;
    change = (p) => plus(p, offset);
  }
  return vertices.map((v, i) => (moving.includes(i) ? change(v) : v));
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

/** @param {(number | null)[]} row of a map @param {Point} point @returns {Point} its image */
export function image(row, point) {
  const m = /** @type {number[]} */ (row), d = point.length;
  return point.map((_, i) => dot(m.slice(i * d, i * d + d), point) + m[d * d + i]);
}

/** The row of a map whose images of a simplex are moved. Where all move alike, its matrix stays as it is.
 * @param {(number | null)[]} row @param {Point[]} simplex @param {Point[]} offsets */
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

/** Cramer's rule for two or three columns.
 * @param {Point[]} columns @param {Point} right @returns {number[]} */
function solved(columns, right) {
  /** @param {Point[]} m */
  const determinant = (m) => m.length === 2 ? m[0][0] * m[1][1] - m[0][1] * m[1][0]
    : m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[1][0] * (m[0][1] * m[2][2] - m[0][2] * m[2][1])
      + m[2][0] * (m[0][1] * m[1][2] - m[0][2] * m[1][1]);
  const all = determinant(columns);
  return columns.map((_, i) => determinant(columns.map((c, k) => (k === i ? right : c))) / all);
}
